// SPDX-License-Identifier: LGPL-2.1-or-later
// Cuts off the tips of blocks that divisions would spoil.
#pragma once

#include "nmgs/support/progress.h"
#include "nmgs_cad/cad_blocks.h"
#include "nmgs_cad/cad_shape.h"

namespace nmgs::cad {

// Where two sides of a block leave a corner in the same direction, or in opposite ones (beside a
// tangent fillet, say), elements are the worse the smaller they are. Cuts the blocks along the
// whole chains through such corners, so far from them that a piece that is not divided is good
// there; default_divisions() does not divide it. Only where the divisions by default for elements
// of the given size would do worse, and as long as there are no more than most_blocks.
CadBlocks split_tips(const CadShape &shape, CadBlocks blocks, double size,
                     const Progress &progress = {}, std::size_t most_blocks = 4096);

} // namespace nmgs::cad
