// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/element/inverse_map.h"

#include "nmgs/element/hexa20.h"
#include "nmgs/element/quad8.h"

#include <gtest/gtest.h>

#include <random>

namespace {

using nmgs::Vec3;

TEST(InverseMap, FindsWhatTheMapGave) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> by(-0.15, 0.15);
    std::uniform_real_distribution<double> in(-1, 1);
    for (int t = 0; t < 200; ++t) {
        std::array<Vec3, 20> nodes{};
        for (std::size_t i = 0; i < 20; ++i) {
            const auto &p = nmgs::hexa20::natural[i];
            nodes[i] = {p[0] + by(random), p[1] + by(random), p[2] + by(random)};
        }
        const std::array<double, 3> at{in(random), in(random), in(random)};
        const auto found = nmgs::find_natural(nodes, nmgs::hexa20::map(nodes, at[0], at[1], at[2]));
        ASSERT_TRUE(found);
        for (std::size_t d = 0; d < 3; ++d) {
            EXPECT_NEAR((*found)[d], at[d], 1e-8);
        }
    }
}

TEST(InverseMap, PlacesOutsideAreNone) {
    std::array<Vec3, 20> nodes{};
    for (std::size_t i = 0; i < 20; ++i) {
        const auto &p = nmgs::hexa20::natural[i];
        nodes[i] = {p[0], p[1], p[2]};
    }
    EXPECT_FALSE(nmgs::find_natural(nodes, {1.01, 0, 0}));
    EXPECT_FALSE(nmgs::find_natural(nodes, {100, 100, 100}));
    EXPECT_TRUE(nmgs::find_natural(nodes, {1, 1, 1}));
    EXPECT_FALSE(nmgs::find_natural(std::array<Vec3, 20>{}, {0, 0, 0}));
}

TEST(InverseMap, FootOfAPointOverAPatch) {
    std::array<Vec3, 8> patch{};
    for (std::size_t i = 0; i < 8; ++i) {
        patch[i] = {nmgs::quad8::natural[i][0], nmgs::quad8::natural[i][1], 0};
    }
    const auto over = nmgs::find_foot(patch, {0.3, -0.4, 2});
    EXPECT_TRUE(over.inside);
    EXPECT_NEAR(over.xi, 0.3, 1e-12);
    EXPECT_NEAR(over.eta, -0.4, 1e-12);
    EXPECT_NEAR(over.distance, 2, 1e-12);
    const auto beside = nmgs::find_foot(patch, {3, 0, 0});
    EXPECT_FALSE(beside.inside);
    EXPECT_NEAR(beside.distance, 2, 1e-12);
}

} // namespace
