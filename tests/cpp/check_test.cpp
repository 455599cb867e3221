// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/plc/check.h"

#include "nmgs/plc/mend.h"
#include "nmgs/support/error.h"
#include "nmgs/support/parallel.h"

#include <gtest/gtest.h>

#include <array>

namespace {

using nmgs::Plc;
using nmgs::PlcFault;
using nmgs::Vec3;

void add_box(Plc &plc, Vec3 low, Vec3 size) {
    const auto first = static_cast<std::int32_t>(plc.points.size());
    for (int n = 0; n < 8; ++n) {
        plc.points.push_back({low.x + (n & 1) * size.x, low.y + (n >> 1 & 1) * size.y,
                              low.z + (n >> 2 & 1) * size.z});
    }
    constexpr std::array<std::array<int, 4>, 6> faces{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto &face : faces) {
        for (const int node : face) {
            plc.polygon_nodes.push_back(first + node);
        }
        plc.end_polygon();
        plc.end_facet();
    }
}

std::size_t count(const std::vector<nmgs::PlcProblem> &problems, PlcFault fault) {
    std::size_t n = 0;
    for (const auto &problem : problems) {
        n += problem.fault == fault ? 1 : 0;
    }
    return n;
}

TEST(Check, EmptyAndSound) {
    EXPECT_TRUE(nmgs::check(Plc()).empty());
    Plc plc;
    add_box(plc, {0, 0, 0}, {1, 2, 3});
    EXPECT_TRUE(nmgs::check(plc).empty());
}

// Of two boxes that overlap by a corner, each of three faces of one is cut by two of the other.
TEST(Check, OverlappingBoxesCrossInSixPairs) {
    Plc plc;
    add_box(plc, {0, 0, 0}, {1, 1, 1});
    add_box(plc, {0.5, 0.5, 0.5}, {1, 1, 1});
    const auto problems = nmgs::check(plc);
    EXPECT_EQ(count(problems, PlcFault::crossing_facets), 6U);
    EXPECT_EQ(problems.size(), 6U);
}

TEST(Check, SameAnswerForAnyNumberOfThreads) {
    Plc plc;
    for (int i = 0; i < 400; ++i) {
        add_box(plc, {0.37 * i, 0.61 * (i % 7), 0.43 * (i % 5)}, {1, 1, 1});
    }
    const auto facets = [&] {
        std::vector<std::vector<std::int32_t>> pairs;
        for (const auto &problem : nmgs::check(plc)) {
            pairs.push_back(problem.facets);
        }
        return pairs;
    };
    nmgs::set_threads(1);
    const auto one = facets();
    nmgs::set_threads(5);
    const auto five = facets();
    nmgs::set_threads(0);
    EXPECT_GT(one.size(), 100U);
    EXPECT_EQ(one, five);
}

TEST(Check, LimitHolds) {
    Plc plc;
    for (int i = 0; i < 30; ++i) {
        add_box(plc, {0.1 * i, 0, 0.05 * i}, {1, 1, 1});
    }
    nmgs::CheckOptions options;
    options.limit = 7;
    EXPECT_EQ(count(nmgs::check(plc, options), PlcFault::crossing_facets), 7U);
}

TEST(Check, NotFiniteIsAnArgumentError) {
    Plc plc;
    add_box(plc, {0, 0, 0}, {1, 1, 1});
    plc.points[3].y = std::nan("");
    EXPECT_THROW(nmgs::check(plc), nmgs::ArgumentError);
}

TEST(Check, CancelStops) {
    Plc plc;
    add_box(plc, {0, 0, 0}, {1, 1, 1});
    EXPECT_THROW(nmgs::check(plc, {}, [](double) { return false; }), nmgs::Cancelled);
}

// The triangle 0, 8, 1 is a line on the edge of two faces: its middle goes into both.
TEST(Mend, SliverGivesItsMiddleToItsNeighbours) {
    Plc plc;
    add_box(plc, {0, 0, 0}, {1, 1, 1});
    plc.points.push_back({0.5, 0, 0});
    plc.polygon_nodes.insert(plc.polygon_nodes.end(), {0, 8, 1});
    plc.end_polygon();
    plc.end_facet();
    const nmgs::Mended mended = nmgs::mend(plc);
    ASSERT_EQ(mended.plc.facet_count(), 6U);
    std::size_t five = 0;
    for (std::size_t f = 0; f < 6; ++f) {
        five += mended.plc.polygon_offsets[f + 1] - mended.plc.polygon_offsets[f] == 5 ? 1 : 0;
    }
    EXPECT_EQ(five, 2U);
    EXPECT_TRUE(nmgs::check(mended.plc).empty());
}

} // namespace
