// SPDX-License-Identifier: LGPL-2.1-or-later
// Which solids touch.
#pragma once

#include "nmgs_cad/cad_shape.h"

#include <span>
#include <vector>

namespace nmgs::cad {

// Groups of solids that are joined by faces, edges or vertices which they share, directly or
// through others of the group: their meshes share nodes. Each ascending, ordered by their first
// solids.
std::vector<std::vector<int>> joined_solids(const CadShape &shape, std::span<const int> solids);

} // namespace nmgs::cad
