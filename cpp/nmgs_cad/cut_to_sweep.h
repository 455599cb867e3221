// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids cut into pieces that sweep in their own directions.
#pragma once

#include "nmgs_cad/layout_options.h"

namespace nmgs::cad {

// Cuts one piece after the other, each alone, by planes and cylinders through its concave edges and
// by boxes round what crosses a sweep, by that which leaves the least in the way of sweeping; then
// fills the pieces by what strategies there are. See FillSolid.
bool fill_cut_to_sweep(const CadShape &shape, int solid, Layout &layout,
                       const LayoutOptions &options, Refusal &refusal, const Progress &progress);

} // namespace nmgs::cad
