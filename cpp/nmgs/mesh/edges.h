// SPDX-License-Identifier: LGPL-2.1-or-later
// Every edge of a mesh once.
#pragma once

#include "nmgs/mesh/cell_topology.h"
#include "nmgs/support/progress.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace nmgs {

struct Edges {
    // End nodes of each edge, the lower first, in the order in which the cells first name them.
    std::vector<std::array<std::int32_t, 2>> ends;
    // Of each block of cells: edge numbers of cell c from c * edges(type).size() on.
    std::vector<Array<std::int32_t>> of_cells;
};

// Edges between corners; mid-side nodes are left out. Linear in the number of cells: the edges of a
// node's list are those where it is the lower end, a handful in any mesh.
// Raises ArgumentError when a cell's node is not in [0, points), or edge numbers exceed 32 bits.
Edges find_edges(std::size_t points, std::span<const CellView> cells, const Progress &progress = {},
                 double from = 0.0, double to = 1.0);

} // namespace nmgs
