// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/constrained_delaunay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace {

using namespace nmgs::cad;
using Triangles = std::vector<std::array<std::int32_t, 3>>;

std::vector<Segment> loop(std::int32_t first, std::int32_t count, bool reversed = false) {
    std::vector<Segment> result;
    for (std::int32_t i = 0; i < count; ++i) {
        const std::int32_t a = first + i;
        const std::int32_t b = first + (i + 1) % count;
        result.push_back(reversed ? Segment{b, a, true} : Segment{a, b, true});
    }
    return result;
}

std::vector<Point2> circle(int count, double radius) {
    std::vector<Point2> points;
    for (int i = 0; i < count; ++i) {
        const double a = 2 * std::numbers::pi * i / count;
        points.push_back({radius * std::cos(a), radius * std::sin(a)});
    }
    return points;
}

double area(const std::vector<Point2> &p, const Triangles &triangles, double &least) {
    double sum = 0;
    least = 1e300;
    for (const auto &t : triangles) {
        const auto &a = p[static_cast<std::size_t>(t[0])];
        const auto &b = p[static_cast<std::size_t>(t[1])];
        const auto &c = p[static_cast<std::size_t>(t[2])];
        const double s = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
        least = std::min(least, s);
        sum += s;
    }
    return sum;
}

// Points on one circle are the worst case for the test of circumcircles.
TEST(ConstrainedDelaunay, CoversARegularPolygon) {
    for (const int n : {3, 8, 96}) {
        const auto points = circle(n, 2);
        const auto triangles = constrained_delaunay(points, loop(0, n));
        ASSERT_TRUE(triangles);
        EXPECT_EQ(triangles->size(), static_cast<std::size_t>(n) - 2);
        double least = 0;
        const double angle = 2 * std::numbers::pi / n;
        EXPECT_NEAR(area(points, *triangles, least), 2 * n * std::sin(angle), 1e-12);
        EXPECT_GT(least, 0);
    }
}

TEST(ConstrainedDelaunay, LeavesTheHoleOut) {
    auto points = circle(24, 2);
    const auto hole = circle(10, 1);
    points.insert(points.end(), hole.begin(), hole.end());
    auto segments = loop(0, 24);
    const auto inner = loop(24, 10, true);
    segments.insert(segments.end(), inner.begin(), inner.end());
    const auto triangles = constrained_delaunay(points, segments);
    ASSERT_TRUE(triangles);
    EXPECT_EQ(triangles->size(), 34U); // B - 2 + 2 holes
    double least = 0;
    const double expected = 0.5 * (24 * 4 * std::sin(2 * std::numbers::pi / 24) -
                                   10 * std::sin(2 * std::numbers::pi / 10));
    EXPECT_NEAR(area(points, *triangles, least), expected, 1e-12);
    EXPECT_GT(least, 0);
}

// A comb: the teeth's edges are no Delaunay edges and must be recovered.
TEST(ConstrainedDelaunay, RecoversEveryEdgeOfAComb) {
    std::vector<Point2> points;
    constexpr int teeth = 12;
    for (int i = 0; i < teeth; ++i) {
        points.push_back({0.01 * i, i % 2 == 0 ? 0.0 : 5.0 + 0.1 * i});
    }
    points.push_back({0.2, -1});
    points.push_back({-0.2, -1});
    std::reverse(points.begin(), points.end()); // counter-clockwise
    const auto n = static_cast<std::int32_t>(points.size());
    const auto segments = loop(0, n);
    const auto triangles = constrained_delaunay(points, segments);
    ASSERT_TRUE(triangles);
    EXPECT_EQ(triangles->size(), static_cast<std::size_t>(n) - 2);
    std::set<std::array<std::int32_t, 2>> edges;
    for (const auto &t : *triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            edges.insert({t[i], t[(i + 1) % 3]});
        }
    }
    for (const Segment &s : segments) {
        EXPECT_TRUE(edges.contains({s.a, s.b}));
    }
}

TEST(ConstrainedDelaunay, RefusesCrossingSegmentsAndRepeatedPoints) {
    const std::vector<Point2> bow{{0, 0}, {1, 1}, {1, 0}, {0, 1}};
    EXPECT_FALSE(constrained_delaunay(bow, loop(0, 4)));
    const std::vector<Point2> twice{{0, 0}, {1, 0}, {1, 1}, {1, 0}};
    EXPECT_FALSE(constrained_delaunay(twice, loop(0, 4)));
    const std::vector<Point2> clockwise{{0, 0}, {0, 1}, {1, 0}};
    EXPECT_FALSE(constrained_delaunay(clockwise, loop(0, 3)));
}

} // namespace
