// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/layout_quality.h"
#include "nmgs_cad/solid_layout.h"
#include "nmgs_cad/sweep.h"

#include "cad_filling.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>

#include <numbers>

namespace {

using nmgs::cad::fill_all;
using nmgs::cad::fill_sweep;
using nmgs::cad::make_shape;
using std::numbers::pi;

void expect_filled(const TopoDS_Shape &shape, double volume, double worst, double tolerance) {
    const auto result = fill_all(&fill_sweep, make_shape(shape));
    ASSERT_TRUE(result.filled) << result.refusal.reason;
    EXPECT_GT(result.worst, worst);
    EXPECT_NEAR(result.volume, volume, tolerance * volume);
}

TopoDS_Wire regular_polygon(int corners, double radius, double z) {
    BRepBuilderAPI_MakePolygon polygon;
    for (int i = 0; i < corners; ++i) {
        const double a = 2 * pi * i / corners;
        polygon.Add(gp_Pnt(radius * std::cos(a), radius * std::sin(a), z));
    }
    polygon.Close();
    return polygon.Wire();
}

TEST(Sweep, SixSidedPrism) {
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(regular_polygon(6, 2.0, 0.0));
    expect_filled(BRepPrimAPI_MakePrism(face, gp_Vec(0, 0, 3)).Shape(), 18 * std::sqrt(3.0), 0.5,
                  1e-6);
}
TEST(Sweep, PlateWithAHoleAndABoss) {
    const TopoDS_Shape plate = BRepPrimAPI_MakeBox(10.0, 6.0, 1.0).Shape();
    const TopoDS_Shape hole =
        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(2.5, 3, 0), gp::DZ()), 1.0, 1.0).Shape();
    const TopoDS_Shape boss =
        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(7, 3, 1), gp::DZ()), 1.5, 2.0).Shape();
    const TopoDS_Shape drilled = BRepAlgoAPI_Cut(plate, hole).Shape();
    expect_filled(BRepAlgoAPI_Fuse(drilled, boss).Shape(), 60 - pi + 4.5 * pi, 0.2, 0.01);
}
TEST(Sweep, PocketThatDoesNotGoThrough) {
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(4.0, 4.0, 3.0).Shape();
    const TopoDS_Shape pocket = BRepPrimAPI_MakeBox(gp_Pnt(1, 1, 2), 2.0, 2.0, 1.0).Shape();
    expect_filled(BRepAlgoAPI_Cut(block, pocket).Shape(), 44, 0.5, 1e-6);
}
// Caps that are not across the sweep: a level follows the top and its chamfer.
TEST(Sweep, ChamferedTop) {
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(4.0, 4.0, 3.0).Shape();
    BRepBuilderAPI_MakePolygon wedge(gp_Pnt(4, 0, 2), gp_Pnt(4, 0, 3), gp_Pnt(3, 0, 3),
                                     Standard_True);
    const TopoDS_Shape cut =
        BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wedge.Wire()).Face(), gp_Vec(0, 2, 0))
            .Shape();
    expect_filled(BRepAlgoAPI_Cut(block, cut).Shape(), 47, 0.2, 1e-6);
}
// What sweeping alone makes of it hangs on the order of its vertices; that no folded blocks come
// out of it, and that some strategy fills it well, does not.
TEST(Sweep, CountersunkHole) {
    const TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(-3, -3, 0), 6.0, 6.0, 2.0).Shape();
    const TopoDS_Shape hole = BRepPrimAPI_MakeCylinder(0.7, 2.0).Shape();
    const TopoDS_Shape sink =
        BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(0, 0, 1.5), gp::DZ()), 0.7, 1.2, 0.5).Shape();
    const TopoDS_Shape drilled = BRepAlgoAPI_Cut(plate, hole).Shape();
    const double cone = pi * 0.5 / 3 * (0.49 + 0.84 + 1.44);
    const auto shape = nmgs::cad::make_shape(BRepAlgoAPI_Cut(drilled, sink).Shape());
    nmgs::cad::Layout layout(shape);
    const std::vector<int> solids{1};
    const auto report = nmgs::cad::layout_solids(shape, solids, layout);
    ASSERT_FALSE(report[0].method.empty()) << report[0].reason;
    const auto quality = nmgs::cad::layout_quality(shape, layout, 0, 6);
    const double volume = 72 - 1.5 * 0.49 * pi - cone;
    EXPECT_GT(quality.worst, 0.2);
    EXPECT_NEAR(quality.volume, volume, 0.01 * volume);
    nmgs::cad::Layout swept(shape);
    nmgs::cad::Refusal refusal;
    if (nmgs::cad::fill_sweep(shape, 1, swept, {}, refusal, {})) {
        EXPECT_GT(nmgs::cad::layout_quality(shape, swept).worst, 0.0);
    } else {
        EXPECT_FALSE(refusal.reason.empty());
    }
}
TEST(Sweep, QuarterOfABentPipeRod) {
    expect_filled(BRepPrimAPI_MakeTorus(5.0, 1.0, pi / 2).Shape(), 2.5 * pi * pi, 0.4, 0.02);
}
TEST(Sweep, FrustumOfASixSidedPyramid) {
    BRepOffsetAPI_ThruSections loft(Standard_True, Standard_True);
    loft.AddWire(regular_polygon(6, 2.0, 0.0));
    loft.AddWire(regular_polygon(6, 1.0, 3.0));
    loft.Build();
    const double base = 6 * std::sqrt(3.0);
    expect_filled(loft.Shape(), 3.0 / 3 * (base + 0.25 * base + 0.5 * base), 0.4, 1e-3);
}
// A neighbour has laid the common face out: its points are taken over.
TEST(Sweep, SharesTheNodesOfAFaceWithItsNeighbour) {
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(regular_polygon(5, 2.0, 0.0));
    const TopoDS_Shape up = BRepPrimAPI_MakePrism(face, gp_Vec(0, 0, 1)).Shape();
    const TopoDS_Shape down = BRepPrimAPI_MakePrism(face, gp_Vec(0, 0, -2)).Shape();
    TopoDS_Compound both;
    const BRep_Builder builder;
    builder.MakeCompound(both);
    builder.Add(both, up);
    builder.Add(both, down);
    const auto shape = make_shape(both);
    ASSERT_EQ(shape.faces.Extent(), 13); // one is common
    const auto result = fill_all(&fill_sweep, shape, 2);
    ASSERT_TRUE(result.filled) << result.refusal.reason;
    EXPECT_NEAR(result.volume, 3 * 2.5 * 4 * std::sin(2 * pi / 5), 1e-6);
}
TEST(Sweep, RefusesABallAndSaysWhy) {
    const auto result = fill_all(&fill_sweep, make_shape(BRepPrimAPI_MakeSphere(1.0).Shape()));
    EXPECT_FALSE(result.filled);
    EXPECT_EQ(result.refusal.blockers, std::vector<std::string>{"Solid1"});
}

} // namespace
