// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/blocking/grading.h"

#include "nmgs/support/error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

namespace grading = nmgs::grading;

void expect_ascending(const std::vector<double> &p) {
    EXPECT_EQ(p.front(), 0);
    EXPECT_EQ(p.back(), 1);
    for (std::size_t i = 1; i < p.size(); ++i) {
        EXPECT_GT(p[i], p[i - 1]);
    }
}

TEST(Grading, GeometricByHand) {
    EXPECT_EQ(grading::geometric(2, 3), (std::vector<double>{0, 0.25, 1}));
    const auto p = grading::geometric(3, 2);
    EXPECT_NEAR(p[1], 1.0 / 7, 1e-15);
    EXPECT_NEAR(p[2], 3.0 / 7, 1e-15);
    for (std::int32_t i = 0; i <= 4; ++i) {
        EXPECT_NEAR(grading::geometric(4, 1)[static_cast<std::size_t>(i)], 0.25 * i, 1e-15);
    }
}

TEST(Grading, SizesAreMet) {
    for (const std::int32_t n : {3, 10, 100}) {
        const auto first = grading::geometric_first(n, 0.5 / n);
        expect_ascending(first);
        EXPECT_NEAR(first[1], 0.5 / n, 1e-12);
        const auto last = grading::geometric_last(n, 0.5 / n);
        EXPECT_NEAR(1 - last[static_cast<std::size_t>(n) - 1], 0.5 / n, 1e-12);
        const auto both = grading::two_sided(n, 0.3 / n, 0.6 / n);
        expect_ascending(both);
        EXPECT_NEAR(both[1], 0.3 / n, 1e-10);
        EXPECT_NEAR(1 - both[static_cast<std::size_t>(n) - 1], 0.6 / n, 1e-10);
        const auto smooth = grading::tanh(n, 0.3 / n, 0.6 / n);
        expect_ascending(smooth);
        EXPECT_NEAR(smooth[1], 0.3 / n, 1e-10);
        EXPECT_NEAR(1 - smooth[static_cast<std::size_t>(n) - 1], 0.6 / n, 1e-10);
        const auto one = grading::tanh_first(n, 0.3 / n);
        expect_ascending(one);
        EXPECT_NEAR(one[1], 0.3 / n, 1e-12);
    }
}

TEST(Grading, ElementsOfTheUniformSizeAreUniform) {
    for (const auto &p : {grading::geometric_first(10, 0.1), grading::two_sided(10, 0.1, 0.1),
                          grading::tanh(10, 0.1, 0.1), grading::tanh_first(10, 0.1)}) {
        for (std::size_t i = 0; i <= 10; ++i) {
            EXPECT_NEAR(p[i], 0.1 * static_cast<double>(i), 1e-6);
        }
    }
}

TEST(Grading, ReversedTwiceIsTheSame) {
    const auto p = grading::geometric(5, 1.7);
    const auto back = grading::reversed(grading::reversed(p));
    for (std::size_t i = 0; i < p.size(); ++i) {
        EXPECT_NEAR(back[i], p[i], 1e-15);
    }
}

TEST(Grading, WrongArguments) {
    EXPECT_THROW(grading::geometric(0, 1), nmgs::ArgumentError);
    EXPECT_THROW(grading::geometric(3, 0), nmgs::ArgumentError);
    EXPECT_THROW(grading::geometric(3, NAN), nmgs::ArgumentError);
    EXPECT_THROW(grading::geometric(3000, 2), nmgs::ArgumentError); // elements of no length
    EXPECT_THROW(grading::geometric_first(3, 1), nmgs::ArgumentError);
    EXPECT_THROW(grading::geometric_first(1, 0.5), nmgs::ArgumentError);
    EXPECT_THROW(grading::two_sided(3, 0.5, 0.5), nmgs::ArgumentError);
    EXPECT_THROW(grading::two_sided(2, 0.3, 0.3), nmgs::ArgumentError);
    EXPECT_THROW(grading::tanh(5, -0.1, 0.1), nmgs::ArgumentError);
    EXPECT_THROW(grading::explicit_positions(std::vector<double>{0}), nmgs::ArgumentError);
    EXPECT_THROW(grading::explicit_positions(std::vector<double>{0, 0}), nmgs::ArgumentError);
    EXPECT_THROW(grading::explicit_positions(std::vector<double>{0, INFINITY}),
                 nmgs::ArgumentError);
}

} // namespace
