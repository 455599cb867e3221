// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/face_cusps.h"

#include "nmgs/blocking/default_divisions.h"
#include "nmgs_cad/face_layout.h"
#include "nmgs_cad/generate_on_cad.h"
#include "nmgs_cad/refine.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace nmgs;
using namespace nmgs::cad;

gp_Circ circle(double y, double radius) {
    return {gp_Ax2({0, y, 0}, gp::DZ(), {0, -1, 0}), radius};
}

// Under a quarter of the circle about (0, 1), down to the x axis, which touches it at the origin.
TopoDS_Face under_a_quarter() {
    BRepBuilderAPI_MakeWire wire;
    wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(2, 0, 0)).Edge());
    wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(2, 0, 0), gp_Pnt(2, 1, 0)).Edge());
    wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(2, 1, 0), gp_Pnt(1, 1, 0)).Edge());
    wire.Add(BRepBuilderAPI_MakeEdge(circle(1, 1), 0, std::numbers::pi / 2).Edge());
    return BRepBuilderAPI_MakeFace(gp_Pln(gp::XOY()), wire.Wire()).Face();
}

// Between circles of radii 2 and 1 that touch at the origin.
TopoDS_Face crescent() {
    const TopoDS_Vertex vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(0, 0, 0)).Vertex();
    const auto ring = [&](double radius) {
        return BRepBuilderAPI_MakeWire(
                   BRepBuilderAPI_MakeEdge(circle(radius, radius), vertex, vertex).Edge())
            .Wire();
    };
    BRepBuilderAPI_MakeFace face(gp_Pln(gp::XOY()), ring(2));
    face.Add(TopoDS::Wire(ring(1).Reversed()));
    return face.Face();
}

// Worst scaled Jacobian of the mesh with default sizes, and its area.
std::array<double, 2> quality_and_area(const TopoDS_Face &face) {
    const CadShape shape = make_shape(face);
    Layout layout(shape);
    LayoutOptions options;
    options.angle = std::numbers::pi / 4;
    std::vector<FitEntry> report;
    layout_faces(shape, std::vector<int>{1}, layout, options, report);
    CadBlocks blocks = blocks_of(shape, layout, 2);
    blocks.report = report;
    blocks = refine_to_tolerance(shape, std::move(blocks), 1e-3 * shape.diagonal(), 6);
    blocks.model.divisions =
        default_divisions(blocks.model, find_topology(blocks.model), shape.diagonal() / 30);
    const Mesh mesh = generate_on_cad(shape, blocks, 1, {});
    double worst = 1;
    double area = 0;
    const auto &nodes = mesh.cells.front().nodes;
    for (std::size_t c = 0; c < nodes.size(); c += 4) {
        std::array<Vec3, 4> p{};
        for (std::size_t k = 0; k < 4; ++k) {
            p[k] = mesh.points[static_cast<std::size_t>(nodes[c + k])];
        }
        for (std::size_t k = 0; k < 4; ++k) {
            const Vec3 a = p[(k + 1) % 4] - p[k];
            const Vec3 b = p[(k + 3) % 4] - p[k];
            worst = std::min(worst, cross(a, b).z / (norm(a) * norm(b)));
        }
        area += 0.5 * cross(p[2] - p[0], p[3] - p[1]).z;
    }
    return {worst, area};
}

TEST(FaceCusps, SegmentsAreAsLongAsTheChordsAngleAsks) {
    const CadShape shape = make_shape(under_a_quarter());
    Refusal refusal;
    const auto loops = face_loops(shape, 1, refusal);
    ASSERT_TRUE(loops);
    EdgeSizes sizes;
    for (int e = 1; e <= 4; ++e) {
        sizes[e] = size_of_edge(shape, e, {});
    }
    ASSERT_TRUE(size_cusps(shape, 1, *loops, sizes));
    double tips = 0;
    for (const auto &[edge, size] : sizes) {
        for (const double tip : size.tip) {
            if (tip > 0) {
                ++tips;
                // The chord of an arc of length s on the unit circle is at s / 2 to the tangent.
                EXPECT_GT(std::sin(tip / 2), 0.2);
                EXPECT_LT(std::sin(tip / 2), 0.25);
                const auto places = size.fractions(4);
                ASSERT_EQ(places.size(), 3U);
                EXPECT_NEAR(size.tip[0] > 0 ? places.front() : 1 - places.back(), tip / size.length,
                            1e-9);
            }
        }
    }
    EXPECT_EQ(tips, 2);
}

TEST(FaceCusps, ASharpCornerOfStraightEdgesIsNone) {
    BRepBuilderAPI_MakeWire wire;
    wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(2, 0, 0)).Edge());
    wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(2, 0, 0), gp_Pnt(2, 0.2, 0)).Edge());
    wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(2, 0.2, 0), gp_Pnt(0, 0, 0)).Edge());
    const CadShape shape =
        make_shape(BRepBuilderAPI_MakeFace(gp_Pln(gp::XOY()), wire.Wire()).Face());
    Refusal refusal;
    const auto loops = face_loops(shape, 1, refusal);
    ASSERT_TRUE(loops);
    EdgeSizes sizes;
    for (int e = 1; e <= 3; ++e) {
        sizes[e] = size_of_edge(shape, e, {});
    }
    EXPECT_FALSE(size_cusps(shape, 1, *loops, sizes));
}

TEST(FaceCusps, TheMeshIsGoodInTheTip) {
    const auto [worst, area] = quality_and_area(under_a_quarter());
    EXPECT_GT(worst, 0.2);
    EXPECT_NEAR(area, 2 - std::numbers::pi / 4, 0.01 * 2);
}

TEST(FaceCusps, AHoleThatTouchesTheRimLeavesTwo) {
    const CadShape shape = make_shape(crescent());
    Refusal refusal;
    auto loops = face_loops(shape, 1, refusal);
    ASSERT_TRUE(loops);
    ASSERT_EQ(loops->loops.size(), 2U);
    join_touching_loops(shape, 1, *loops);
    ASSERT_EQ(loops->loops.size(), 1U);
    ASSERT_EQ(loops->loops[0].size(), 2U);
    EXPECT_LT(loops->loops[0][0].angle, 0.1);
    EXPECT_LT(loops->loops[0][1].angle, 0.1);
    const auto [worst, area] = quality_and_area(crescent());
    EXPECT_GT(worst, 0.1);
    EXPECT_NEAR(area, 3 * std::numbers::pi, 0.02 * 3 * std::numbers::pi);
}

} // namespace
