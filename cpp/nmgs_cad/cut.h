// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids that no other strategy fills as they are, cut into pieces that meet face to face.
#pragma once

#include "nmgs_cad/cut_proposals.h"
#include "nmgs_cad/layout_options.h"

#include <vector>

namespace nmgs::cad {

// The edges of the solid that stand in the way of blocks: concave, smooth or closed ones, and
// seams, in ascending order. Empty when none does, or when the solid's faces do not enclose it.
std::vector<int> obstacles(const CadShape &shape, int solid);

// Adds one proposed cut after the other, that which leaves fewest obstacles first, until every
// piece can be filled; see FillSolid.
bool fill_cut(const CadShape &shape, int solid, Layout &layout, const LayoutOptions &options,
              Refusal &refusal, const Progress &progress);

} // namespace nmgs::cad
