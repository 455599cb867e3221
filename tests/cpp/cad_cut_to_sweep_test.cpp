// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/cut_to_sweep.h"
#include "nmgs_cad/feature_boxes.h"

#include "cad_filling.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <gp_Ax2.hxx>

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
