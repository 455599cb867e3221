// SPDX-License-Identifier: LGPL-2.1-or-later
// Generation of a structured mesh by isoparametric mapping (thesis 2.1.1.1, 2.3.1, 4.4.1, 4.5.1).
#pragma once

#include "nmgs/blocking/lattice.h"
#include "nmgs/mesh/mesh.h"
#include "nmgs/support/progress.h"

#include <span>

namespace nmgs {

struct GenerateOptions {
    double tolerance = -1; // for common nodes; negative: default_tolerance()
    bool force = false;    // mesh blocks with problems (see block_check.h) as they are
    bool improve = true;   // on CAD: better places for the nodes of bad cells
};

// Quads of patches, hexahedra of blocks; cells block by block, xi fastest, each in VTK's order.
// Nodes that coincide are one, by topology or by place. The numbers of nodes and cells are refused
// before memory is taken for them.
// Raises ArgumentError (see validate; also when the mesh cannot fit into memory or its node numbers
// not into 32 bits), BlockingError that names the blocks with problems, Cancelled.
Mesh generate(const BlockModel &model, const GenerateOptions &options = {},
              const Progress &progress = {});

// Raises BlockingError that names the blocks' pairs whose divisions or spacings disagree, if any.
void raise_conflicts(const BlockModel &model, const Topology &topology);

// The two halves of the above into memory that the caller owns; sizes are the lattice's.
void fill_points(const BlockModel &model, const Lattice &lattice, std::span<Vec3> points,
                 const Progress &progress = {}, double from = 0.0, double to = 1.0);
void fill_cells(const BlockModel &model, const Lattice &lattice, std::span<std::int32_t> cells,
                const Progress &progress = {}, double from = 0.0, double to = 1.0);

} // namespace nmgs
