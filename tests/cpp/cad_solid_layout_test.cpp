// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/solid_layout.h"

#include "nmgs_cad/solid_groups.h"
#include "nmgs_cad/solid_likeness.h"
#include "nmgs_cad/split.h"

#include "cad_layout_checks.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>

namespace {

using namespace nmgs::cad;

TopoDS_Shape box(double x, double y, double z, double dx, double dy, double dz) {
    return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), dx, dy, dz).Shape();
}

CadShape imprinted(const std::vector<TopoDS_Shape> &solids) {
    TopoDS_Compound compound;
    BRep_Builder builder;
    builder.MakeCompound(compound);
    for (const TopoDS_Shape &solid : solids) {
        builder.Add(compound, solid);
    }
    Refusal refusal;
    auto pieces = imprint(make_shape(compound), refusal);
    EXPECT_TRUE(pieces) << refusal.reason;
    return pieces.value().cad;
}

std::vector<int> all_of(const CadShape &shape) {
    std::vector<int> solids;
    for (int n = 1; n <= shape.solids.Extent(); ++n) {
        solids.push_back(n);
    }
    return solids;
}

TEST(SolidGroups, FacesEdgesAndVerticesJoin) {
    const CadShape by_face = imprinted({box(0, 0, 0, 1, 1, 1), box(1, 0, 0, 1, 1, 1)});
    EXPECT_EQ(joined_solids(by_face, all_of(by_face)).size(), 1U);
    const CadShape by_edge = imprinted({box(0, 0, 0, 1, 1, 1), box(1, 1, 0, 1, 1, 1)});
    EXPECT_EQ(joined_solids(by_edge, all_of(by_edge)).size(), 1U);
    const CadShape by_vertex = imprinted({box(0, 0, 0, 1, 1, 1), box(1, 1, 1, 1, 1, 1)});
    EXPECT_EQ(joined_solids(by_vertex, all_of(by_vertex)).size(), 1U);
    const CadShape apart = imprinted({box(0, 0, 0, 1, 1, 1), box(3, 0, 0, 1, 1, 1)});
    EXPECT_EQ(joined_solids(apart, all_of(apart)), (std::vector<std::vector<int>>{{1}, {2}}));
    // Through the one between them, which is looked at last; without it they are apart.
    const CadShape row =
        imprinted({box(0, 0, 0, 1, 1, 1), box(2, 0, 0, 1, 1, 1), box(1, 0, 0, 1, 1, 1)});
    EXPECT_EQ(joined_solids(row, all_of(row)), (std::vector<std::vector<int>>{{1, 2, 3}}));
    EXPECT_EQ(joined_solids(row, std::vector<int>{2, 1}).size(), 2U);
    EXPECT_TRUE(joined_solids(row, std::vector<int>{}).empty());
}

TEST(SolidLikeness, IsTheSameWhereverASolidIs) {
    gp_Trsf away;
    away.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 1)), 0.7);
    const TopoDS_Shape one = box(0, 0, 0, 1, 2, 3);
    gp_Trsf mirror;
    mirror.SetMirror(gp_Ax2(gp_Pnt(5, 0, 0), gp_Dir(1, 0, 0)));
    const CadShape shape = make_shape([&] {
        TopoDS_Compound compound;
        BRep_Builder builder;
        builder.MakeCompound(compound);
        builder.Add(compound, one);
        builder.Add(compound, BRepBuilderAPI_Transform(one, away, Standard_True).Shape());
        builder.Add(compound, BRepBuilderAPI_Transform(one, mirror, Standard_True).Shape());
        builder.Add(compound, box(0, 0, 0, 1, 2, 3.001));
        builder.Add(compound, box(0, 0, 0, 1, 1, 6)); // the same volume
        return compound;
    }());
    const SolidLikeness first = likeness_of(shape, 1);
    EXPECT_NEAR(first.size[0], 6, 1e-9);
    EXPECT_TRUE(alike(first, likeness_of(shape, 2)));
    EXPECT_TRUE(alike(first, likeness_of(shape, 3)));
    EXPECT_FALSE(alike(first, likeness_of(shape, 4)));
    EXPECT_FALSE(alike(first, likeness_of(shape, 5)));
}

// No strategy fills a box round a ball but cuts through both.
TEST(SolidLayout, CutsGoThroughSolidsThatTouch) {
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Pnt(0.1, 0, 0.2), 0.5).Shape();
    const CadShape shape =
        imprinted({BRepAlgoAPI_Cut(box(-1, -1, -1, 2, 2, 2), ball).Shape(), ball});
    ASSERT_EQ(shape.solids.Extent(), 2);
    Layout layout(shape);
    SolidLayoutOptions options;
    options.method = "cut";
    const auto report = layout_solids(shape, all_of(shape), layout, options);
    for (const FitEntry &entry : report) {
        EXPECT_EQ(entry.method, "cut") << entry.reason;
        EXPECT_GT(entry.quality, 0.2);
    }
    expect_sound(shape, layout, 2e-2);
}

// What is found out about one is used for the others that look like it, and each has its nodes.
TEST(SolidLayout, SolidsThatLookTheSame) {
    std::vector<TopoDS_Shape> solids;
    for (int n = 0; n < 3; ++n) {
        solids.push_back(
            BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(5 * n, n, 0), gp_Dir(0.1 * n, 0, 1)), 1, 3)
                .Shape());
    }
    const CadShape shape = imprinted(solids);
    Layout layout(shape);
    const auto report = layout_solids(shape, all_of(shape), layout);
    ASSERT_EQ(report.size(), 3U);
    for (const FitEntry &entry : report) {
        EXPECT_FALSE(entry.method.empty()) << entry.reason;
        EXPECT_EQ(entry.method, report.front().method);
        EXPECT_EQ(entry.blocks, report.front().blocks);
    }
    expect_sound(shape, layout, 2e-2);
}

} // namespace
