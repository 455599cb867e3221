// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/inner_edges.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS.hxx>
#include <gp_Circ.hxx>

#include <gtest/gtest.h>

#include <numeric>

namespace {

using nmgs::Vec3;
using nmgs::cad::CadShape;

std::size_t at(std::int32_t n) {
    return static_cast<std::size_t>(n);
}

CadShape box_with(const TopoDS_Edge &edge) {
    TopoDS_Shape box = BRepPrimAPI_MakeBox(10.0, 6.0, 4.0).Shape();
    if (!edge.IsNull()) {
        BRep_Builder().Add(box, edge.Oriented(TopAbs_INTERNAL));
    }
    return nmgs::cad::make_shape(box);
}

nmgs::cad::Skin skin_of(const CadShape &shape) {
    std::vector<int> faces(at(shape.faces.Extent()));
    std::iota(faces.begin(), faces.end(), 1);
    return nmgs::cad::make_skin(shape, faces);
}

TEST(InnerEdges, AreNoneInAPlainBox) {
    const CadShape shape = box_with({});
    EXPECT_TRUE(nmgs::cad::inner_edges(shape, 1).empty());
}

TEST(InnerEdges, BecomeChainsOfTheSkin) {
    const CadShape shape =
        box_with(BRepBuilderAPI_MakeEdge(gp_Pnt(2, 3, 2), gp_Pnt(8, 3, 2)).Edge());
    const auto edges = nmgs::cad::inner_edges(shape, 1);
    ASSERT_EQ(edges.size(), 1U);
    const auto skin = skin_of(shape);
    const auto &chain = skin.edges[at(edges[0])];
    // No longer than a sixth of the diagonal, sqrt(152): three segments of two.
    ASSERT_EQ(chain.size(), 4U);
    ASSERT_EQ(skin.parameters[at(edges[0])].size(), 4U);
    for (std::size_t k = 0; k < chain.size(); ++k) {
        const double x = 2 + 2 * static_cast<double>(k);
        EXPECT_NEAR(distance(skin.points[at(chain[k])], Vec3{x, 3, 2}), 0, 1e-9);
        EXPECT_EQ(skin.on[at(chain[k])].dimension, k == 0 || k == 3 ? 0 : 1);
        for (const auto &t : skin.triangles) {
            EXPECT_EQ(std::count(t.begin(), t.end(), chain[k]), 0);
        }
    }
}

TEST(InnerEdges, ThatAreClosedTurnLittleBetweenTheirPoints) {
    const gp_Circ circle(gp_Ax2(gp_Pnt(5, 3, 2), gp_Dir(0, 0, 1)), 1.0);
    const CadShape shape = box_with(BRepBuilderAPI_MakeEdge(circle).Edge());
    const auto edges = nmgs::cad::inner_edges(shape, 1);
    ASSERT_EQ(edges.size(), 1U);
    const auto skin = skin_of(shape);
    const auto &chain = skin.edges[at(edges[0])];
    EXPECT_EQ(chain.front(), chain.back());
    EXPECT_EQ(chain.size() - 1, 14U); // two pi by 0.45
}

} // namespace
