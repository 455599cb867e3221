// SPDX-License-Identifier: LGPL-2.1-or-later
// The mid-point subdivision of solids: one hexahedron a vertex (Li, McKeag and Armstrong,
// Hexahedral meshing using midpoint subdivision and integer programming, 1995).
#pragma once

#include "nmgs_cad/layout_options.h"

namespace nmgs::cad {

// For solids in which three edges meet at each vertex and each face has one loop of two edges or
// more: tetrahedra, prisms, hexahedra and the like, flat or curved.
bool fill_midpoint(const CadShape &shape, int solid, Layout &layout, const LayoutOptions &options,
                   Refusal &refusal, const Progress &progress);

} // namespace nmgs::cad
