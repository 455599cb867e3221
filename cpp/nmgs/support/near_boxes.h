// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs of boxes that come near each other, by a sweep along x.
#pragma once

#include "nmgs/support/vec3.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace nmgs {

// All pairs (i, j), i < j, of boxes that come within gap of each other; ascending.
inline std::vector<std::pair<std::size_t, std::size_t>> near_boxes(std::span<const Box> boxes,
                                                                   double gap) {
    std::vector<std::size_t> order(boxes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(boxes[a].low.x, a) < std::pair(boxes[b].low.x, b);
    });
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t s = 0; s < order.size(); ++s) {
        const Box &box = boxes[order[s]];
        for (std::size_t t = s + 1; t < order.size() && boxes[order[t]].low.x <= box.high.x + gap;
             ++t) {
            if (box.near(boxes[order[t]], gap)) {
                pairs.emplace_back(std::min(order[s], order[t]), std::max(order[s], order[t]));
            }
        }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

} // namespace nmgs
