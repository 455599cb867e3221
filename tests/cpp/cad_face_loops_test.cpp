// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/face_loops.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <gp_Pln.hxx>

#include <gtest/gtest.h>

#include <numbers>

namespace {

using namespace nmgs;
using namespace nmgs::cad;
constexpr double pi = std::numbers::pi;

// Consecutive uses meet in space and in the parameters.
void expect_closed(const CadShape &shape, int face, const FaceLoops &loops) {
    const FaceSurface surface(shape.face(face));
    for (const FaceLoop &loop : loops.loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const EdgeUse &next = loop[(i + 1) % loop.size()];
            EXPECT_NEAR(loop[i].end().u, next.begin().u, 1e-9);
            EXPECT_NEAR(loop[i].end().v, next.begin().v, 1e-9);
            EXPECT_LT(distance(surface.at(loop[i].begin()), loop[i].start), 1e-7);
        }
    }
}

TEST(FaceLoops, ABoxHasOneLoopOfFourRightAnglesAFace) {
    const CadShape shape = make_shape(BRepPrimAPI_MakeBox(3, 2, 1).Shape());
    for (int n = 1; n <= 6; ++n) {
        Refusal refusal;
        const auto loops = face_loops(shape, n, refusal);
        ASSERT_TRUE(loops) << refusal.reason;
        ASSERT_EQ(loops->loops.size(), 1U);
        ASSERT_EQ(loops->loops[0].size(), 4U);
        expect_closed(shape, n, *loops);
        // Counter-clockwise about the outward normal.
        Vec3 vector_area{};
        const FaceLoop &loop = loops->loops[0];
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_NEAR(loop[i].angle, pi / 2, 1e-6);
            EXPECT_FALSE(loop[i].seam);
            vector_area += 0.5 * cross(loop[i].start, loop[(i + 1) % 4].start);
        }
        const Vec3 middle = 0.25 * (loop[0].start + loop[1].start + loop[2].start + loop[3].start);
        EXPECT_GT(dot(vector_area, middle - Vec3{1.5, 1, 0.5}), 0);
        EXPECT_GT(dot(vector_area, FaceSurface(shape.face(n)).normal(loop[0].begin())), 0);
    }
}

TEST(FaceLoops, TheHoleRunsClockwiseAndComesLast) {
    const CadShape shape =
        make_shape(BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(gp_Pnt(-3, -3, 0), gp_Pnt(3, 3, 1)).Shape(),
                                   BRepPrimAPI_MakeBox(gp_Pnt(-1, -1, -1), gp_Pnt(1, 1, 2)).Shape())
                       .Shape());
    int with_hole = 0;
    for (int n = 1; n <= shape.faces.Extent(); ++n) {
        Refusal refusal;
        const auto loops = face_loops(shape, n, refusal);
        ASSERT_TRUE(loops);
        expect_closed(shape, n, *loops);
        if (loops->loops.size() == 2) {
            ++with_hole;
            for (const EdgeUse &use : loops->loops[0]) {
                EXPECT_NEAR(use.angle, pi / 2, 1e-6);
                EXPECT_NEAR(std::abs(use.start.x), 3, 1e-9);
            }
            for (const EdgeUse &use : loops->loops[1]) {
                EXPECT_NEAR(use.angle, 3 * pi / 2, 1e-6);
            }
        }
    }
    EXPECT_EQ(with_hole, 2);
}

TEST(FaceLoops, ClosedSurfacesAreCutOpenAtTheirSeams) {
    const auto count = [](const TopoDS_Shape &body, int face) {
        const CadShape shape = make_shape(body);
        Refusal refusal;
        const auto loops = face_loops(shape, face, refusal);
        EXPECT_TRUE(loops) << refusal.reason;
        EXPECT_EQ(loops->loops.size(), 1U);
        expect_closed(shape, face, *loops);
        int seams = 0;
        int poles = 0;
        double angles = 0;
        for (const EdgeUse &use : loops->loops[0]) {
            seams += use.seam ? 1 : 0;
            poles += use.degenerated ? 1 : 0;
            angles += use.angle;
        }
        EXPECT_NEAR(angles, 2 * pi, 1e-3); // four right angles in each
        return std::array<int, 3>{static_cast<int>(loops->loops[0].size()), seams, poles};
    };
    EXPECT_EQ(count(BRepPrimAPI_MakeCylinder(1, 2).Shape(), 1), (std::array{4, 2, 0}));
    EXPECT_EQ(count(BRepPrimAPI_MakeTorus(3, 1).Shape(), 1), (std::array{4, 4, 0}));
    EXPECT_EQ(count(BRepPrimAPI_MakeSphere(1).Shape(), 1), (std::array{4, 2, 2}));
    EXPECT_EQ(count(BRepPrimAPI_MakeCone(1, 0, 2).Shape(), 1), (std::array{4, 2, 1}));
}

TEST(FaceLoops, AFaceWithoutBoundaryIsRefusedByName) {
    const CadShape shape = make_shape(BRepBuilderAPI_MakeFace(gp_Pln()).Shape());
    Refusal refusal;
    EXPECT_FALSE(face_loops(shape, 1, refusal));
    EXPECT_NE(refusal.reason.find("Face1"), std::string::npos);
    EXPECT_EQ(refusal.blockers.size(), 1U);
}

} // namespace
