// SPDX-License-Identifier: LGPL-2.1-or-later
// Tries a strategy with finer and finer layouts until the mesh is good enough.
#pragma once

#include "nmgs_cad/layout_options.h"
#include "nmgs_cad/layout_quality.h"

#include <functional>
#include <optional>

namespace nmgs::cad {

// Fills with the options as they are; while the worst scaled Jacobian of what comes of it is under
// `good`, again with shorter segments. The best of all is kept; its quality. Nothing, the layout as
// it was, and the refusal of the first try where none is any good.
std::optional<LayoutQuality>
fill_finer(const CadShape &shape, int solid, Layout &layout, const LayoutOptions &options,
           Refusal &refusal, const Progress &progress,
           const std::function<bool(Layout &, const LayoutOptions &, Refusal &)> &fill,
           double good = 0.3);

} // namespace nmgs::cad
