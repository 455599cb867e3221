// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/midpoint.h"

#include "nmgs_cad/layout_quality.h"
#include "nmgs_cad/solid_layout.h"

#include <BOPAlgo_Builder.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <TopoDS.hxx>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using nmgs::cad::CadShape;
using nmgs::cad::Layout;
using nmgs::cad::Refusal;

TopoDS_Face polygon(const std::vector<gp_Pnt> &points) {
    BRepBuilderAPI_MakePolygon wire;
    for (const gp_Pnt &p : points) {
        wire.Add(p);
    }
    wire.Close();
    return BRepBuilderAPI_MakeFace(wire.Wire()).Face();
}

TopoDS_Shape polyhedron(const std::vector<gp_Pnt> &points,
                        const std::vector<std::vector<std::size_t>> &faces) {
    BRepBuilderAPI_Sewing sewing;
    for (const auto &face : faces) {
        std::vector<gp_Pnt> corners;
        for (const auto n : face) {
            corners.push_back(points[n]);
        }
        sewing.Add(polygon(corners));
    }
    sewing.Perform();
    return BRepBuilderAPI_MakeSolid(TopoDS::Shell(sewing.SewedShape())).Solid();
}

bool fill(const CadShape &shape, Layout &layout, Refusal &refusal) {
    return nmgs::cad::fill_midpoint(shape, 1, layout, {}, refusal, {});
}

// Four bricks in a tetrahedron whose corners are a cube's: at a corner of the tetrahedron the three
// edges meet at 60 degrees, whose determinant is 1 / sqrt 2.
TEST(MidPoint, ARegularTetrahedronIsFourHexahedra) {
    const CadShape shape =
        nmgs::cad::make_shape(polyhedron({{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}},
                                         {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}));
    Layout layout(shape);
    Refusal refusal;
    ASSERT_TRUE(fill(shape, layout, refusal)) << refusal.reason;
    EXPECT_EQ(layout.hexas.size(), 4U);
    EXPECT_EQ(layout.quads.size(), 12U);
    EXPECT_EQ(layout.points.size(), 4U + 6U + 4U + 1U);
    const auto quality = nmgs::cad::layout_quality(shape, layout, 0, 1);
    EXPECT_NEAR(quality.worst, std::sqrt(0.5), 1e-9);
    EXPECT_NEAR(quality.volume, 1.0 / 3, 1e-9);
}

TEST(MidPoint, AnEighthOfABallIsFilledOntoItsSphere) {
    // Three planes and a sphere: three edges meet at each of the four corners.
    const CadShape box = nmgs::cad::make_shape(BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape());
    // Its poles and its seam are away from the box.
    const gp_Ax2 axes(gp_Pnt(0, 0, 0), gp_Dir(1, -1, 0), gp_Dir(-1, -1, -1));
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(axes, 1.0).Shape();
    BOPAlgo_Builder builder;
    builder.AddArgument(box.shape);
    builder.AddArgument(ball);
    builder.Perform();
    const CadShape pieces = nmgs::cad::make_shape(builder.Shape());
    int filled = 0;
    for (int n = 1; n <= pieces.solids.Extent(); ++n) {
        Layout layout(pieces);
        Refusal refusal;
        if (!nmgs::cad::fill_midpoint(pieces, n, layout, {}, refusal, {})) {
            continue;
        }
        const auto quality = nmgs::cad::layout_quality(pieces, layout, 0, 8);
        if (std::abs(quality.volume - std::numbers::pi / 6) < 0.01) {
            ++filled;
            EXPECT_EQ(layout.hexas.size(), 4U);
            EXPECT_GT(quality.worst, 0.3);
        }
    }
    EXPECT_EQ(filled, 1);
}

TEST(MidPoint, RefusesWhereFourEdgesMeetAndNamesTheVertex) {
    const CadShape shape = nmgs::cad::make_shape(polyhedron(
        {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
        {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}));
    Layout layout(shape);
    Refusal refusal;
    EXPECT_FALSE(fill(shape, layout, refusal));
    ASSERT_EQ(refusal.blockers.size(), 1U);
    EXPECT_EQ(refusal.blockers[0].substr(0, 6), "Vertex");
    EXPECT_NE(refusal.reason.find("4 edges"), std::string::npos);
}

TEST(MidPoint, RefusesASeam) {
    const CadShape shape = nmgs::cad::make_shape(BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape());
    Layout layout(shape);
    Refusal refusal;
    EXPECT_FALSE(fill(shape, layout, refusal));
    EXPECT_FALSE(refusal.blockers.empty());
}

// A cube and a prism on it: mapped alone would leave the cube whole, which the prism's face does
// not allow.
TEST(SolidLayout, SolidsThatShareAFaceShareItsPoints) {
    const TopoDS_Shape cube = BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape();
    const TopoDS_Shape prism =
        BRepPrimAPI_MakePrism(polygon({{0, 0, 1}, {1, 0, 1}, {0.5, 0, 2}}), gp_Vec(0, 1, 0))
            .Shape();
    BOPAlgo_Builder builder;
    builder.AddArgument(cube);
    builder.AddArgument(prism);
    builder.Perform();
    const CadShape shape = nmgs::cad::make_shape(builder.Shape());
    ASSERT_EQ(shape.solids.Extent(), 2);
    Layout layout(shape);
    const std::vector<int> solids{1, 2};
    const auto report = nmgs::cad::layout_solids(shape, solids, layout);
    for (const auto &entry : report) {
        EXPECT_FALSE(entry.method.empty()) << entry.reason;
    }
    EXPECT_EQ(layout.hexas.size(), 8U + 6U);
    const auto quality = nmgs::cad::layout_quality(shape, layout, 0, 2);
    EXPECT_NEAR(quality.volume, 1.5, 1e-9);
    EXPECT_GT(quality.worst, 0.3);
    // Eight and six hexahedra of 27 and 21 points, of which the nine on the common face are one.
    EXPECT_EQ(layout.points.size(), 27U + 21U - 9U);
}

} // namespace
