// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/convert/matching.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

namespace {

using nmgs::WeightedPair;

TEST(Matching, TakesTheHeavierPair) {
    EXPECT_EQ(nmgs::maximum_weight_matching(3, {{0, 1, 5}, {1, 2, 7}}),
              (std::vector<std::int32_t>{-1, 2, 1}));
    EXPECT_EQ(nmgs::maximum_weight_matching(0, {}), std::vector<std::int32_t>{});
}

// Odd cycles are what a greedy or a bipartite method gets wrong.
TEST(Matching, AsGoodAsTryingAll) {
    std::mt19937 random(11);
    for (int round = 0; round < 300; ++round) {
        const std::int32_t nodes = 2 + static_cast<std::int32_t>(random() % 7);
        std::vector<WeightedPair> pairs;
        for (std::int32_t a = 0; a < nodes; ++a) {
            for (std::int32_t b = a + 1; b < nodes; ++b) {
                if (random() % 2 == 0) {
                    pairs.push_back({a, b, static_cast<std::int64_t>(1 + random() % 20)});
                }
            }
        }
        std::function<std::int64_t(std::size_t, unsigned)> best = [&](std::size_t at,
                                                                      unsigned used) {
            if (at == pairs.size()) {
                return std::int64_t{0};
            }
            const unsigned both = 1U << pairs[at].a | 1U << pairs[at].b;
            std::int64_t value = best(at + 1, used);
            if ((used & both) == 0) {
                value = std::max(value, pairs[at].weight + best(at + 1, used | both));
            }
            return value;
        };
        const auto mate = nmgs::maximum_weight_matching(nodes, pairs);
        std::int64_t total = 0;
        for (std::int32_t n = 0; n < nodes; ++n) {
            const std::int32_t m = mate[static_cast<std::size_t>(n)];
            if (m >= 0) {
                EXPECT_EQ(mate[static_cast<std::size_t>(m)], n);
            }
        }
        for (const WeightedPair &pair : pairs) {
            if (mate[static_cast<std::size_t>(pair.a)] == pair.b) {
                total += pair.weight;
            }
        }
        EXPECT_EQ(total, best(0, 0));
    }
}

} // namespace
