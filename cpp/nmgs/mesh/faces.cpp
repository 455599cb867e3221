// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/mesh/faces.h"

#include "nmgs/support/error.h"

#include <algorithm>
#include <limits>

namespace nmgs {
namespace {

std::array<std::int32_t, 4> key_of(const LocalFace &face, const std::int32_t *nodes) {
    const auto at = [&](std::size_t i) { return nodes[face.nodes[i]]; };
    std::array<std::int32_t, 4> key{
        at(0), at(1), at(2),
        corner_count(face.type) == 4 ? at(3) : std::numeric_limits<std::int32_t>::max()};
    const auto order = [&](std::size_t i, std::size_t j) {
        const auto [low, high] = std::minmax(key[i], key[j]);
        const std::array<std::int32_t, 2> pair{low, high};
        key[i] = pair[0];
        key[j] = pair[1];
    };
    order(0, 1);
    order(2, 3);
    order(0, 2);
    order(1, 3);
    order(1, 2);
    return key;
}

} // namespace

Faces find_faces(std::size_t points, std::span<const CellView> cells, const Progress &progress,
                 double from, double to) {
    check_nodes(cells, points);
    Faces result;
    std::vector<std::int32_t> head(points, -1); // first face whose lowest corner is the node
    std::vector<std::int32_t> next;             // the next such face
    std::size_t total = 0;
    for (const CellView &view : cells) {
        total += view.size();
    }
    std::size_t done = 0;
    for (std::size_t block = 0; block < cells.size(); ++block) {
        const CellView &view = cells[block];
        const auto local = faces(view.type);
        const auto k = static_cast<std::size_t>(node_count(view.type));
        Array<std::int32_t> numbers(view.size() * local.size());
        for (std::size_t c = 0; c < view.size(); ++c, ++done) {
            if (done % (1 << 16) == 0) {
                poll(progress,
                     from + (to - from) * static_cast<double>(done) / static_cast<double>(total));
            }
            for (std::size_t f = 0; f < local.size(); ++f) {
                const auto key = key_of(local[f], view.nodes.data() + c * k);
                std::int32_t *link = &head[static_cast<std::size_t>(key[0])];
                std::int32_t found = *link;
                while (found >= 0 && result.faces[static_cast<std::size_t>(found)].key != key) {
                    link = &next[static_cast<std::size_t>(found)];
                    found = *link;
                }
                if (found < 0) {
                    if (result.faces.size() >= std::numeric_limits<std::int32_t>::max()) {
                        throw ArgumentError("cells: more than 2147483647 faces");
                    }
                    found = static_cast<std::int32_t>(result.faces.size());
                    *link = found;
                    result.faces.push_back({key, 0, static_cast<std::uint8_t>(block),
                                            static_cast<std::uint8_t>(f),
                                            static_cast<std::int32_t>(c)});
                    next.push_back(-1);
                }
                ++result.faces[static_cast<std::size_t>(found)].uses;
                numbers[c * local.size() + f] = found;
            }
        }
        result.of_cells.push_back(std::move(numbers));
    }
    return result;
}

} // namespace nmgs
