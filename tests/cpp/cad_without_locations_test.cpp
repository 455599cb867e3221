// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/without_locations.h"

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax1.hxx>
#include <gtest/gtest.h>

#include <numbers>

namespace nmgs::cad {
namespace {

TopLoc_Location turned(double angle, double shift) {
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0)), angle);
    gp_Trsf move;
    move.SetTranslation(gp_Vec(shift, 0, 0));
    return TopLoc_Location(turn) * TopLoc_Location(move);
}

void expect_alike(const CadShape &before, const CadShape &after) {
    ASSERT_EQ(after.solids.Extent(), before.solids.Extent());
    ASSERT_EQ(after.faces.Extent(), before.faces.Extent());
    ASSERT_EQ(after.edges.Extent(), before.edges.Extent());
    ASSERT_EQ(after.vertices.Extent(), before.vertices.Extent());
    for (int v = 1; v <= before.vertices.Extent(); ++v) {
        EXPECT_LT(distance(after.point(v), before.point(v)), 1e-9);
    }
    for (int n = 1; n <= before.solids.Extent(); ++n) {
        EXPECT_NEAR(volume_of(after.solid(n)), volume_of(before.solid(n)), 1e-6);
    }
    for (int f = 1; f <= after.faces.Extent(); ++f) {
        EXPECT_TRUE(after.faces(f).Location().IsIdentity());
    }
}

TEST(WithoutLocations, LeavesNoPlacementAndAllPartsWhereTheyAre) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(4, 3, 2).Shape().Located(turned(0.4, 1));
    const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(0.5, 6).Shape().Located(turned(0.9, 2));
    const TopoDS_Shape both = BRepAlgoAPI_Fuse(box, rod).Shape().Located(turned(1.2, -3));
    const CadShape before = make_shape(both);
    ASSERT_FALSE(before.faces(1).Location().IsIdentity());
    expect_alike(before, without_locations(before));
}

TEST(WithoutLocations, TwoPlacementsOfOneSolidStayTwo) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
    const BRep_Builder builder;
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    builder.Add(compound, box);
    builder.Add(compound, box.Located(turned(0, 5)));
    const CadShape before = make_shape(compound);
    ASSERT_EQ(before.solids.Extent(), 2);
    expect_alike(before, without_locations(before));
}

TEST(WithoutLocations, AShapeWithNoneIsAsItWas) {
    const CadShape before = make_shape(BRepPrimAPI_MakeBox(1, 2, 3).Shape());
    expect_alike(before, without_locations(before));
}

} // namespace
} // namespace nmgs::cad
