// SPDX-License-Identifier: LGPL-2.1-or-later
// The mapped strategy: a face with four sides is one patch, a solid with six such faces one block.
#pragma once

#include "nmgs_cad/cad_blocks.h"
#include "nmgs_cad/cad_shape.h"
#include "nmgs_cad/layout_options.h"

namespace nmgs::cad {

// Adds one 8-node patch for face n to blocks, its normal that of the face, and an entry to the
// report: with a reason and without a block when the face has not four sides. The fit's error is
// not measured here.
void fit_mapped_face(const CadShape &shape, int face, CadBlocks &blocks);

// One block for a solid with six such faces. xi, eta, zeta run along x, y, z as nearly as can be.
bool fill_mapped(const CadShape &shape, int solid, Layout &layout, const LayoutOptions &options,
                 Refusal &refusal, const Progress &progress);

} // namespace nmgs::cad
