// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/blocking/cusp.h"

#include "nmgs/blocking/default_divisions.h"
#include "nmgs/blocking/divisions.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace {

using namespace nmgs;

// Between the x axis and a circle of radius 1 that touches it at the origin, up to the angle.
std::vector<Vec3> tip(double angle) {
    const auto on = [](double a) { return Vec3{std::sin(a), 1 - std::cos(a), 0}; };
    const Vec3 a{angle, 0, 0};
    const Vec3 b = on(angle);
    const Vec3 c = 0.5 * (a + b) + Vec3{0.3 * b.y, 0, 0};
    return {{0, 0, 0}, a, c, b, 0.5 * a, 0.5 * (a + c), 0.5 * (b + c), on(0.5 * angle)};
}

std::vector<Vec3> straight(std::array<Vec3, 4> p) {
    std::vector<Vec3> nodes(p.begin(), p.end());
    for (std::size_t c = 0; c < 4; ++c) {
        nodes.push_back(0.5 * (p[c] + p[(c + 1) % 4]));
    }
    return nodes;
}

TEST(Cusp, IsWhereSidesTouchAndCornersDoNot) {
    EXPECT_TRUE(ends_in_cusp(tip(0.4)));
    EXPECT_FALSE(ends_in_cusp(straight({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}})));
    // A wedge has one angle however finely it is divided.
    EXPECT_FALSE(ends_in_cusp(straight({{{0, 0, 0}, {1, 0, 0}, {1.1, 0.05, 0}, {1, 0.1, 0}}})));
    // A straight corner is no cusp, nor are sides that coincide.
    EXPECT_FALSE(ends_in_cusp(straight({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}})));
    EXPECT_FALSE(ends_in_cusp(straight({{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {1, 0, 0}}})));
}

TEST(Cusp, KeepsOneDivision) {
    BlockModel model;
    model.dimension = 2;
    model.nodes = tip(0.4);
    model.divisions = {{1, 1, 0}};
    const Topology topology = find_topology(model);
    const auto by_default = default_divisions(model, topology, 0.2);
    const auto by_size = solve_divisions(model, topology, {}, 0.05);
    const std::array<DivisionWish, 1> wish{{{0, 0, 3, true}}};
    for (std::size_t d = 0; d < 2; ++d) {
        EXPECT_EQ(by_default[0][d], 1);
        EXPECT_EQ(by_size[0][d], 1);
    }
    EXPECT_EQ(solve_divisions(model, topology, wish)[0][0], 3); // who asks for it gets it
}

// A patch of 8 nodes carried up by 1.
std::array<Vec3, 20> carried(const std::vector<Vec3> &patch) {
    std::array<Vec3, 20> nodes{};
    const Vec3 up{0, 0, 1};
    for (std::size_t k = 0; k < 4; ++k) {
        nodes[k] = patch[k];
        nodes[4 + k] = patch[k] + up;
        nodes[8 + k] = patch[4 + k];
        nodes[12 + k] = patch[4 + k] + up;
        nodes[16 + k] = patch[k] + 0.5 * up;
    }
    return nodes;
}

TEST(Cusp, OfABlockIsSpoiltAcrossTheTipOnly) {
    // The tip's x axis is straight: dividing it leaves the angle as it is. The arc is along eta.
    EXPECT_EQ(spoilt_by_division(carried(tip(0.41))), (std::array{false, true, false}));
    // Halves of these are good enough.
    EXPECT_EQ(spoilt_by_division(carried(tip(1.0))), (std::array{false, false, false}));
    const auto cube = carried(straight({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}));
    EXPECT_EQ(spoilt_by_division(cube), (std::array{false, false, false}));
}

TEST(Cusp, AKnifeEdgeIsSharpNotStraight) {
    EXPECT_TRUE(ends_in_knife(carried(tip(0.41))));
    // The circle goes straight on as a line.
    const auto on = [](double a) { return Vec3{std::sin(a), 1 - std::cos(a), 0}; };
    auto patch = straight({{{0, 0, 0}, on(0.41), {0, 1, 0}, {-0.4, 0, 0}}});
    patch[4] = on(0.205);
    EXPECT_TRUE(spoilt_by_division(carried(patch))[0]);
    EXPECT_FALSE(ends_in_knife(carried(patch)));
}

TEST(Cusp, EndsOfABlockTakeWhatTheirCornersNeed) {
    const auto nodes = carried(tip(1.0));
    const auto on_circle = [&](std::size_t c, std::size_t d, double f) {
        const bool arc = d == 1 && (c == 0 || c == 4);
        return arc ? Vec3{std::sin(f), 1 - std::cos(f), c == 4 ? 1.0 : 0.0}
                   : edges_of(nodes)(c, d, f);
    };
    const auto shares = shares_of_ends(nodes, on_circle, {6, 6, 2});
    // An arc's chord leaves its tangent by half the angle that it turns by; steps of 0.02.
    EXPECT_NEAR(shares[1][0], 2 * std::asin(0.203), 0.021);
    EXPECT_GE(std::sin(0.5 * shares[1][0]), 0.2);
    EXPECT_EQ(shares[1][1], 0);
    for (const std::size_t d : {0U, 2U}) {
        EXPECT_EQ(shares[d], (std::array{0.0, 0.0}));
    }
    EXPECT_EQ(shares_of_ends(nodes, on_circle, {6, 2, 2})[1][0], 0); // good enough already
}

TEST(Cusp, PatchesByTheThousandAreDividedByTheirTurn) {
    // A strip of many patches of a cylinder, each turning by 30 degrees.
    BlockModel model;
    model.dimension = 2;
    const auto on = [](double a, double z) { return Vec3{std::cos(a), std::sin(a), z}; };
    constexpr double turn = std::numbers::pi / 6;
    for (int k = 0; k < 2000; ++k) {
        const double z = k;
        const double m = z + 0.5;
        for (const Vec3 p : {on(0, z), on(turn, z), on(turn, z + 1), on(0, z + 1), on(turn / 2, z),
                             on(turn, m), on(turn / 2, z + 1), on(0, m)}) {
            model.nodes.push_back(p);
        }
        model.divisions.push_back({1, 1, 0});
    }
    const auto divisions = default_divisions(model, find_topology(model), 10);
    EXPECT_EQ(divisions[0][0], 3);
    EXPECT_EQ(divisions[0][1], 1);
}

} // namespace
