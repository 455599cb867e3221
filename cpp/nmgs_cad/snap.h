// SPDX-License-Identifier: LGPL-2.1-or-later
// Puts the nodes of a structured mesh onto the CAD that its blocks were fitted to.
#pragma once

#include "nmgs/blocking/lattice.h"
#include "nmgs/support/progress.h"
#include "nmgs_cad/cad_blocks.h"
#include "nmgs_cad/cad_shape.h"

#include <span>

namespace nmgs::cad {

// Which nodes snap() moves: all, or not those inside blocks.
enum class SnapParts { all, boundary };

// points: what fill_points made for the lattice, changed in place. Nodes of bound corners go to the
// CAD's vertices, those of bound edges to the same fraction of the edge's length, those of bound
// faces to the nearest point of the face. What the boundary moved by is blended into free faces and
// into the blocks (transfinite interpolation; Gordon and Hall, 1973).
void snap(const CadShape &shape, const BlockModel &model, const CadBinding &binding,
          const Lattice &lattice, std::span<Vec3> points, const Progress &progress = {},
          double from = 0.0, double to = 1.0, SnapParts parts = SnapParts::all);

} // namespace nmgs::cad
