// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/quad_repair.h"

#include "nmgs_cad/face_boundary.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <gp_Pln.hxx>

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace nmgs;
using namespace nmgs::cad;

// The square of side 2 with a node in the middle of its lower and its upper side.
struct Square {
    CadShape shape = make_shape(BRepBuilderAPI_MakeFace(gp_Pln(gp::XOY()), 0, 2, 0, 2).Face());
    FaceSurface surface{shape.face(1)};
    FaceMesh mesh;

    Square() {
        Refusal refusal;
        const auto loops = face_loops(shape, 1, refusal);
        Layout layout(shape);
        for (int e = 1; e <= 4; ++e) {
            const auto &use = *std::find_if(loops->loops[0].begin(), loops->loops[0].end(),
                                            [&](const EdgeUse &u) { return u.edge == e; });
            const bool level = std::abs(use.begin().v - use.end().v) < 1e-9;
            layout.divide_edge(shape, e, level ? std::vector{0.5} : std::vector<double>{});
        }
        std::vector<std::vector<std::int32_t>> numbers;
        mesh = face_mesh_of(surface, boundary_of(shape, *loops, layout), numbers);
    }
    [[nodiscard]] std::int32_t node(double x, double y) const {
        for (std::size_t n = 0; n < mesh.points.size(); ++n) {
            if (distance(mesh.points[n], {x, y, 0}) < 1e-9) {
                return static_cast<std::int32_t>(n);
            }
        }
        return -1;
    }
};

double area(const FaceMesh &mesh) {
    double sum = 0;
    for (const auto &q : mesh.quads) {
        const auto p = [&](std::size_t c) { return mesh.points[static_cast<std::size_t>(q[c])]; };
        sum += 0.5 * cross(p(2) - p(0), p(3) - p(1)).z;
    }
    return sum;
}

TEST(QuadRepair, TurnsTheEdgeBetweenTwoQuadsWithStraightCorners) {
    Square square;
    FaceMesh &mesh = square.mesh;
    mesh.quads = {
        {square.node(0, 0), square.node(1, 0), square.node(2, 0), square.node(2, 2)},
        {square.node(0, 0), square.node(2, 2), square.node(1, 2), square.node(0, 2)},
    };
    ASSERT_NEAR(worst_quality(mesh), 0, 1e-12);
    repair_quads(mesh, square.surface, {}, 0.3);
    EXPECT_NEAR(worst_quality(mesh), 1, 1e-9); // two rectangles
    EXPECT_EQ(mesh.quads.size(), 2U);
    EXPECT_NEAR(area(mesh), 4, 1e-12);
}

TEST(QuadRepair, WrapsWhatCannotBeTurned) {
    Square square;
    FaceMesh &mesh = square.mesh;
    mesh.quads = {
        {square.node(0, 0), square.node(1, 0), square.node(2, 0), square.node(2, 2)},
        {square.node(0, 0), square.node(2, 2), square.node(1, 2), square.node(0, 2)},
    };
    const std::int32_t a = square.node(0, 0);
    const std::int32_t b = square.node(2, 2);
    repair_quads(mesh, square.surface, {{std::min(a, b), std::max(a, b)}}, 0.3);
    EXPECT_GT(worst_quality(mesh), 0.1);
    EXPECT_NEAR(area(mesh), 4, 1e-12);
    bool there = false; // the kept edge
    for (const auto &q : mesh.quads) {
        for (std::size_t c = 0; c < 4; ++c) {
            there = there || (q[c] == a && q[(c + 1) % 4] == b);
        }
    }
    EXPECT_TRUE(there);
}

TEST(QuadRepair, LeavesGoodQuadsAlone) {
    Square square;
    FaceMesh &mesh = square.mesh;
    mesh.quads = {
        {square.node(0, 0), square.node(1, 0), square.node(1, 2), square.node(0, 2)},
        {square.node(1, 0), square.node(2, 0), square.node(2, 2), square.node(1, 2)},
    };
    const auto before = mesh.quads;
    repair_quads(mesh, square.surface, {}, 0.3);
    EXPECT_EQ(mesh.quads, before);
}

} // namespace
