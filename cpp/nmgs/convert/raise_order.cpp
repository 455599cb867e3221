// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/convert/raise_order.h"

#include "nmgs/mesh/edges.h"
#include "nmgs/support/error.h"
#include "nmgs/support/parallel.h"

#include <algorithm>
#include <limits>

namespace nmgs {
namespace {

constexpr std::size_t grain = 1 << 13;

CellBlock raise(const CellView &view, const Array<std::int32_t> &edge_numbers, std::int32_t first) {
    const auto local = edges(view.type);
    const auto k = static_cast<std::size_t>(node_count(view.type));
    const CellType type = quadratic_type(view.type);
    const auto wide = static_cast<std::size_t>(node_count(type));
    CellBlock block{type, Array<std::int32_t>(view.size() * wide)};
    parallel_for(view.size(), grain, [&](std::size_t from, std::size_t to) {
        for (std::size_t c = from; c < to; ++c) {
            std::int32_t *out = block.nodes.data() + c * wide;
            std::copy_n(view.nodes.data() + c * k, k, out);
            for (std::size_t e = 0; e < local.size(); ++e) {
                out[local[e].mid] = first + edge_numbers[c * local.size() + e];
            }
        }
    });
    return block;
}

} // namespace

QuadraticMesh raise_order(std::span<const Vec3> points, std::span<const CellView> cells,
                          const PlaceOnEdge &place, const Progress &progress) {
    for (const CellView &view : cells) {
        if (is_quadratic(view.type)) {
            throw ArgumentError("cells: " + std::string(name(view.type)) + " is quadratic already");
        }
    }
    Edges all = find_edges(points.size(), cells, progress, 0.0, 0.6);
    const std::size_t total = points.size() + all.ends.size();
    if (total > std::numeric_limits<std::int32_t>::max()) {
        throw ArgumentError("order: the mesh would have " + std::to_string(total) +
                            " nodes; node numbers end at 2147483647");
    }
    QuadraticMesh result;
    result.points = Array<Vec3>(total);
    std::copy(points.begin(), points.end(), result.points.begin());
    Vec3 *middles = result.points.data() + points.size();
    if (!place) {
        parallel_for(all.ends.size(), grain, [&](std::size_t from, std::size_t to) {
            for (std::size_t e = from; e < to; ++e) {
                middles[e] = 0.5 * (points[static_cast<std::size_t>(all.ends[e][0])] +
                                    points[static_cast<std::size_t>(all.ends[e][1])]);
            }
        });
    } else {
        // Edges are numbered as the cells first name them, so each new number is one more.
        std::vector<std::array<std::int32_t, 3>> first(all.ends.size());
        std::int32_t seen = 0;
        for (std::size_t b = 0; b < cells.size(); ++b) {
            const auto per_cell = edges(cells[b].type).size();
            for (std::size_t i = 0; i < all.of_cells[b].size(); ++i) {
                if (all.of_cells[b][i] == seen) {
                    first[static_cast<std::size_t>(seen++)] = {
                        static_cast<std::int32_t>(b), static_cast<std::int32_t>(i / per_cell),
                        static_cast<std::int32_t>(i % per_cell)};
                }
            }
        }
        parallel_for(
            first.size(), 1 << 10,
            [&](std::size_t from, std::size_t to) {
                for (std::size_t e = from; e < to; ++e) {
                    middles[e] = place(static_cast<std::size_t>(first[e][0]),
                                       static_cast<std::size_t>(first[e][1]),
                                       static_cast<std::size_t>(first[e][2]));
                }
            },
            progress, 0.6, 0.9);
    }
    for (std::size_t b = 0; b < cells.size(); ++b) {
        result.cells.push_back(
            raise(cells[b], all.of_cells[b], static_cast<std::int32_t>(points.size())));
        all.of_cells[b] = {};
    }
    result.ends = std::move(all.ends);
    return result;
}

} // namespace nmgs
