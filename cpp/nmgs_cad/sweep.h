// SPDX-License-Identifier: LGPL-2.1-or-later
// Sweeping: a section laid out in quads and carried through a solid (Blacker, The Cooper Tool,
// 5th International Meshing Roundtable, 1996, where several sources and targets are in play).
#pragma once

#include "nmgs_cad/layout_options.h"

namespace nmgs::cad {

// For solids bounded by walls along a direction and plane caps across it, at any number of levels:
// extrusions, plates with bosses, pockets and holes, steps.
bool fill_sweep(const CadShape &shape, int solid, Layout &layout, const LayoutOptions &options,
                Refusal &refusal, const Progress &progress);

} // namespace nmgs::cad
