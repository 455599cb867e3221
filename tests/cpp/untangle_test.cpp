// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/quality/untangle.h"

#include "nmgs/quality/volume_metrics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace {

using namespace nmgs;
using Hexa = std::array<std::int32_t, 8>;
using Quad = std::array<std::int32_t, 4>;

// A lattice of n cells a side in the unit cube or, flat, in the unit square. Nodes on its rim are
// fixed, the others free; of a flat one they keep to z = 0.
struct Grid final : NodeSlides {
    int n;
    bool flat;
    std::vector<Vec3> points;
    std::vector<Hexa> hexahedra;
    std::vector<Quad> quads;

    Grid(int cells, bool in_plane) : n(cells), flat(in_plane) {
        for (int k = 0; k <= (flat ? 0 : n); ++k) {
            for (int j = 0; j <= n; ++j) {
                for (int i = 0; i <= n; ++i) {
                    points.push_back({static_cast<double>(i) / n, static_cast<double>(j) / n,
                                      static_cast<double>(k) / n});
                }
            }
        }
        const auto at = [&](int i, int j, int k) { return i + (n + 1) * (j + (n + 1) * k); };
        for (int k = 0; k < (flat ? 1 : n); ++k) {
            for (int j = 0; j < n; ++j) {
                for (int i = 0; i < n; ++i) {
                    if (flat) {
                        quads.push_back(
                            {at(i, j, 0), at(i + 1, j, 0), at(i + 1, j + 1, 0), at(i, j + 1, 0)});
                    } else {
                        hexahedra.push_back({at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k),
                                             at(i, j + 1, k), at(i, j, k + 1), at(i + 1, j, k + 1),
                                             at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1)});
                    }
                }
            }
        }
    }
    [[nodiscard]] int freedom(std::int32_t node) const override {
        const auto inner = [&](int i) { return i > 0 && i < n; };
        const int i = node % (n + 1);
        const int j = node / (n + 1) % (n + 1);
        const int k = node / (n + 1) / (n + 1);
        return !inner(i) || !inner(j) || !(flat || inner(k)) ? 0 : flat ? 2 : 3;
    }
    std::array<Vec3, 2> tangents(std::int32_t, Vec3) override {
        return {Vec3{1, 0, 0}, Vec3{0, 1, 0}};
    }
    Vec3 slide(std::int32_t, Vec3, Vec3 wanted) override { return {wanted.x, wanted.y, 0}; }
    Vec3 normal(std::int32_t, Vec3) override { return {0, 0, 1}; }

    void shake(double by) {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> off(-by, by);
        for (std::size_t p = 0; p < points.size(); ++p) {
            if (freedom(static_cast<std::int32_t>(p)) > 0) {
                points[p] += Vec3{off(random), off(random), flat ? 0 : off(random)};
            }
        }
    }
    UntangleResult run() { return untangle(points, hexahedra, quads, *this); }
    [[nodiscard]] double worst() const {
        double least = 1;
        for (const Hexa &h : hexahedra) {
            std::array<Vec3, 8> p{};
            for (std::size_t k = 0; k < 8; ++k) {
                p[k] = points[static_cast<std::size_t>(h[k])];
            }
            least = std::min(least, hexahedron::scaled_jacobian(p.data()));
        }
        return least;
    }
};

TEST(Untangle, AShakenLatticeOfCubesComesBack) {
    Grid grid(5, false);
    grid.shake(0.3); // more than a cell
    ASSERT_LT(grid.worst(), -0.3);
    const auto result = grid.run();
    EXPECT_GT(grid.worst(), 0.9); // the lattice itself has 1
    EXPECT_NEAR(result.after, grid.worst(), 0.05);
    for (std::size_t p = 0; p < grid.points.size(); ++p) {
        if (grid.freedom(static_cast<std::int32_t>(p)) == 0) {
            EXPECT_EQ(grid.points[p], Grid(5, false).points[p]);
        }
    }
}

TEST(Untangle, AShakenLatticeOfSquaresComesBack) {
    Grid grid(6, true);
    grid.shake(0.25);
    const auto result = grid.run();
    EXPECT_LT(result.before, 0);
    EXPECT_GT(result.after, 0.9);
    for (const Vec3 p : grid.points) {
        EXPECT_EQ(p.z, 0);
    }
}

TEST(Untangle, WhatIsPerfectStays) {
    Grid grid(3, false);
    const auto before = grid.points;
    EXPECT_NEAR(grid.run().after, 1, 1e-12);
    for (std::size_t p = 0; p < before.size(); ++p) {
        EXPECT_LT(distance(grid.points[p], before[p]), 1e-6);
    }
}

TEST(Untangle, WhatCannotBeMendedIsNotMadeWorse) {
    Grid grid(2, false);
    grid.points[0] = {2, 2, 2}; // a fixed corner beyond the opposite one
    const auto result = grid.run();
    EXPECT_LT(result.before, 0);
    EXPECT_GE(result.after, result.before);
}

TEST(Untangle, TheSameInputGivesTheSameBytes) {
    Grid first(4, false);
    first.shake(0.3);
    Grid second(4, false);
    second.shake(0.3);
    first.run();
    second.run();
    EXPECT_TRUE(std::equal(first.points.begin(), first.points.end(), second.points.begin()));
}

TEST(Untangle, ThinCellsStayThin) {
    Grid grid(4, false);
    for (Vec3 &p : grid.points) {
        p.z *= 1e-3 * (1 + p.z); // graded layers
    }
    const auto flat = grid.points;
    const std::size_t centre = 2 + 5 * (2 + 5 * 2);
    grid.points[centre].z = 2 * flat[centre].z; // through the next layer
    ASSERT_LT(grid.worst(), 0);
    grid.run();
    EXPECT_GT(grid.worst(), 0.9);
    EXPECT_LT(grid.points[centre].z, grid.points[centre + 25].z);
    EXPECT_GT(grid.points[centre].z, grid.points[centre - 25].z);
}

} // namespace
