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
