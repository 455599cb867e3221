// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/support/numbers.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

namespace {

using nmgs::parse_double;
using nmgs::parse_integer;

template <class T>
std::string printed(T value) {
    char text[nmgs::max_number_length];
    return {text, nmgs::print(text, value)};
}

TEST(Numbers, AnyDoubleComesBackToTheBit) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 200000; ++i) {
        const auto value = std::bit_cast<double>(random());
        if (!std::isfinite(value)) {
            continue;
        }
        const std::string text = printed(value);
        const auto back = parse_double(text);
        ASSERT_TRUE(back) << text;
        ASSERT_EQ(std::bit_cast<std::uint64_t>(*back), std::bit_cast<std::uint64_t>(value)) << text;
        ASSERT_EQ(std::strtod(text.c_str(), nullptr), value) << text;
    }
}

TEST(Numbers, BorderDoubles) {
    using Limits = std::numeric_limits<double>;
    for (const double v : {0.0, -0.0, Limits::min(), Limits::max(), Limits::lowest(),
                           Limits::denorm_min(), Limits::epsilon(), 0.1, 1e22, 1e23}) {
        const auto back = parse_double(printed(v));
        ASSERT_TRUE(back);
        EXPECT_EQ(std::bit_cast<std::uint64_t>(*back), std::bit_cast<std::uint64_t>(v));
    }
    EXPECT_EQ(printed(0.1), "0.1");
    EXPECT_EQ(printed(100.0), "100");
}

TEST(Numbers, FortranAndPlusForms) {
    EXPECT_EQ(parse_double("1.5D+02"), 150.0);
    EXPECT_EQ(parse_double("1.5d-2"), 0.015);
    EXPECT_EQ(parse_double("+3"), 3.0);
    EXPECT_EQ(parse_double(".5"), 0.5);
    EXPECT_EQ(parse_double("5."), 5.0);
    EXPECT_EQ(parse_integer("+12"), 12);
}

TEST(Numbers, RangeEnds) {
    EXPECT_EQ(parse_double("1e-999"), 0.0);
    EXPECT_FALSE(parse_double("1e999"));
    EXPECT_FALSE(parse_double(std::string(400, '9')));
    EXPECT_EQ(parse_integer("9223372036854775807"), std::numeric_limits<std::int64_t>::max());
    EXPECT_FALSE(parse_integer("9223372036854775808"));
}

TEST(Numbers, WhatIsNoNumber) {
    for (const char *text :
         {"", "+", "-", "+-1", "1,5", "0x10", "abc", "1.2.3", "1e", "D5", "1D"}) {
        EXPECT_FALSE(parse_double(text)) << text;
    }
    for (const char *text : {"", "1.0", "1e3", " 1", "1 ", "--1", "one"}) {
        EXPECT_FALSE(parse_integer(text)) << text;
    }
}

} // namespace
