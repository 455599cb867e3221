// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/element/quad8.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace {

namespace quad8 = nmgs::quad8;

TEST(Quad8, EachFunctionIsOneAtItsNodeAndZeroAtTheOthers) {
    for (std::size_t at = 0; at < 8; ++at) {
        const auto n = quad8::shape(quad8::natural[at][0], quad8::natural[at][1]);
        for (std::size_t i = 0; i < 8; ++i) {
            EXPECT_EQ(n[i], i == at ? 1.0 : 0.0);
        }
    }
}

TEST(Quad8, FunctionsSumToOneAndDerivativesToZero) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> in(-1, 1);
    for (int k = 0; k < 100; ++k) {
        const double xi = in(random);
        const double eta = in(random);
        const auto n = quad8::shape(xi, eta);
        const auto d = quad8::derivatives(xi, eta);
        EXPECT_NEAR(std::accumulate(n.begin(), n.end(), 0.0), 1, 1e-14);
        EXPECT_NEAR(std::accumulate(d.xi.begin(), d.xi.end(), 0.0), 0, 1e-14);
        EXPECT_NEAR(std::accumulate(d.eta.begin(), d.eta.end(), 0.0), 0, 1e-14);
    }
}

// All of 1, x, y, x^2, xy, y^2, x^2 y, x y^2 and their derivatives.
TEST(Quad8, ReproducesItsPolynomials) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> in(-1, 1);
    constexpr std::array<std::array<int, 2>, 8> powers{
        {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}, {2, 1}, {1, 2}}};
    for (const auto &[a, b] : powers) {
        const auto f = [a = a, b = b](double x, double y) {
            return std::pow(x, a) * std::pow(y, b);
        };
        const double x = in(random);
        const double y = in(random);
        const auto n = quad8::shape(x, y);
        const auto d = quad8::derivatives(x, y);
        double value = 0;
        double by_x = 0;
        double by_y = 0;
        for (std::size_t i = 0; i < 8; ++i) {
            const double at = f(quad8::natural[i][0], quad8::natural[i][1]);
            value += n[i] * at;
            by_x += d.xi[i] * at;
            by_y += d.eta[i] * at;
        }
        EXPECT_NEAR(value, f(x, y), 1e-14);
        EXPECT_NEAR(by_x, a == 0 ? 0 : a * std::pow(x, a - 1) * std::pow(y, b), 1e-14);
        EXPECT_NEAR(by_y, b == 0 ? 0 : b * std::pow(x, a) * std::pow(y, b - 1), 1e-14);
    }
}

} // namespace
