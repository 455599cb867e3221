// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/submap.h"

#include "cad_layout_checks.h"

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepAlgoAPI_Splitter.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <TopTools_ListOfShape.hxx>
#include <gp_Ax1.hxx>
#include <gp_Pln.hxx>

namespace {

using namespace nmgs::cad;

TopoDS_Shape box(double x, double y, double z, double dx, double dy, double dz) {
    return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), dx, dy, dz).Shape();
}

// An upright prism over a polygon.
TopoDS_Shape prism(const std::vector<std::array<double, 2>> &corners, double height) {
    BRepBuilderAPI_MakePolygon polygon;
    for (const auto &c : corners) {
        polygon.Add(gp_Pnt(c[0], c[1], 0));
    }
    polygon.Close();
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(polygon.Wire()).Shape(),
                                 gp_Vec(0, 0, height))
        .Shape();
}

Layout filled(const CadShape &shape, const LayoutOptions &options = {}) {
    Layout layout(shape);
    for (int n = 1; n <= shape.solids.Extent(); ++n) {
        Refusal refusal;
        EXPECT_TRUE(fill_submap(shape, n, layout, options, refusal, {})) << refusal.reason;
    }
    return layout;
}

TEST(Submap, ABoxIsOneBlock) {
    const CadShape shape = make_shape(box(0, 0, 0, 2, 3, 5));
    const Layout layout = filled(shape);
    EXPECT_EQ(layout.hexas.size(), 1U);
    expect_sound(shape, layout, 1e-9);
}

TEST(Submap, SizeAsksForShorterSegments) {
    const CadShape shape = make_shape(box(0, 0, 0, 2, 3, 5));
    const Layout layout = filled(shape, {1.0, std::numbers::pi / 2});
    EXPECT_EQ(layout.hexas.size(), 30U);
    expect_sound(shape, layout, 1e-9);
}

TEST(Submap, LAndTAndUAndStairs) {
    struct Case {
        std::vector<std::array<double, 2>> corners;
        std::size_t blocks;
    };
    const std::vector<Case> cases{
        {{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}}, 3},
        {{{0, 2}, {0, 1}, {1, 1}, {1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}}, 4},
        {{{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 5},
        {{{0, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 3}, {0, 3}}, 6}};
    for (const auto &c : cases) {
        const CadShape shape = make_shape(prism(c.corners, 1.5));
        const Layout layout = filled(shape);
        EXPECT_EQ(layout.hexas.size(), c.blocks);
        expect_sound(shape, layout, 1e-9);
    }
}

TEST(Submap, PocketAndHoleAndCavityWalls) {
    const TopoDS_Shape block = box(0, 0, 0, 5, 4, 3);
    const CadShape pocket = make_shape(BRepAlgoAPI_Cut(block, box(1, 1, 2, 2, 1.5, 2)).Shape());
    EXPECT_EQ(filled(pocket).hexas.size(), 17U);
    expect_sound(pocket, filled(pocket), 1e-9);
    const CadShape hole = make_shape(BRepAlgoAPI_Cut(block, box(1, 1, -1, 2, 1.5, 9)).Shape());
    EXPECT_EQ(filled(hole).hexas.size(), 8U);
    expect_sound(hole, filled(hole), 1e-9);
    const CadShape cross =
        make_shape(BRepAlgoAPI_Cut(BRepAlgoAPI_Cut(block, box(1, 1, -1, 2, 1.5, 9)).Shape(),
                                   box(-1, 1.5, 1, 9, 1, 1))
                       .Shape());
    expect_sound(cross, filled(cross), 1e-9);
}

TEST(Submap, SkewedSidesStillFill) {
    // A frustum with a step: no two sides parallel.
    const CadShape shape =
        make_shape(prism({{0, 0}, {4.3, 0.2}, {4, 1.2}, {1.3, 1}, {1, 3.1}, {-0.2, 3}}, 2));
    const Layout layout = filled(shape);
    EXPECT_EQ(layout.hexas.size(), 3U);
    expect_sound(shape, layout, 1e-9);
}

TEST(Submap, FacesSplitInTwoAreCoveredWithTheirEdges) {
    BRepAlgoAPI_Splitter splitter;
    TopTools_ListOfShape arguments;
    TopTools_ListOfShape tools;
    arguments.Append(box(0, 0, 0, 2, 2, 2));
    tools.Append(BRepBuilderAPI_MakeEdge(gp_Pnt(0.7, 0, 2), gp_Pnt(0.7, 2, 2)).Shape());
    tools.Append(BRepBuilderAPI_MakeEdge(gp_Pnt(2, 0, 1.2), gp_Pnt(2, 2, 1.2)).Shape());
    splitter.SetArguments(arguments);
    splitter.SetTools(tools);
    splitter.Build();
    const CadShape shape = make_shape(splitter.Shape());
    ASSERT_EQ(shape.faces.Extent(), 8);
    const Layout layout = filled(shape);
    EXPECT_EQ(layout.hexas.size(), 4U);
    expect_sound(shape, layout, 1e-9);
}

TEST(Submap, ABentBarHasCurvedBlocks) {
    // A quarter of a turn, and three quarters, of a square section with a notch.
    for (const double angle : {0.5, 1.5}) {
        BRepBuilderAPI_MakePolygon section;
        for (const auto &[x, z] :
             std::vector<std::array<double, 2>>{{2, 0}, {4, 0}, {4, 1}, {3, 1}, {3, 2}, {2, 2}}) {
            section.Add(gp_Pnt(x, 0, z));
        }
        section.Close();
        const CadShape shape =
            make_shape(BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(section.Wire()).Shape(),
                                             gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), angle * M_PI)
                           .Shape());
        const Layout layout = filled(shape);
        EXPECT_EQ(layout.hexas.size(), angle == 0.5 ? 3U : 9U);
        expect_sound(shape, layout, 1.3e-2); // a quadratic through 90 degrees of an arc: 1.18 %
    }
}

TEST(Submap, NeighboursShareTheirPoints) {
    BRepAlgoAPI_Splitter splitter;
    TopTools_ListOfShape arguments;
    TopTools_ListOfShape tools;
    arguments.Append(prism({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}}, 1.5));
    tools.Append(BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 0.6), gp_Dir(0, 0, 1))).Shape());
    splitter.SetArguments(arguments);
    splitter.SetTools(tools);
    splitter.Build();
    const CadShape shape = make_shape(splitter.Shape());
    ASSERT_EQ(shape.solids.Extent(), 2);
    expect_sound(shape, filled(shape), 1e-9);
}

TEST(Submap, RefusesWhatHasNoCorners) {
    const TopoDS_Shape round = BRepPrimAPI_MakeCylinder(1, 2).Shape();
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(1).Shape();
    const TopoDS_Shape holed =
        BRepAlgoAPI_Cut(box(-2, -2, 0, 4, 4, 1), BRepPrimAPI_MakeCylinder(1, 2).Shape()).Shape();
    for (const TopoDS_Shape &s : {round, ball, holed, prism({{0, 0}, {1, 0}, {0, 1}}, 1)}) {
        const CadShape shape = make_shape(s);
        Layout layout(shape);
        Refusal refusal;
        EXPECT_FALSE(fill_submap(shape, 1, layout, {}, refusal, {}));
        EXPECT_FALSE(refusal.reason.empty());
        EXPECT_FALSE(refusal.blockers.empty());
        EXPECT_TRUE(layout.points.empty());
        EXPECT_TRUE(layout.hexas.empty());
    }
}

} // namespace
