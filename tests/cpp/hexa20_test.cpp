// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/element/hexa20.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace {

namespace hexa20 = nmgs::hexa20;
using nmgs::Vec3;

TEST(Hexa20, EachFunctionIsOneAtItsNodeAndZeroAtTheOthers) {
    for (std::size_t at = 0; at < 20; ++at) {
        const auto &p = hexa20::natural[at];
        const auto n = hexa20::shape(p[0], p[1], p[2]);
        for (std::size_t i = 0; i < 20; ++i) {
            EXPECT_EQ(n[i], i == at ? 1.0 : 0.0);
        }
    }
}

// The thesis's Table 2.2 with N4 and N6 mended, written out as it stands there.
TEST(Hexa20, CornersAreTheThesisFormula) {
    const double x = 0.3;
    const double y = -0.2;
    const double z = 0.7;
    const auto n = hexa20::shape(x, y, z);
    EXPECT_NEAR(n[3], 0.125 * (1 - x) * (1 + y) * (1 - z) - 0.5 * (n[19] + n[11] + n[10]), 1e-15);
    EXPECT_NEAR(n[5], 0.125 * (1 + x) * (1 - y) * (1 + z) - 0.5 * (n[17] + n[13] + n[12]), 1e-15);
    EXPECT_NEAR(n[8], 0.25 * (1 - x * x) * (1 - y) * (1 - z), 1e-15);
}

// Monomials of superlinear degree 2 at most (Arnold and Awanou, The serendipity family, 2011).
TEST(Hexa20, ReproducesItsPolynomials) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> in(-1, 1);
    int count = 0;
    for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) {
            for (int c = 0; c < 3; ++c) {
                if ((a > 1 ? a : 0) + (b > 1 ? b : 0) + (c > 1 ? c : 0) > 2) {
                    continue;
                }
                ++count;
                const auto f = [&](double x, double y, double z) {
                    return std::pow(x, a) * std::pow(y, b) * std::pow(z, c);
                };
                const double x = in(random);
                const double y = in(random);
                const double z = in(random);
                const auto n = hexa20::shape(x, y, z);
                const auto d = hexa20::derivatives(x, y, z);
                double value = 0;
                double by_z = 0;
                for (std::size_t i = 0; i < 20; ++i) {
                    const auto &p = hexa20::natural[i];
                    value += n[i] * f(p[0], p[1], p[2]);
                    by_z += d.zeta[i] * f(p[0], p[1], p[2]);
                }
                EXPECT_NEAR(value, f(x, y, z), 1e-14);
                EXPECT_NEAR(by_z, c == 0 ? 0 : c * f(x, y, 1) * std::pow(z, c - 1), 1e-14);
            }
        }
    }
    EXPECT_EQ(count, 20);
}

TEST(Hexa20, JacobianOfAnAffineBlockIsItsDeterminant) {
    std::array<Vec3, 20> nodes{};
    for (std::size_t i = 0; i < 20; ++i) {
        const auto &p = hexa20::natural[i];
        nodes[i] = {2 * p[0] + 0.5 * p[1], 3 * p[1] + 0.1 * p[2], 4 * p[2] + 7};
    }
    EXPECT_NEAR(hexa20::jacobian(nodes, 0.1, 0.2, -0.9), 24, 1e-12);
}

} // namespace
