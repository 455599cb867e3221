// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/quality/bernstein.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace {

using nmgs::BernsteinBasis;
using Point = std::array<double, 3>;
using Function = std::function<double(const Point &)>;

std::vector<double> coefficients(const BernsteinBasis &basis, const Function &f) {
    std::vector<double> c;
    for (const Point &p : basis.samples()) {
        c.push_back(f(p));
    }
    basis.to_coefficients(c);
    return c;
}

double mean(const std::vector<double> &c) {
    double sum = 0;
    for (const double v : c) {
        sum += v;
    }
    return sum / static_cast<double>(c.size());
}

// The mean of the coefficients is the mean of the polynomial, known in closed form: over a simplex
// the mean of r^a s^b t^c is a! b! c! d! / (a + b + c + d)!.
TEST(Bernstein, MeansOfMonomials) {
    EXPECT_NEAR(
        mean(coefficients(BernsteinBasis::box(3, 5),
                          [](const Point &p) { return std::pow(p[0], 5) * p[1] * p[2] * p[2]; })),
        1.0 / 6 / 2 / 3, 1e-14);
    EXPECT_NEAR(
        mean(coefficients(BernsteinBasis::box(2, 4),
                          [](const Point &p) { return std::pow(p[0], 3) * std::pow(p[1], 4); })),
        1.0 / 4 / 5, 1e-14);
    EXPECT_NEAR(mean(coefficients(BernsteinBasis::simplex(2, 2),
                                  [](const Point &p) { return p[0] * p[1]; })),
                2.0 / 24, 1e-15);
    EXPECT_NEAR(mean(coefficients(BernsteinBasis::simplex(3, 3),
                                  [](const Point &p) { return p[0] * p[1] * p[2]; })),
                6.0 / 720, 1e-15);
}

TEST(Bernstein, CornersAreValuesAndCoefficientsBound) {
    const auto f = [](const Point &p) {
        return (p[0] - 0.5) * (p[0] - 0.5) + p[1] * (1 - p[1]) - 0.1;
    };
    const auto basis = BernsteinBasis::box(2, 4);
    const auto c = coefficients(basis, f);
    ASSERT_EQ(basis.corners().size(), 4U);
    for (const std::size_t i : basis.corners()) {
        EXPECT_NEAR(c[i], f(basis.samples()[i]), 1e-14);
    }
    const auto [low, high] = std::minmax_element(c.begin(), c.end());
    EXPECT_LE(*low, -0.1 + 1e-12); // the minimum, at (0.5, 0)
    EXPECT_GE(*high, 0.4 - 1e-12); // the maximum, at (0, 0.5)
}

// The mean over the whole is the mean of the means over the parts, which have equal sizes, and the
// bounds of the parts are inside those of the whole.
void check_parts(const BernsteinBasis &basis, const Function &f) {
    const auto whole = coefficients(basis, f);
    const auto [low, high] = std::minmax_element(whole.begin(), whole.end());
    for (std::size_t depth = 0; depth < 3; ++depth) {
        double sum = 0;
        for (std::size_t part = 0; part < basis.parts(); ++part) {
            std::vector<double> c(whole.size());
            basis.restrict_to(part, depth, whole, c);
            sum += mean(c);
            EXPECT_GE(*std::min_element(c.begin(), c.end()), *low - 1e-12);
            EXPECT_LE(*std::max_element(c.begin(), c.end()), *high + 1e-12);
        }
        EXPECT_NEAR(sum / static_cast<double>(basis.parts()), mean(whole), 1e-13);
    }
}

TEST(Bernstein, Parts) {
    const auto f = [](const Point &p) { return p[0] * p[0] - 2 * p[0] * p[1] + 0.3 * p[2] - 0.2; };
    check_parts(BernsteinBasis::box(3, 5), f);
    check_parts(BernsteinBasis::box(2, 4), f);
    check_parts(BernsteinBasis::simplex(2, 2), f);
    check_parts(BernsteinBasis::simplex(3, 3), f);
}

} // namespace
