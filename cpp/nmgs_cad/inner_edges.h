// SPDX-License-Identifier: LGPL-2.1-or-later
// Edges inside solids, on none of their faces.
#pragma once

#include "nmgs_cad/skin.h"

namespace nmgs::cad {

// Edges (1-based) inside a solid, on none of its faces, ascending; not the degenerated ones.
std::vector<int> inner_edges(const CadShape &shape, int solid);

// Adds the edges inside each solid whose faces are all among these to the skin, as chains of points
// at most `size` apart between which the edge turns by `angle` at most; those that are closed have
// three segments or more. Their points belong to no triangle, but for vertices of the skin.
void add_inner_edges(const CadShape &shape, std::span<const int> faces, double size, double angle,
                     Skin &skin);

} // namespace nmgs::cad
