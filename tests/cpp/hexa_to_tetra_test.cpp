// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/convert/hexa_to_tetra.h"

#include "nmgs/blocking/generate.h"
#include "nmgs/element/hexa20.h"
#include "nmgs/support/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <random>

namespace {

using nmgs::Vec3;

struct Split {
    std::vector<Vec3> points;
    std::vector<std::int32_t> tetrahedra;
};

Split split(std::vector<Vec3> points, const std::vector<std::int32_t> &hexahedra) {
    Split result{std::move(points), std::vector<std::int32_t>(6 * hexahedra.size())};
    const std::size_t n = result.points.size();
    const std::vector<Vec3> before = result.points;
    result.points.resize(n + hexahedra.size() / 8);
    nmgs::split_hexahedra(before, hexahedra, static_cast<std::int32_t>(n), result.tetrahedra,
                          {result.points.data() + n, hexahedra.size() / 8});
    return result;
}

std::vector<Vec3> unit_cube() {
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < 8; ++i) {
        const auto p = nmgs::hexa20::natural[i];
        points.push_back({0.5 * (p[0] + 1), 0.5 * (p[1] + 1), 0.5 * (p[2] + 1)});
    }
    return points;
}

double six_volumes(const Split &s, std::size_t t) {
    const auto p = [&](std::size_t i) {
        return s.points[static_cast<std::size_t>(s.tetrahedra[4 * t + i])];
    };
    return nmgs::determinant(p(1) - p(0), p(2) - p(0), p(3) - p(0));
}

TEST(HexaToTetra, TwelveOfEqualVolumeInACube) {
    const auto s = split(unit_cube(), {0, 1, 2, 3, 4, 5, 6, 7});
    ASSERT_EQ(s.tetrahedra.size(), 48U);
    for (std::size_t t = 0; t < 12; ++t) {
        EXPECT_NEAR(six_volumes(s, t), 0.5, 1e-15);
        EXPECT_EQ(s.tetrahedra[4 * t + 3], 8);
    }
    EXPECT_EQ(s.points[8], (Vec3{0.5, 0.5, 0.5}));
}

// A cube has nothing but equal diagonals. Any two of the ways in which two cubes can be numbered
// must agree on their common face.
TEST(HexaToTetra, NeighboursAgreeForEveryNumbering) {
    std::mt19937 random(4);
    for (int round = 0; round < 500; ++round) {
        std::vector<std::int32_t> number(12);
        for (std::size_t i = 0; i < 12; ++i) {
            number[i] = static_cast<std::int32_t>(i);
        }
        std::shuffle(number.begin(), number.end(), random);
        // Nodes of a 2 x 1 x 1 lattice: x + 3 y + 6 z.
        std::vector<Vec3> points(12);
        for (int i = 0; i < 12; ++i) {
            const Vec3 place{static_cast<double>(i % 3), i / 3 % 2 == 0 ? 0.0 : 1.0,
                             i < 6 ? 0.0 : 1.0};
            points[static_cast<std::size_t>(number[static_cast<std::size_t>(i)])] = place;
        }
        std::vector<std::int32_t> hexahedra;
        for (const int x : {0, 1}) {
            // Four of the 24 rotations: about zeta.
            const std::array<int, 4> ring{x, x + 1, x + 4, x + 3};
            const std::size_t turn = random() % 4;
            for (const int z : {0, 6}) {
                for (std::size_t i = 0; i < 4; ++i) {
                    const int node = ring[(i + turn) % 4] + z;
                    hexahedra.push_back(number[static_cast<std::size_t>(node)]);
                }
            }
        }
        const auto s = split(points, hexahedra);
        std::map<std::array<std::int32_t, 3>, int> uses;
        for (std::size_t t = 0; t < 24; ++t) {
            EXPECT_GT(six_volumes(s, t), 0);
            for (std::size_t skip = 0; skip < 4; ++skip) {
                std::array<std::int32_t, 3> face{};
                for (std::size_t i = 0, k = 0; i < 4; ++i) {
                    if (i != skip) {
                        face[k++] = s.tetrahedra[4 * t + i];
                    }
                }
                std::sort(face.begin(), face.end());
                ++uses[face];
            }
        }
        // 24 * 4 faces, of which 20 are outside: 10 quads of two triangles.
        EXPECT_EQ(
            std::count_if(uses.begin(), uses.end(), [](const auto &u) { return u.second == 1; }),
            20);
        EXPECT_EQ(uses.size(), 20U + (24U * 4 - 20) / 2);
    }
}

TEST(HexaToTetra, ShorterDiagonalOnEachFace) {
    auto points = unit_cube();
    points[6] = {1.4, 1.3, 1.2}; // farther from 3, 1 and 4: their faces avoid node 6
    const auto s = split(points, {0, 1, 2, 3, 4, 5, 6, 7});
    for (const auto &[a, b] : {std::pair{2, 5}, {2, 7}, {5, 7}}) {
        bool found = false;
        for (std::size_t t = 0; t < 12; ++t) {
            const auto *tetra = s.tetrahedra.data() + 4 * t;
            found = found ||
                    (std::count(tetra, tetra + 4, a) == 1 && std::count(tetra, tetra + 4, b) == 1);
        }
        EXPECT_TRUE(found) << a << "-" << b;
    }
}

TEST(HexaToTetra, SameBytesForAnyNumberOfThreads) {
    nmgs::BlockModel model;
    for (const auto &p : nmgs::hexa20::natural) {
        model.nodes.push_back({p[0] + 0.1 * p[1] * p[1], p[1], p[2]});
    }
    model.divisions.push_back({31, 29, 23});
    const auto mesh = nmgs::generate(model);
    const std::vector<Vec3> points(mesh.points.begin(), mesh.points.end());
    const std::vector<std::int32_t> cells(mesh.cells[0].nodes.begin(), mesh.cells[0].nodes.end());
    nmgs::set_threads(1);
    const auto one = split(points, cells);
    nmgs::set_threads(5);
    const auto five = split(points, cells);
    nmgs::set_threads(0);
    EXPECT_EQ(one.tetrahedra, five.tetrahedra);
    EXPECT_EQ(std::memcmp(one.points.data(), five.points.data(), 24 * one.points.size()), 0);
}

} // namespace
