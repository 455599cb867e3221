// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids that no other strategy fills as they are, cut into pieces that meet face to face.
#pragma once

#include "nmgs_cad/cut_proposals.h"
#include "nmgs_cad/layout_options.h"

#include <span>
#include <vector>

namespace nmgs::cad {

// The edges of the solid that stand in the way of blocks: concave, smooth or closed ones, and
// seams, in ascending order. Empty when none does, or when the solid's faces do not enclose it.
std::vector<int> obstacles(const CadShape &shape, int solid);

// Cuts solids that touch all at once, so that their pieces meet face to face. Adds one proposed cut
// after the other, that which leaves fewest obstacles first, until every piece can be filled. True,
// or false and the refusal, the layout as it was; it must have nothing on the solids yet.
bool cut_solids(const CadShape &shape, std::span<const int> solids, Layout &layout,
                const LayoutOptions &options, Refusal &refusal, const Progress &progress);

// The same for one solid; see FillSolid.
bool fill_cut(const CadShape &shape, int solid, Layout &layout, const LayoutOptions &options,
              Refusal &refusal, const Progress &progress);

} // namespace nmgs::cad
