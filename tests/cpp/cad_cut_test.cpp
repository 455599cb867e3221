// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/cut.h"
#include "nmgs_cad/cut_list.h"
#include "nmgs_cad/split.h"

#include "cad_layout_checks.h"

#include <BRepAlgoAPI_BuilderAlgo.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pln.hxx>

namespace {

using namespace nmgs::cad;

TopoDS_Shape box(double x, double y, double z, double dx, double dy, double dz) {
    return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), dx, dy, dz).Shape();
}
TopoDS_Shape cylinder(const gp_Pnt &p, const gp_Dir &axis, double radius, double height) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2(p, axis), radius, height).Shape();
}
TopoDS_Shape fused(const TopoDS_Shape &a, const TopoDS_Shape &b) {
    return BRepAlgoAPI_Fuse(a, b).Shape();
}
TopoDS_Shape cut(const TopoDS_Shape &a, const TopoDS_Shape &b) {
    return BRepAlgoAPI_Cut(a, b).Shape();
}

TopoDS_Shape octahedron() {
    const std::vector<gp_Pnt> points{{1, 0, 0},  {0, 1, 0}, {-1, 0, 0},
                                     {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    BRepBuilderAPI_Sewing sewing;
    for (std::size_t i = 0; i < 4; ++i) {
        for (const std::size_t top : {4U, 5U}) {
            BRepBuilderAPI_MakePolygon triangle(points[i], points[(i + 1) % 4], points[top],
                                                Standard_True);
            sewing.Add(BRepBuilderAPI_MakeFace(triangle.Wire()).Face());
        }
    }
    sewing.Perform();
    return BRepBuilderAPI_MakeSolid(TopoDS::Shell(sewing.SewedShape())).Shape();
}

void expect_filled(const TopoDS_Shape &solid, double tolerance) {
    const CadShape shape = make_shape(solid);
    ASSERT_EQ(shape.solids.Extent(), 1);
    Layout layout(shape);
    Refusal refusal;
    ASSERT_TRUE(fill_cut(shape, 1, layout, {}, refusal, {})) << refusal.reason;
    expect_sound(shape, layout, tolerance);
}

TEST(Split, PiecesKnowWhereTheyComeFrom) {
    const CadShape shape = make_shape(box(0, 0, 0, 4, 2, 2));
    TopTools_ListOfShape tools;
    Cut plane;
    plane.place = gp_Ax3(gp_Pnt(1, 0, 0), gp_Dir(1, 0, 0));
    tools.Append(cut_face(shape, plane));
    Refusal refusal;
    const std::vector<int> solids{1};
    const auto pieces = split(shape, solids, tools, refusal);
    ASSERT_TRUE(pieces) << refusal.reason;
    EXPECT_EQ(pieces->cad.solids.Extent(), 2);
    const auto count = [](const std::vector<CadEntity> &list, int dimension) {
        return std::count_if(list.begin() + 1, list.end(),
                             [&](const CadEntity &e) { return e.dimension == dimension; });
    };
    EXPECT_EQ(count(pieces->vertex_on, 0), 8);
    EXPECT_EQ(count(pieces->vertex_on, 1), 4);
    EXPECT_EQ(count(pieces->edge_on, 1), 16); // four of the twelve in two
    EXPECT_EQ(count(pieces->edge_on, 2), 4);
    EXPECT_EQ(count(pieces->face_on, 2), 10);
    EXPECT_EQ(count(pieces->face_on, 3), 1);
    EXPECT_EQ(count(pieces->solid_on, 3), 2);
    for (int v = 1; v <= pieces->cad.vertices.Extent(); ++v) {
        const CadEntity on = pieces->vertex_on[static_cast<std::size_t>(v)];
        if (on.dimension == 0) {
            EXPECT_LT(BRep_Tool::Pnt(pieces->cad.vertex(v))
                          .Distance(BRep_Tool::Pnt(shape.vertex(on.index))),
                      1e-9);
        }
    }
}

TEST(Split, ImprintedSolidsShareTheirFaces) {
    // A small box on a large one, and one apart.
    TopoDS_Compound compound;
    BRep_Builder builder;
    builder.MakeCompound(compound);
    builder.Add(compound, box(0, 0, 0, 4, 4, 1));
    builder.Add(compound, box(1, 1, 1, 2, 2, 1));
    builder.Add(compound, box(9, 0, 0, 1, 1, 1));
    const CadShape shape = make_shape(compound);
    EXPECT_EQ(shape.faces.Extent(), 18);
    Refusal refusal;
    const auto pieces = imprint(shape, refusal);
    ASSERT_TRUE(pieces) << refusal.reason;
    EXPECT_EQ(pieces->cad.solids.Extent(), 3);
    EXPECT_EQ(pieces->cad.faces.Extent(), 18); // one face less, one in two
    std::set<int> solids;
    for (int n = 1; n <= 3; ++n) {
        solids.insert(pieces->solid_on[static_cast<std::size_t>(n)].index);
    }
    EXPECT_EQ(solids.size(), 3U);
}

TEST(Cut, ObstaclesAreTheConcaveEdges) {
    const CadShape step = make_shape(cut(box(0, 0, 0, 3, 3, 3), box(1, -1, 1, 9, 9, 9)));
    const auto edges = obstacles(step, 1);
    ASSERT_EQ(edges.size(), 1U);
    for (const gp_Pnt &p : {gp_Pnt(1, 0, 1), gp_Pnt(1, 3, 1)}) {
        bool ends = false;
        const CadShape edge = make_shape(step.edge(edges[0]));
        for (int v = 1; v <= 2; ++v) {
            ends = ends || BRep_Tool::Pnt(edge.vertex(v)).Distance(p) < 1e-9;
        }
        EXPECT_TRUE(ends);
    }
    EXPECT_TRUE(obstacles(make_shape(box(0, 0, 0, 1, 2, 3)), 1).empty());
    const auto cuts = propose_cuts(step, 1);
    ASSERT_GE(cuts.size(), 2U);
    for (const Cut &c : cuts) {
        EXPECT_FALSE(c.name.empty());
        EXPECT_FALSE(c.entities.empty());
        EXPECT_GE(c.resolves, 1);
    }
    EXPECT_TRUE(propose_cuts(make_shape(box(0, 0, 0, 1, 2, 3)), 1).empty());
}

TEST(Cut, FiguresAreThoseOfTheProposals) {
    const CadShape shape =
        make_shape(cut(box(-2, -2, 0, 4, 4, 1), cylinder(gp_Pnt(0, 0, -1), gp_Dir(0, 0, 1), 1, 3)));
    const auto cuts = propose_cuts(shape, 1);
    const auto figures = cut_list(shape, 1);
    ASSERT_EQ(figures.size(), cuts.size());
    for (std::size_t n = 0; n < cuts.size(); ++n) {
        EXPECT_EQ(figures[n].name, cuts[n].name);
        EXPECT_EQ(figures[n].radius > 0, cuts[n].cylinder);
        EXPECT_NEAR(norm(figures[n].direction), 1, 1e-12);
        // On the axis or plane, and nearest to the middle of the box, (0, 0, 1/2).
        const gp_Vec apart(cuts[n].place.Location(),
                           gp_Pnt(figures[n].origin.x, figures[n].origin.y, figures[n].origin.z));
        const gp_Vec along(cuts[n].place.Direction());
        EXPECT_NEAR(cuts[n].cylinder ? apart.Crossed(along).Magnitude() : apart.Dot(along), 0,
                    1e-9);
        const nmgs::Vec3 rest = figures[n].origin - nmgs::Vec3{0, 0, 0.5};
        EXPECT_NEAR(cuts[n].cylinder ? dot(rest, figures[n].direction)
                                     : norm(cross(rest, figures[n].direction)),
                    0, 1e-6);
    }
}

TEST(Cut, FillsStepsBossesAndHoles) {
    expect_filled(cut(box(0, 0, 0, 3, 3, 3), box(1, -1, 1, 9, 9, 9)), 1e-9);
    expect_filled(cylinder(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1), 1, 2), 1e-2);
    const gp_Dir up(0, 0, 1);
    expect_filled(cut(box(-2, -2, 0, 4, 4, 1), cylinder(gp_Pnt(0, 0, -1), up, 1, 3)), 1e-2);
    expect_filled(fused(box(-2, -2, 0, 4, 4, 1), cylinder(gp_Pnt(0, 0, 1), up, 1, 1.5)), 1e-2);
}

TEST(Cut, FillsCylindersThatCross) {
    expect_filled(fused(cylinder(gp_Pnt(0, 0, -3), gp_Dir(0, 0, 1), 1, 6),
                        cylinder(gp_Pnt(-3, 0, 0), gp_Dir(1, 0, 0), 1, 6)),
                  2e-2);
}

TEST(Cut, FillsSolidsWhereFourEdgesMeet) {
    expect_filled(octahedron(), 1e-9);
}

TEST(Cut, FillsABracketWithHolesInBothLegs) {
    TopoDS_Shape bracket = fused(box(0, 0, 0, 6, 4, 1), box(0, 0, 1, 1, 4, 4));
    bracket = cut(bracket, cylinder(gp_Pnt(4, 2, -1), gp_Dir(0, 0, 1), 0.8, 3));
    bracket = cut(bracket, cylinder(gp_Pnt(-1, 2, 3), gp_Dir(1, 0, 0), 0.8, 3));
    expect_filled(bracket, 1e-2);
}

TEST(Cut, LeavesALayoutThatNeighboursHaveBegun) {
    const CadShape shape = make_shape(cylinder(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1), 1, 2));
    Layout layout(shape);
    const std::vector<double> thirds{1.0 / 3, 2.0 / 3};
    layout.divide_edge(shape, 1, thirds);
    const auto points = layout.points.size();
    Refusal refusal;
    EXPECT_FALSE(fill_cut(shape, 1, layout, {}, refusal, {}));
    EXPECT_EQ(refusal.blockers, std::vector<std::string>{"Edge1"});
    EXPECT_EQ(layout.points.size(), points);
    EXPECT_TRUE(layout.hexas.empty());
}

// As thickening a shell makes them: the shell is inside out, and the solid turned.
TEST(Cut, SolidsThatAreTurned) {
    TopoDS_Shape bracket = fused(box(0, 0, 0, 6, 4, 1), box(0, 0, 1, 1, 4, 4));
    bracket = cut(bracket, cylinder(gp_Pnt(4, 2, -1), gp_Dir(0, 0, 1), 0.8, 3));
    const BRep_Builder builder;
    TopoDS_Solid turned;
    builder.MakeSolid(turned);
    builder.Add(turned, TopExp_Explorer(bracket, TopAbs_SHELL).Current().Reversed());
    turned.Reverse();
    ASSERT_GT(volume_of(turned), 0);
    expect_filled(turned, 1e-2);
}

// Faces inside a solid become faces between pieces.
TEST(Cut, FacesInsideSolids) {
    BRepAlgoAPI_BuilderAlgo fuse;
    TopTools_ListOfShape arguments;
    arguments.Append(box(0, 0, 0, 2, 2, 2));
    arguments.Append(
        BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0.7, 1, 1), gp_Dir(1, 0, 0)), -0.4, 0.5, -0.3, 0.6)
            .Face());
    fuse.SetArguments(arguments);
    fuse.Build();
    const CadShape shape = make_shape(fuse.Shape());
    ASSERT_EQ(shape.solids.Extent(), 1);
    ASSERT_EQ(shape.faces.Extent(), 7);
    EXPECT_EQ(obstacles(shape, 1).size(), 4U);
    Layout layout(shape);
    Refusal refusal;
    ASSERT_TRUE(fill_cut(shape, 1, layout, {}, refusal, {})) << refusal.reason;
    std::size_t inner = 0;
    double area = 0;
    for (const auto &quad : layout.quads) {
        const auto p = [&](std::size_t i) {
            return layout.points[static_cast<std::size_t>(quad.points[i])];
        };
        if (std::abs(p(0).x - 0.7) < 1e-9 && std::abs(p(2).x - 0.7) < 1e-9) {
            ++inner;
            area += 0.5 * nmgs::norm(nmgs::cross(p(2) - p(0), p(3) - p(1)));
        }
    }
    EXPECT_GT(inner, 0U);
    EXPECT_NEAR(area, 0.9 * 0.9, 1e-9);
}

TEST(Cut, StopsWhenItsWorkIsDone) {
    TopoDS_Shape bracket = fused(box(0, 0, 0, 6, 4, 1), box(0, 0, 1, 1, 4, 4));
    bracket = cut(bracket, cylinder(gp_Pnt(4, 2, -1), gp_Dir(0, 0, 1), 0.8, 3));
    const CadShape shape = make_shape(bracket);
    Layout layout(shape);
    Refusal refusal;
    int work = 0;
    LayoutOptions options;
    options.cut_work = &work;
    EXPECT_FALSE(fill_cut(shape, 1, layout, options, refusal, {}));
    EXPECT_FALSE(refusal.reason.empty());
    EXPECT_TRUE(layout.hexas.empty());
    work = 5000;
    EXPECT_TRUE(fill_cut(shape, 1, layout, options, refusal, {})) << refusal.reason;
    EXPECT_LT(work, 5000);
}

TEST(Cut, CancelStopsTheSearch) {
    const CadShape shape = make_shape(
        fused(box(-2, -2, 0, 4, 4, 1), cylinder(gp_Pnt(0, 0, 1), gp_Dir(0, 0, 1), 1, 1.5)));
    Layout layout(shape);
    Refusal refusal;
    EXPECT_THROW(fill_cut(shape, 1, layout, {}, refusal, [](double) { return false; }),
                 nmgs::Cancelled);
    EXPECT_TRUE(layout.points.empty());
}

} // namespace
