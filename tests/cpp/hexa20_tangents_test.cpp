// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/quality/hexa20_tangents.h"

#include "nmgs/element/hexa20.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace {

using nmgs::Vec3;

std::array<Vec3, 20> random_cell(std::mt19937 &random, double amplitude) {
    std::uniform_real_distribution<double> move(-amplitude, amplitude);
    std::array<Vec3, 20> nodes;
    for (std::size_t i = 0; i < 20; ++i) {
        const auto &p = nmgs::hexa20::natural[i];
        nodes[i] = {1000 + p[0] + move(random), 2 * p[1] + move(random),
                    p[2] + 0.3 * p[0] + move(random)};
    }
    return nodes;
}

// Tangents and scaled Jacobian by the shape functions' own derivatives.
std::array<Vec3, 3> tangents_at(const std::array<Vec3, 20> &nodes, double x, double y, double z) {
    const auto d = nmgs::hexa20::derivatives(x, y, z);
    std::array<Vec3, 3> t{};
    for (std::size_t i = 0; i < 20; ++i) {
        t[0] += d.xi[i] * nodes[i];
        t[1] += d.eta[i] * nodes[i];
        t[2] += d.zeta[i] * nodes[i];
    }
    return t;
}

double scaled_jacobian(const std::array<Vec3, 3> &t) {
    return determinant(t[0], t[1], t[2]) / (norm(t[0]) * norm(t[1]) * norm(t[2]));
}

TEST(Hexa20Tangents, SamplesAreTheDerivatives) {
    std::mt19937 random(1);
    const auto nodes = random_cell(random, 0.3);
    std::vector<double> values(std::size_t{9} * 216);
    nmgs::curved::sample(nmgs::curved::hexa20_tangents(nodes.data()),
                         std::span<double, std::size_t{9} * 216>(values));
    for (std::size_t s = 0; s < 216; ++s) {
        const auto at = [](std::size_t i) { return 0.4 * static_cast<double>(i) - 1; };
        const auto t = tangents_at(nodes, at(s % 6), at(s / 6 % 6), at(s / 36));
        for (std::size_t d = 0; d < 3; ++d) {
            const std::array<double, 3> expected{t[d].x, t[d].y, t[d].z};
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_NEAR(values[(3 * d + c) * 216 + s], expected[c], 1e-11);
            }
        }
    }
}

TEST(Hexa20Tangents, CornersAreTheDerivatives) {
    std::mt19937 random(2);
    const auto nodes = random_cell(random, 0.3);
    const auto tangents = nmgs::curved::hexa20_tangents(nodes.data());
    for (std::size_t corner = 0; corner < 8; ++corner) {
        const auto sign = [&](std::size_t d) { return (corner >> d & 1U) != 0 ? 1.0 : -1.0; };
        const auto t = tangents_at(nodes, sign(0), sign(1), sign(2));
        for (std::size_t d = 0; d < 3; ++d) {
            EXPECT_LT(distance(tangents.at_corner(d, corner), t[d]), 1e-11);
        }
    }
}

// Against a dense grid: never above the least value there; and close where little is bent.
TEST(Hexa20Tangents, BoundsHold) {
    std::mt19937 random(3);
    for (const double amplitude : {0.0, 0.001, 0.01, 0.1, 0.3, 0.6}) {
        for (int cell = 0; cell < 20; ++cell) {
            const auto nodes = random_cell(random, amplitude);
            const auto [lower, upper] =
                nmgs::curved::scaled_jacobian_bounds(nmgs::curved::hexa20_tangents(nodes.data()));
            double least = 1;
            for (int i = 0; i < 11 * 11 * 11; ++i) {
                const int j = i / 11 % 11;
                const int k = i / 121;
                least = std::min(least, scaled_jacobian(tangents_at(nodes, 0.2 * (i % 11) - 1,
                                                                    0.2 * j - 1, 0.2 * k - 1)));
            }
            EXPECT_LE(lower, least + 1e-12);
            EXPECT_GE(upper, least - 1e-12);
            if (amplitude <= 0.001) {
                EXPECT_GT(lower, least - 0.05);
            }
        }
    }
}

} // namespace
