// SPDX-License-Identifier: LGPL-2.1-or-later
// Related nodes (thesis 4.4.1 iii, 4.5.1 iii, Figs. 4.4 and 4.6): nodes joined by an edge of an
// element.
#pragma once

#include "nmgs/mesh/cell_topology.h"
#include "nmgs/support/progress.h"

#include <cstdint>
#include <span>

namespace nmgs {

// Compressed rows: the related nodes of node n, ascending, are
// neighbours[offsets[n]] ... neighbours[offsets[n + 1] - 1].
struct RelatedNodes {
    Array<std::int64_t> offsets; // points + 1
    Array<std::int32_t> neighbours;
};

// Of a quadratic cell's edge, the mid-side node is related to both ends, the ends not to each
// other. Raises ArgumentError when a cell's node is not in [0, points).
RelatedNodes related_nodes(std::size_t points, std::span<const CellView> cells,
                           const Progress &progress = {});

} // namespace nmgs
