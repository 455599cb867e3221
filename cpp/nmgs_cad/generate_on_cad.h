// SPDX-License-Identifier: LGPL-2.1-or-later
// Structured mesh of blocks that were fitted to CAD, its nodes on the CAD, its parts named.
#pragma once

#include "nmgs/blocking/generate.h"
#include "nmgs_cad/cad_blocks.h"
#include "nmgs_cad/cad_shape.h"

namespace nmgs::cad {

// order 1: quads, hexahedra; order 2: quad8, hexahedron20 with mid-side nodes on the CAD. Corner
// nodes come first and are numbered as by nmgs::generate; cells are ordered as there.
// A mesh of blocks also has the quads that lie on CAD faces, seen from outside of the first block.
// Groups: FaceN (quads), SolidN (hexahedra), EdgeN and VertexN (nodes).
// Where cells would be inside out with all nodes on the CAD, some nodes inside faces, never on
// edges or vertices, leave it as little as will do; off_cad gets their numbers, ascending. Raises
// what generate raises; ArgumentError when order is neither 1 nor 2.
Mesh generate_on_cad(const CadShape &shape, const CadBlocks &blocks, int order,
                     const GenerateOptions &options = {}, const Progress &progress = {},
                     std::vector<std::int32_t> *off_cad = nullptr);

} // namespace nmgs::cad
