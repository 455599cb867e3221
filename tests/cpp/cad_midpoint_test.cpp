// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/midpoint.h"

#include "cad_layout_checks.h"

#include "nmgs_cad/layout_quality.h"
#include "nmgs_cad/solid_boundary.h"
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

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

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

TopoDS_Shape octahedron() {
    return polyhedron(
        {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
        {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
}

TEST(MidPoint, WhereFourEdgesMeetATetrahedronAFaceAndItsMiddle) {
    const CadShape shape = nmgs::cad::make_shape(octahedron());
    Layout layout(shape);
    Refusal refusal;
    ASSERT_TRUE(fill(shape, layout, refusal)) << refusal.reason;
    nmgs::cad::expect_sound(shape, layout, 1e-9);
    EXPECT_EQ(layout.hexas.size(), 8U * 4U);
    const auto quality = nmgs::cad::layout_quality(shape, layout);
    EXPECT_NEAR(quality.volume, 4.0 / 3, 1e-9);
    EXPECT_GT(quality.worst, 0.4);
}

TEST(MidPoint, APyramidsBaseIsATriangleASide) {
    const CadShape shape = nmgs::cad::make_shape(
        polyhedron({{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {0, 0, 1.5}},
                   {{3, 2, 1, 0}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}));
    Layout layout(shape);
    Refusal refusal;
    ASSERT_TRUE(fill(shape, layout, refusal)) << refusal.reason;
    nmgs::cad::expect_sound(shape, layout, 1e-9);
    EXPECT_EQ(layout.hexas.size(), (4U + 4U) * 4U);
    const auto quality = nmgs::cad::layout_quality(shape, layout);
    EXPECT_NEAR(quality.volume, 2.0, 1e-9);
    EXPECT_GT(quality.worst, 0.2);
}

TEST(MidPoint, RefusesWhereFourEdgesMeetBesideANeighbourAndNamesTheVertex) {
    const CadShape shape = nmgs::cad::make_shape(octahedron());
    Layout layout(shape);
    constexpr double thirds[] = {1.0 / 3, 2.0 / 3};
    layout.divide_edge(shape, 1, thirds);
    Refusal refusal;
    EXPECT_FALSE(fill(shape, layout, refusal));
    EXPECT_TRUE(layout.hexas.empty());
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

// A cube and a prism on it that share a square face.
CadShape cube_and_prism() {
    const TopoDS_Shape cube = BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape();
    const TopoDS_Shape prism =
        BRepPrimAPI_MakePrism(polygon({{0, 0, 1}, {1, 0, 1}, {0.5, 0, 2}}), gp_Vec(0, 1, 0))
            .Shape();
    BOPAlgo_Builder builder;
    builder.AddArgument(cube);
    builder.AddArgument(prism);
    builder.Perform();
    return nmgs::cad::make_shape(builder.Shape());
}

// The one face that both solids have.
int common_face(const CadShape &shape) {
    int common = 0;
    for (const auto &[face, bounds] : nmgs::cad::solid_faces(shape, 1)) {
        for (const auto &[other, also] : nmgs::cad::solid_faces(shape, 2)) {
            common = face == other ? face : common;
        }
    }
    return common;
}

// Both solids are filled, every quad of the common face is a side of one hexahedron of each, and no
// place has two points.
void expect_joined(const CadShape &shape, const std::string &method, Layout &layout) {
    ASSERT_EQ(shape.solids.Extent(), 2);
    const std::vector<int> solids{1, 2};
    nmgs::cad::SolidLayoutOptions options;
    options.method = method;
    for (const auto &entry : nmgs::cad::layout_solids(shape, solids, layout, options)) {
        ASSERT_FALSE(entry.method.empty()) << entry.reason;
    }
    nmgs::cad::expect_sound(shape, layout, 1e-9);
    const auto quality = nmgs::cad::layout_quality(shape, layout, 0, 2);
    EXPECT_NEAR(quality.volume, 1.5, 1e-9);
    EXPECT_GT(quality.worst, 0.3);
    for (std::size_t p = 0; p < layout.points.size(); ++p) {
        for (std::size_t q = 0; q < p; ++q) {
            EXPECT_GT(nmgs::distance(layout.points[p], layout.points[q]), 1e-3) << p << ' ' << q;
        }
    }
    const auto quads = layout.quads_of(common_face(shape));
    EXPECT_FALSE(quads.empty());
    for (const auto q : quads) {
        const auto &corners = layout.quads[static_cast<std::size_t>(q)].points;
        std::multiset<int> users;
        for (const auto &hexa : layout.hexas) {
            const std::set<std::int32_t> of(hexa.points.begin(), hexa.points.end());
            if (std::all_of(corners.begin(), corners.end(),
                            [&](std::int32_t p) { return of.contains(p); })) {
                users.insert(hexa.solid);
            }
        }
        EXPECT_EQ(users, (std::multiset<int>{1, 2})) << "quad " << q;
    }
}

TEST(SolidLayout, SolidsThatShareAFaceShareItsPoints) {
    const CadShape shape = cube_and_prism();
    Layout layout(shape);
    expect_joined(shape, "auto", layout);
}

// The mid-points of a cube and of a prism are 8 and 6 hexahedra, one a vertex, of 27 and 21 points:
// vertices, and a middle of each edge, each face and the solid. On the common face nine are one.
TEST(SolidLayout, MidPointsOfTwoSolidsThatShareAFace) {
    const CadShape shape = cube_and_prism();
    Layout layout(shape);
    expect_joined(shape, "mid-point", layout);
    EXPECT_EQ(layout.hexas.size(), 8U + 6U);
    EXPECT_EQ(layout.points.size(), 27U + 21U - 9U);
}

} // namespace
