// SPDX-License-Identifier: LGPL-2.1-or-later
// Lines on the faces between pieces that the sweeps on both sides ask for.
#pragma once

#include "nmgs_cad/split.h"

#include <optional>

namespace nmgs::cad {

// A piece that is swept has nodes where its levels cross a face that runs along the sweep, and
// where its walls, carried on along the sweep, meet a face across it. The neighbour behind such a
// face does not know of these. The pieces with these lines drawn on the faces between them, which
// the neighbours carry on through themselves; nothing where there is nothing to draw.
std::optional<Pieces> imprint_sweeps(const CadShape &shape, const Pieces &pieces);

} // namespace nmgs::cad
