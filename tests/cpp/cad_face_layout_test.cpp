// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/face_layout.h"

#include "nmgs_cad/face_midpoint.h"
#include "nmgs_cad/face_surface.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <gp_Elips.hxx>
#include <gp_Pln.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <numbers>
#include <set>

namespace {

using namespace nmgs;
using namespace nmgs::cad;

std::vector<int> all_faces(const CadShape &shape) {
    std::vector<int> faces;
    for (int n = 1; n <= shape.faces.Extent(); ++n) {
        faces.push_back(n);
    }
    return faces;
}

// Every edge of a quad has a quad on its other side that runs along it backwards, or is on a CAD
// edge that only one face has; quads look outwards; each CAD edge is covered; points lie where they
// are said to.
void expect_conforming(const CadShape &shape, const Layout &layout, bool closed) {
    std::map<std::array<std::int32_t, 2>, int> uses;
    for (const auto &quad : layout.quads) {
        for (std::size_t c = 0; c < 4; ++c) {
            ++uses[{quad.points[c], quad.points[(c + 1) % 4]}];
            EXPECT_NE(quad.points[c], quad.points[(c + 1) % 4]);
            EXPECT_NE(quad.points[c], quad.points[(c + 2) % 4]);
        }
        const auto p = [&](std::size_t c) {
            return layout.points[static_cast<std::size_t>(quad.points[c])];
        };
        const FaceSurface surface(shape.face(quad.face));
        const Vec3 middle = 0.25 * (p(0) + p(1) + p(2) + p(3));
        const Uv uv = surface.nearest(middle, 0.5 * (surface.low() + surface.high()));
        EXPECT_GT(dot(surface.normal(uv), cross(p(2) - p(0), p(3) - p(1))), 0);
    }
    std::size_t single = 0;
    for (const auto &[ends, count] : uses) {
        EXPECT_EQ(count, 1);
        const bool twin = uses.contains({ends[1], ends[0]});
        single += twin ? 0 : 1;
    }
    if (closed) {
        EXPECT_EQ(single, 0U);
    }
    for (int e = 1; e <= shape.edges.Extent(); ++e) {
        if (BRep_Tool::Degenerated(shape.edge(e))) {
            continue;
        }
        const auto &points = layout.edges[static_cast<std::size_t>(e)];
        ASSERT_GE(points.size(), 2U);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            EXPECT_TRUE(uses.contains({points[i], points[i + 1]}) ||
                        uses.contains({points[i + 1], points[i]}))
                << "Edge" << e;
        }
    }
    for (std::size_t n = 0; n < layout.points.size(); ++n) {
        if (layout.on[n].dimension == 2) {
            const FaceSurface surface(shape.face(layout.on[n].index));
            const Uv uv = surface.nearest(layout.points[n], 0.5 * (surface.low() + surface.high()));
            EXPECT_LT(distance(surface.at(uv), layout.points[n]), 1e-7);
        }
    }
}

TopoDS_Shape rounded_box() {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(4, 3, 2).Shape();
    BRepFilletAPI_MakeFillet fillet(box);
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(box, TopAbs_EDGE, edges);
    for (int e = 1; e <= edges.Extent(); ++e) {
        fillet.Add(0.4, TopoDS::Edge(edges(e)));
    }
    return fillet.Shape();
}

struct Case {
    const char *name;
    std::function<TopoDS_Shape()> make;
};

class FaceLayoutOfSkins : public ::testing::TestWithParam<Case> {};

TEST_P(FaceLayoutOfSkins, CoversTheWholeSkin) {
    const CadShape shape = make_shape(GetParam().make());
    Layout layout(shape);
    LayoutOptions options;
    options.angle = std::numbers::pi / 4;
    std::vector<FitEntry> report;
    const auto faces = all_faces(shape);
    layout_faces(shape, faces, layout, options, report);
    ASSERT_EQ(report.size(), faces.size());
    for (const FitEntry &entry : report) {
        EXPECT_FALSE(entry.method.empty()) << entry.reason;
        EXPECT_GT(entry.quality, 0.2) << entry.entity.index << " " << entry.method;
        EXPECT_GT(entry.blocks, 0);
    }
    expect_conforming(shape, layout, true);
    // A closed surface of the right genus: V - E + F with E = 2 F.
    std::set<std::int32_t> used;
    for (const auto &quad : layout.quads) {
        used.insert(quad.points.begin(), quad.points.end());
    }
    const auto euler = static_cast<int>(used.size()) - static_cast<int>(layout.quads.size());
    EXPECT_TRUE(euler == 2 || euler == 0 || euler == -2) << euler;
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, FaceLayoutOfSkins,
    ::testing::Values(
        Case{"box", [] { return BRepPrimAPI_MakeBox(3, 2, 1).Shape(); }},
        Case{"cylinder", [] { return BRepPrimAPI_MakeCylinder(1, 3).Shape(); }},
        Case{"frustum", [] { return BRepPrimAPI_MakeCone(2, 1, 3).Shape(); }},
        Case{"cone", [] { return BRepPrimAPI_MakeCone(1, 0, 2).Shape(); }},
        Case{"ball", [] { return BRepPrimAPI_MakeSphere(1).Shape(); }},
        Case{"torus", [] { return BRepPrimAPI_MakeTorus(3, 1).Shape(); }},
        Case{"rounded box", [] { return rounded_box(); }},
        Case{"tube",
             [] {
                 return BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(2, 3).Shape(),
                                        BRepPrimAPI_MakeCylinder(1.5, 3).Shape())
                     .Shape();
             }},
        Case{"plate with a hole",
             [] {
                 return BRepAlgoAPI_Cut(
                            BRepPrimAPI_MakeBox(gp_Pnt(-5, -3, 0), gp_Pnt(5, 3, 1)).Shape(),
                            BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(2, 0.5, -1), gp::DZ()), 1, 3)
                                .Shape())
                     .Shape();
             }},
        Case{"octant of a ball",
             [] {
                 return BRepPrimAPI_MakeSphere(gp_Ax2(), 1, 0, std::numbers::pi / 2,
                                               std::numbers::pi / 2)
                     .Shape();
             }},
        Case{"boss on a block",
             [] {
                 return BRepAlgoAPI_Fuse(
                            BRepPrimAPI_MakeBox(gp_Pnt(-3, -3, 0), gp_Pnt(3, 3, 1)).Shape(),
                            BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 0.5), gp::DZ()), 1, 3)
                                .Shape())
                     .Shape();
             }}),
    [](const auto &info) {
        std::string name = info.param.name;
        std::replace(name.begin(), name.end(), ' ', '_');
        return name;
    });

TEST(FaceLayout, ABoxIsOneQuadAFaceAndACylinderOneRing) {
    const CadShape box = make_shape(BRepPrimAPI_MakeBox(3, 2, 1).Shape());
    Layout layout(box);
    std::vector<FitEntry> report;
    layout_faces(box, all_faces(box), layout, {}, report);
    EXPECT_EQ(layout.quads.size(), 6U);
    for (const FitEntry &entry : report) {
        EXPECT_EQ(entry.method, "mapped");
        EXPECT_NEAR(entry.quality, 1, 1e-9);
    }
}

// Segments that are there already are binding.
TEST(FaceLayout, KeepsTheSegmentsOfEdgesThatAreLaidOut) {
    const CadShape shape = make_shape(BRepPrimAPI_MakeBox(3, 2, 1).Shape());
    Layout layout(shape);
    const std::vector<double> three{0.2, 0.5};
    const std::vector<double> one{};
    const auto before = layout.divide_edge(shape, 1, three);
    layout.divide_edge(shape, 2, one);
    Refusal refusal;
    int laid = 0;
    for (int face = 1; face <= 6; ++face) {
        ASSERT_TRUE(layout_face(shape, face, layout, {}, refusal)) << refusal.reason;
        laid += static_cast<int>(layout.quads_of(face).size());
        const std::size_t count = layout.quads.size();
        ASSERT_TRUE(layout_face(shape, face, layout, {}, refusal)); // is covered already
        EXPECT_EQ(layout.quads.size(), count);
    }
    EXPECT_EQ(layout.edges[1], before);
    EXPECT_EQ(laid, static_cast<int>(layout.quads.size()));
    expect_conforming(shape, layout, true);
}

TEST(FaceLayout, AnOddBoundaryIsRefusedByName) {
    const gp_Pnt a(0, 0, 0);
    const gp_Pnt b(1, 0, 0);
    const gp_Pnt c(0, 1, 0);
    BRepBuilderAPI_MakePolygon triangle(a, b, c, Standard_True);
    const CadShape shape = make_shape(BRepBuilderAPI_MakeFace(triangle.Wire()).Shape());
    Layout layout(shape);
    for (int e = 1; e <= 3; ++e) {
        layout.divide_edge(shape, e, {});
    }
    Refusal refusal;
    EXPECT_FALSE(layout_face(shape, 1, layout, {}, refusal));
    EXPECT_NE(refusal.reason.find("Face1"), std::string::npos);
    EXPECT_NE(refusal.reason.find("odd"), std::string::npos);
    EXPECT_TRUE(layout.quads.empty());

    Layout free(shape);
    ASSERT_TRUE(layout_face(shape, 1, free, {}, refusal)) << refusal.reason;
    EXPECT_EQ(free.quads.size(), 3U); // mid-point subdivision
    expect_conforming(shape, free, false);
}

TEST(FaceLayout, AnUnboundedFaceIsRefusedAndTheOthersAreCovered) {
    BRep_Builder builder;
    TopoDS_Compound both;
    builder.MakeCompound(both);
    builder.Add(both, BRepBuilderAPI_MakeFace(gp_Pln()).Shape());
    builder.Add(both, BRepBuilderAPI_MakeFace(gp_Pln(), 0, 1, 0, 1).Shape());
    const CadShape shape = make_shape(both);
    Layout layout(shape);
    std::vector<FitEntry> report;
    layout_faces(shape, all_faces(shape), layout, {}, report);
    ASSERT_EQ(report.size(), 2U);
    for (const FitEntry &entry : report) {
        EXPECT_EQ(entry.method.empty(), entry.entity.index == 1);
    }
    EXPECT_FALSE(layout.quads.empty());
}

TEST(FaceLayout, AnotherStrategyCanBeAskedFor) {
    const CadShape shape = make_shape(BRepPrimAPI_MakeCylinder(1, 3).Shape());
    Layout layout(shape);
    std::vector<FitEntry> report;
    layout_faces(shape, all_faces(shape), layout, {}, report, {}, "general");
    for (const FitEntry &entry : report) {
        EXPECT_EQ(entry.method, "general");
    }
    expect_conforming(shape, layout, true);
}

TEST(FaceLayout, LinesOfMidpointSubdivisionMeet) {
    // The line of side i ends at a place that splits it in lines[i - 1] and lines[i + 1].
    for (const auto &n : {std::vector<int>{2, 2, 2}, {2, 5, 5}, {4, 4, 6}, {2, 2, 2, 2, 2}}) {
        const auto lines = midpoint_lines(n);
        ASSERT_TRUE(lines);
        const std::size_t count = n.size();
        for (std::size_t i = 0; i < count; ++i) {
            EXPECT_GT((*lines)[i], 0);
            EXPECT_EQ((*lines)[(i + count - 1) % count] + (*lines)[(i + 1) % count], n[i]);
        }
    }
    EXPECT_FALSE(midpoint_lines({1, 1, 1})); // odd
    EXPECT_FALSE(midpoint_lines({2, 2, 8})); // one longer than the others together
}

std::set<std::int32_t> points_of_quads(const Layout &layout) {
    std::set<std::int32_t> used;
    for (const auto &quad : layout.quads) {
        used.insert(quad.points.begin(), quad.points.end());
    }
    return used;
}

TEST(FaceLayout, AVertexInsideAFaceIsAPoint) {
    TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Pln(gp::XOY()), 0, 4, 0, 3).Face();
    const TopoDS_Vertex vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(1.2, 0.9, 0)).Vertex();
    BRep_Builder().Add(face, vertex.Oriented(TopAbs_INTERNAL));
    const CadShape shape = make_shape(face);
    Layout layout(shape);
    std::vector<FitEntry> report;
    layout_faces(shape, std::vector<int>{1}, layout, {}, report);
    ASSERT_EQ(report.size(), 1U);
    EXPECT_GT(report[0].quality, 0.2);
    const int number = shape.vertices.FindIndex(vertex);
    ASSERT_GT(number, 0);
    EXPECT_TRUE(points_of_quads(layout).contains(layout.vertex(shape, number)));
    expect_conforming(shape, layout, false);
}

TEST(FaceLayout, AnEdgeInsideAFaceIsCovered) {
    TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Pln(gp::XOY()), 0, 4, 0, 3).Face();
    const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(gp_Pnt(1, 1, 0), gp_Pnt(2.5, 1.5, 0)).Edge();
    TopoDS_Wire wire;
    BRep_Builder builder;
    builder.MakeWire(wire);
    builder.Add(wire, edge.Oriented(TopAbs_INTERNAL));
    builder.Add(face, wire);
    const CadShape shape = make_shape(face);
    Layout layout(shape);
    std::vector<FitEntry> report;
    layout_faces(shape, std::vector<int>{1}, layout, {}, report);
    ASSERT_EQ(report.size(), 1U);
    ASSERT_FALSE(report[0].method.empty()) << report[0].reason;
    EXPECT_GT(report[0].quality, 0.2);
    expect_conforming(shape, layout, false);
}

// A long plate round a flat hole: two loops, but no ring of good quads fits between them.
TEST(FaceLayout, WhatIsNoGoodAsARingIsDividedAnew) {
    BRepBuilderAPI_MakeFace plate(gp_Pln(gp::XOY()), -2.5, 2.5, -0.5, 0.5);
    const gp_Elips hole(gp_Ax2(gp::Origin(), gp::DZ(), gp::DX()), 1.2, 0.2);
    plate.Add(TopoDS::Wire(
        BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(hole).Edge()).Wire().Reversed()));
    const CadShape shape = make_shape(plate.Face());
    Layout layout(shape);
    LayoutOptions options;
    options.angle = std::numbers::pi / 4;
    std::vector<FitEntry> report;
    layout_faces(shape, std::vector<int>{1}, layout, options, report);
    ASSERT_EQ(report.size(), 1U);
    EXPECT_GT(report[0].quality, 0.25);
    expect_conforming(shape, layout, false);
}

} // namespace
