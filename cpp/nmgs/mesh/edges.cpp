// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/mesh/edges.h"

#include "nmgs/support/error.h"

#include <algorithm>
#include <limits>

namespace nmgs {

Edges find_edges(std::size_t points, std::span<const CellView> cells, const Progress &progress,
                 double from, double to) {
    check_nodes(cells, points);
    Edges result;
    std::vector<std::int32_t> head(points, -1); // first edge whose lower end is the node
    std::vector<std::int32_t> next;             // the next such edge
    std::size_t total = 0;
    for (const CellView &view : cells) {
        total += view.size();
    }
    std::size_t done = 0;
    for (const CellView &view : cells) {
        const auto local = edges(view.type);
        const auto k = static_cast<std::size_t>(node_count(view.type));
        const std::size_t per_cell = local.size();
        Array<std::int32_t> numbers(view.size() * per_cell);
        for (std::size_t c = 0; c < view.size(); ++c, ++done) {
            if (done % (1 << 16) == 0) {
                poll(progress,
                     from + (to - from) * static_cast<double>(done) / static_cast<double>(total));
            }
            const std::int32_t *nodes = view.nodes.data() + c * k;
            for (std::size_t e = 0; e < per_cell; ++e) {
                const std::int32_t a = nodes[local[e].a];
                const std::int32_t b = nodes[local[e].b];
                const std::int32_t low = std::min(a, b);
                const std::int32_t high = std::max(a, b);
                std::int32_t *link = &head[static_cast<std::size_t>(low)];
                std::int32_t found = *link;
                while (found >= 0 && result.ends[static_cast<std::size_t>(found)][1] != high) {
                    link = &next[static_cast<std::size_t>(found)];
                    found = *link;
                }
                if (found < 0) {
                    if (result.ends.size() >= std::numeric_limits<std::int32_t>::max()) {
                        throw ArgumentError("cells: more than 2147483647 edges");
                    }
                    found = static_cast<std::int32_t>(result.ends.size());
                    *link = found;
                    result.ends.push_back({low, high});
                    next.push_back(-1);
                }
                numbers[c * per_cell + e] = found;
            }
        }
        result.of_cells.push_back(std::move(numbers));
    }
    return result;
}

} // namespace nmgs
