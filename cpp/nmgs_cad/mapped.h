// SPDX-License-Identifier: LGPL-2.1-or-later
// The mapped strategy: a face with four sides is one patch, a solid with six such faces one block.
#pragma once

#include "nmgs_cad/cad_blocks.h"
#include "nmgs_cad/cad_shape.h"

namespace nmgs::cad {

// Adds one 8-node patch for face n to blocks, its normal that of the face, and an entry to the
// report: with a reason and without a block when the face has not four sides. The fit's error is
// not measured here.
void fit_mapped_face(const CadShape &shape, int face, CadBlocks &blocks);

// The same for solid n and one 20-node block. xi, eta, zeta run along x, y, z as nearly as can be.
void fit_mapped_solid(const CadShape &shape, int solid, CadBlocks &blocks);

} // namespace nmgs::cad
