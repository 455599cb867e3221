// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/layout.h"

#include "nmgs/element/hexa20.h"

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Tool.hxx>

#include <gtest/gtest.h>

namespace {

using nmgs::Vec3;
using nmgs::cad::CadShape;
using nmgs::cad::Layout;

TEST(Layout, DividesAClosedEdgeByItsLengthOnce) {
    const CadShape shape = nmgs::cad::make_shape(BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape());
    Layout layout(shape);
    const std::vector<double> thirds{1.0 / 3, 2.0 / 3};
    for (int n = 1; n <= shape.edges.Extent(); ++n) {
        const auto points = layout.divide_edge(shape, n, thirds);
        ASSERT_EQ(points.size(), 4U);
        EXPECT_EQ(layout.divide_edge(shape, n, {}), points);
        const bool closed = BRep_Tool::IsClosed(shape.edge(n));
        EXPECT_EQ(points.front() == points.back(), closed);
        const Vec3 first = layout.points[static_cast<std::size_t>(points[0])];
        const Vec3 second = layout.points[static_cast<std::size_t>(points[1])];
        EXPECT_NEAR(distance(first, second), closed ? std::sqrt(3.0) : 2.0 / 3, 1e-9);
    }
    EXPECT_EQ(layout.points.size(), 2U + 3 * 2U);
}

TEST(Layout, ABoxIsOneBlockWhosePartsLieOnItsEntities) {
    const CadShape shape = nmgs::cad::make_shape(BRepPrimAPI_MakeBox(2.0, 3.0, 5.0).Shape());
    Layout layout(shape);
    for (int n = 1; n <= 12; ++n) {
        layout.divide_edge(shape, n, {});
    }
    Layout::Hexa hexa{{}, 1};
    constexpr std::array<std::array<double, 3>, 8> at{
        {{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}, {0, 0, 5}, {2, 0, 5}, {2, 3, 5}, {0, 3, 5}}};
    for (std::size_t i = 0; i < 8; ++i) {
        for (std::size_t p = 0; p < layout.points.size(); ++p) {
            if (distance(layout.points[p], {at[i][0], at[i][1], at[i][2]}) < 1e-9) {
                hexa.points[i] = static_cast<std::int32_t>(p);
            }
        }
    }
    layout.hexas.push_back(hexa);
    const auto blocks = nmgs::cad::blocks_of(shape, layout, 3);
    ASSERT_EQ(blocks.model.size(), 1U);
    int edges = 0;
    for (int code = 0; code < nmgs::part::count; ++code) {
        const auto on = blocks.binding.of(0, code);
        if (nmgs::part::dimension(code) == 0) {
            EXPECT_EQ(on[0].dimension, 0);
        }
        edges += nmgs::part::dimension(code) == 1 && on.size() == 1 && on[0].dimension == 1;
    }
    EXPECT_EQ(edges, 12);
    const auto nodes = blocks.model.element(0).first<20>();
    EXPECT_NEAR(nmgs::hexa20::jacobian(nodes, 0.3, -0.2, 0.7), 30.0 / 8, 1e-9);
}

} // namespace
