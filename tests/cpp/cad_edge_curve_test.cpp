// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/edge_curve.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <gp_Circ.hxx>

#include <gtest/gtest.h>

#include <numbers>

namespace {

using nmgs::cad::EdgeCurve;

TEST(EdgeCurve, DividesAnArcByItsAngle) {
    const gp_Circ circle(gp_Ax2(), 2.0);
    const EdgeCurve curve(BRepBuilderAPI_MakeEdge(circle, 0.0, std::numbers::pi / 2).Edge());
    EXPECT_NEAR(curve.length(), std::numbers::pi, 1e-12);
    const auto p = curve.at(1.0 / 3);
    EXPECT_NEAR(p.x, 2 * std::cos(std::numbers::pi / 6), 1e-12);
    EXPECT_NEAR(p.y, 2 * std::sin(std::numbers::pi / 6), 1e-12);
}

// A straight Bezier curve with uneven speed: half the length is half the way, not half the
// parameter.
TEST(EdgeCurve, GoesByLengthNotByParameter) {
    TColgp_Array1OfPnt poles(1, 3);
    poles.SetValue(1, gp_Pnt(0, 0, 0));
    poles.SetValue(2, gp_Pnt(0.5, 0, 0));
    poles.SetValue(3, gp_Pnt(4, 0, 0));
    const Handle(Geom_Curve) bezier = new Geom_BezierCurve(poles);
    const EdgeCurve curve(BRepBuilderAPI_MakeEdge(bezier).Edge());
    for (const double f : {0.0, 0.1, 0.5, 0.9, 1.0}) {
        EXPECT_NEAR(curve.at(f).x, 4 * f, 1e-6);
        EXPECT_NEAR(curve.fraction({4 * f, 0, 0}), f, 1e-6);
    }
}

} // namespace
