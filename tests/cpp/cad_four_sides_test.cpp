// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/four_sides.h"

#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>

#include <gtest/gtest.h>

namespace {

using namespace nmgs::cad;

// Twice the vector area of the corner polygon: along the outward normal when counter-clockwise.
gp_Vec vector_area(const CadShape &shape, const FourSides &sides) {
    gp_Vec area;
    const gp_Pnt origin = BRep_Tool::Pnt(shape.vertex(sides.corner[0]));
    for (std::size_t i = 1; i < 3; ++i) {
        const gp_Vec a(origin, BRep_Tool::Pnt(shape.vertex(sides.corner[i])));
        const gp_Vec b(origin, BRep_Tool::Pnt(shape.vertex(sides.corner[i + 1])));
        area += a.Crossed(b);
    }
    return area;
}

TEST(FourSides, RunCounterClockwiseAboutTheOutwardNormalOfEachFaceOfABox) {
    const CadShape shape = make_shape(BRepPrimAPI_MakeBox(3, 2, 1).Shape());
    for (int n = 1; n <= 6; ++n) {
        Refusal refusal;
        const auto sides = four_sides(shape, n, refusal);
        ASSERT_TRUE(sides) << refusal.reason;
        GProp_GProps properties;
        BRepGProp::SurfaceProperties(shape.face(n), properties);
        const gp_Vec outward(gp_Pnt(1.5, 1, 0.5), properties.CentreOfMass());
        EXPECT_GT(vector_area(shape, *sides).Dot(outward), 0) << "Face" << n;
        EXPECT_NEAR(vector_area(shape, *sides).Magnitude() / 2, properties.Mass(), 1e-9);
    }
}

TEST(FourSides, EachSideJoinsItsTwoCorners) {
    const CadShape shape = make_shape(BRepPrimAPI_MakeBox(3, 2, 1).Shape());
    for (int n = 1; n <= 6; ++n) {
        Refusal refusal;
        const auto sides = four_sides(shape, n, refusal);
        ASSERT_TRUE(sides);
        for (std::size_t i = 0; i < 4; ++i) {
            const CadShape edge = make_shape(shape.edge(sides->edge[i]));
            EXPECT_TRUE(edge.vertices.Contains(shape.vertex(sides->corner[i])));
            EXPECT_TRUE(edge.vertices.Contains(shape.vertex(sides->corner[(i + 1) % 4])));
        }
    }
}

TEST(FourSides, RefusalsSayWhyAndNameTheCulprit) {
    const CadShape cylinder = make_shape(BRepPrimAPI_MakeCylinder(1, 2).Shape());
    int seams = 0;
    for (int n = 1; n <= cylinder.faces.Extent(); ++n) {
        Refusal refusal;
        EXPECT_FALSE(four_sides(cylinder, n, refusal));
        EXPECT_NE(refusal.reason.find("Face" + std::to_string(n)), std::string::npos);
        ASSERT_FALSE(refusal.blockers.empty());
        seams += refusal.reason.find("seam") != std::string::npos ? 1 : 0;
    }
    EXPECT_EQ(seams, 1);
    const CadShape ball = make_shape(BRepPrimAPI_MakeSphere(1).Shape());
    Refusal refusal;
    EXPECT_FALSE(four_sides(ball, 1, refusal));
    EXPECT_FALSE(refusal.reason.empty());
}

} // namespace
