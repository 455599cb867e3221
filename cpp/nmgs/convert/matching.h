// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs in a graph, of the largest total weight: Edmonds' blossom algorithm, LEMON's implementation
// (O(n m log n)). Readable as C++17, which LEMON needs.
#pragma once

#include <cstdint>
#include <vector>

namespace nmgs {

struct WeightedPair {
    std::int32_t a, b;
    std::int64_t weight;
};

// The partner of each of `nodes` nodes, or -1. pairs: at most one an unordered pair of nodes.
std::vector<std::int32_t> maximum_weight_matching(std::int32_t nodes,
                                                  const std::vector<WeightedPair> &pairs);

} // namespace nmgs
