// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/element/validity.h"

#include "nmgs/element/hexa20.h"
#include "nmgs/element/quad8.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>

namespace {

using nmgs::check_validity;
using nmgs::Validity;
using nmgs::Vec3;

std::array<Vec3, 20> cube() {
    std::array<Vec3, 20> nodes{};
    for (std::size_t i = 0; i < 20; ++i) {
        const auto &p = nmgs::hexa20::natural[i];
        nodes[i] = {p[0], p[1], p[2]};
    }
    return nodes;
}

std::array<Vec3, 8> square() {
    std::array<Vec3, 8> nodes{};
    for (std::size_t i = 0; i < 8; ++i) {
        nodes[i] = {nmgs::quad8::natural[i][0], nmgs::quad8::natural[i][1], 0};
    }
    return nodes;
}

// Least Jacobian over a grid: an upper bound of the least one.
double sampled(const std::array<Vec3, 20> &nodes) {
    double least = INFINITY;
    for (int i = 0; i <= 16; ++i) {
        for (int j = 0; j <= 16; ++j) {
            for (int k = 0; k <= 16; ++k) {
                least = std::min(least, nmgs::hexa20::jacobian(nodes, -1 + 0.125 * i,
                                                               -1 + 0.125 * j, -1 + 0.125 * k));
            }
        }
    }
    return least;
}

TEST(Validity, PlainElements) {
    EXPECT_EQ(check_validity(cube()).validity, Validity::valid);
    EXPECT_EQ(check_validity(square()).validity, Validity::valid);
}

TEST(Validity, RandomBlocksAgreeWithSamples) {
    std::mt19937 random(4);
    int valid = 0;
    int folded = 0;
    for (int t = 0; t < 300; ++t) {
        std::uniform_real_distribution<double> by(-0.1 - 0.002 * t, 0.1 + 0.002 * t);
        auto nodes = cube();
        for (Vec3 &p : nodes) {
            p += {by(random), by(random), by(random)};
        }
        const double least = sampled(nodes);
        const auto result = check_validity(nodes);
        if (least < -1e-6) {
            ++folded;
            EXPECT_EQ(result.validity, Validity::folded);
            EXPECT_LE(nmgs::hexa20::jacobian(nodes, result.natural[0], result.natural[1],
                                             result.natural[2]),
                      1e-9);
        } else if (least > 0.05) {
            ++valid;
            EXPECT_EQ(result.validity, Validity::valid);
        }
    }
    EXPECT_GT(valid, 50);
    EXPECT_GT(folded, 50);
}

// A mid-side node at a quarter puts the zero of the Jacobian at the corner (Barsoum's crack-tip
// element); nearer still, the edge turns back.
TEST(Validity, QuarterPointIsTheLimit) {
    for (const auto &[at, expected] :
         {std::pair(-0.45, Validity::valid), std::pair(-0.5, Validity::collapsed),
          std::pair(-0.55, Validity::folded)}) {
        auto nodes = cube();
        for (const std::size_t mid : {8U, 10U, 12U, 14U}) {
            nodes[mid].x = at;
        }
        EXPECT_EQ(check_validity(nodes).validity, expected) << at;
        auto patch = square();
        patch[4].x = patch[6].x = at;
        EXPECT_EQ(check_validity(patch).validity, expected) << at;
    }
}

TEST(Validity, MirroredBlocks) {
    auto nodes = cube();
    for (Vec3 &p : nodes) {
        p.x = -p.x;
    }
    EXPECT_EQ(check_validity(nodes).validity, Validity::mirrored);
}

TEST(Validity, PatchesInSpace) {
    // Bent by more than a right angle, and good.
    auto patch = square();
    for (Vec3 &p : patch) {
        p = {p.x, p.y, 2 * p.x * p.x};
    }
    EXPECT_EQ(check_validity(patch).validity, Validity::valid);
    // Corner 3 pulled past the diagonal.
    patch = square();
    patch[2] = {-0.8, -0.8, 0};
    EXPECT_EQ(check_validity(patch).validity, Validity::folded);
}

TEST(Validity, PointsAreCollapsed) {
    EXPECT_EQ(check_validity(std::array<Vec3, 20>{}).validity, Validity::collapsed);
    EXPECT_EQ(check_validity(std::array<Vec3, 8>{}).validity, Validity::collapsed);
}

} // namespace
