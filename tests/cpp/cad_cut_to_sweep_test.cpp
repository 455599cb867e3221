// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/cut_to_sweep.h"
#include "nmgs_cad/feature_boxes.h"
#include "nmgs_cad/imprint_sweeps.h"
#include "nmgs_cad/inner_faces.h"

#include "cad_filling.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include <cmath>
#include <numbers>

namespace {

using namespace nmgs::cad;

constexpr double pi = std::numbers::pi;

TopoDS_Shape box(double x, double y, double z) {
    return BRepPrimAPI_MakeBox(x, y, z).Shape();
}
TopoDS_Shape cylinder(const gp_Pnt &p, const gp_Dir &axis, double radius, double height) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2(p, axis), radius, height).Shape();
}
TopoDS_Shape cut(const TopoDS_Shape &a, const TopoDS_Shape &b) {
    return BRepAlgoAPI_Cut(a, b).Shape();
}

// A block with a bore from the top and another from the side that do not meet.
TopoDS_Shape block_with_bores() {
    return cut(cut(box(60, 40, 20), cylinder({12, 20, 0}, {0, 0, 1}, 5, 20)),
               cylinder({40, 0, 10}, {0, 1, 0}, 4, 40));
}

TEST(Sweepability, CountsWhatCrossesTheSweep) {
    const CadShape shape = make_shape(block_with_bores());
    const Sweepability found = sweepability(shape, 1);
    EXPECT_EQ(found.cost, 1); // one bore or the other
    ASSERT_FALSE(found.directions.empty());
    EXPECT_EQ(found.directions.front().faces.size(), 1U);
    EXPECT_EQ(sweepability(make_shape(box(1, 2, 3)), 1).cost, 0);
    EXPECT_EQ(sweepability(make_shape(cylinder({0, 0, 0}, {0, 0, 1}, 1, 2)), 1).cost, 0);
}

// A rounded edge between a boss and its plate is neither wall nor cap; without it all is swept.
TEST(Sweepability, CountsWhatIsRoundedAcrossTheSweep) {
    const TopoDS_Shape sharp =
        BRepAlgoAPI_Fuse(cut(box(60, 40, 20), cylinder({8, 8, 0}, {0, 0, 1}, 3, 20)),
                         cylinder({35, 20, 20}, {0, 0, 1}, 8, 12))
            .Shape();
    EXPECT_EQ(sweepability(make_shape(sharp), 1).cost, 0);
    BRepFilletAPI_MakeFillet fillet(sharp);
    for (TopExp_Explorer it(sharp, TopAbs_EDGE); it.More(); it.Next()) {
        const BRepAdaptor_Curve curve(TopoDS::Edge(it.Current()));
        if (curve.GetType() == GeomAbs_Circle && std::abs(curve.Circle().Radius() - 8) < 1e-9 &&
            std::abs(curve.Circle().Location().Z() - 20) < 1e-9) {
            fillet.Add(2, TopoDS::Edge(it.Current()));
            break;
        }
    }
    const CadShape rounded = make_shape(fillet.Shape());
    EXPECT_GT(sweepability(rounded, 1).cost, 0);
    const auto result = fill_all(&fill_cut_to_sweep, rounded);
    ASSERT_TRUE(result.filled) << result.refusal.reason;
    EXPECT_GT(result.worst, 0.2);
}

// A rib has no height at its tip: it is swept sideways, and the plate with its hole from the top.
TEST(Sweepability, CountsWallsThatRunOutToNothing) {
    BRepBuilderAPI_MakePolygon corners(gp_Pnt(5, 18, 20), gp_Pnt(30, 18, 20), gp_Pnt(5, 18, 40));
    corners.Close();
    const TopoDS_Shape rib =
        BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(corners.Wire()).Face(), gp_Vec(0, 4, 0))
            .Shape();
    const TopoDS_Shape plate = cut(box(60, 40, 20), cylinder({45, 20, 0}, {0, 0, 1}, 6, 20));
    const CadShape ribbed = make_shape(BRepAlgoAPI_Fuse(plate, rib).Shape());
    EXPECT_EQ(sweepability(make_shape(plate), 1).cost, 0);
    EXPECT_GT(sweepability(ribbed, 1).cost, 0);
    const auto result = fill_all(&fill_cut_to_sweep, ribbed);
    ASSERT_TRUE(result.filled) << result.refusal.reason;
    EXPECT_GT(result.worst, 0.2);
}

// Two solids that meet at the plane x = 20: the one swept along z, the other along y with a level
// at y = 15 that the first knows nothing of.
TEST(ImprintSweeps, DrawsTheLevelsOfOneSideForTheOther) {
    const TopoDS_Shape first = cut(box(20, 40, 20), cylinder({10, 20, 0}, {0, 0, 1}, 4, 20));
    TopoDS_Shape second = cut(cut(BRepPrimAPI_MakeBox(gp_Pnt(20, 0, 0), 40, 40, 20).Shape(),
                                  BRepPrimAPI_MakeBox(gp_Pnt(50, 15, 0), 20, 30, 20).Shape()),
                              cylinder({35, 0, 10}, {0, 1, 0}, 4, 40));
    const CadShape shape = make_shape(BRepAlgoAPI_Fuse(first, second).Shape());
    ASSERT_EQ(shape.solids.Extent(), 1);
    TopTools_ListOfShape tools;
    tools.Append(
        BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(20, 0, 0), gp_Dir(1, 0, 0)), -99, 99, -99, 99)
            .Face());
    Refusal refusal;
    const std::vector<int> solids{1};
    const auto pieces = split(shape, solids, tools, refusal);
    ASSERT_TRUE(pieces) << refusal.reason;
    ASSERT_EQ(inner_faces(pieces->cad).size(), 1U);
    const auto drawn = imprint_sweeps(shape, *pieces);
    ASSERT_TRUE(drawn);
    EXPECT_EQ(drawn->cad.solids.Extent(), 2);
    EXPECT_EQ(inner_faces(drawn->cad).size(), 2U);
    EXPECT_FALSE(imprint_sweeps(shape, *drawn)); // all is there
    const auto result = fill_all(&fill_cut_to_sweep, shape);
    ASSERT_TRUE(result.filled) << result.refusal.reason;
    EXPECT_GT(result.worst, 0.2);
}

TEST(FeatureBoxes, KeepTheirDistanceFromTheBore) {
    const CadShape shape = make_shape(block_with_bores());
    const SweepDirection worst = sweepability(shape, 1).directions.front();
    const auto boxes = feature_boxes(shape, 1, worst, 0.25);
    ASSERT_FALSE(boxes.empty());
    EXPECT_EQ(boxes.front().faces.Extent(), 6);
    // Nothing in the way, no box.
    EXPECT_TRUE(feature_boxes(shape, 1, {worst.along, {}, 0}, 0.25).empty());
}

TEST(CutToSweep, BoresThatPassEachOther) {
    const auto result = fill_all(&fill_cut_to_sweep, make_shape(block_with_bores()));
    ASSERT_TRUE(result.filled) << result.refusal.reason;
    EXPECT_GT(result.worst, 0.2);
    const double volume = 60 * 40 * 20 - pi * 25 * 20 - pi * 16 * 40;
    EXPECT_NEAR(result.volume, volume, 0.01 * volume);
}

TEST(CutToSweep, ShaftWithAPinHole) {
    const auto result =
        fill_all(&fill_cut_to_sweep, make_shape(cut(cylinder({0, 0, 0}, {1, 0, 0}, 10, 60),
                                                    cylinder({30, 0, -30}, {0, 0, 1}, 3, 60))));
    ASSERT_TRUE(result.filled) << result.refusal.reason;
    EXPECT_GT(result.worst, 0.2);
}

TEST(CutToSweep, ShaftWithAStubOnEitherSide) {
    TopoDS_Shape shape = cylinder({-5, 0, 0}, {1, 0, 0}, 2, 10);
    shape = BRepAlgoAPI_Fuse(shape, cylinder({0, -5, 0}, {0, 1, 0}, 1, 10)).Shape();
    const auto result = fill_all(&fill_cut_to_sweep, make_shape(shape));
    ASSERT_TRUE(result.filled) << result.refusal.reason;
    EXPECT_GT(result.worst, 0.2);
}

// The levels beside the bottom of the hole go with those of the neighbour.
TEST(CutToSweep, BlindHoleFromTheSide) {
    const TopoDS_Shape shape = cut(cut(box(60, 40, 20), cylinder({12, 20, 0}, {0, 0, 1}, 5, 20)),
                                   cylinder({35, 0, 10}, {0, 1, 0}, 4, 15));
    const auto result = fill_all(&fill_cut_to_sweep, make_shape(shape));
    ASSERT_TRUE(result.filled) << result.refusal.reason;
    EXPECT_GT(result.worst, 0.2);
}

TEST(CutToSweep, RefusesWhatNeedsNoCut) {
    const auto result = fill_all(&fill_cut_to_sweep, make_shape(box(1, 2, 3)));
    EXPECT_FALSE(result.filled);
}

} // namespace
