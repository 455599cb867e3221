// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/edge_curve.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>

#include <gtest/gtest.h>

#include <cmath>
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

TEST(EdgeCurve, ThePartOfACircleIsOnTheSideOfItsMiddle) {
    const EdgeCurve circle(BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(), 1.0)).Edge());
    const auto at = [&](double f) { return circle.at(f); };
    const auto expect = [&](double from, double middle, double to) {
        const auto part = circle.part(at(from), at(middle), at(to));
        EXPECT_NEAR(norm(at(0.5 * (part.from + part.to)) - at(middle)), 0, 1e-9);
        EXPECT_NEAR(std::abs(part.to - part.from), std::abs(to - from), 1e-9);
    };
    expect(0, 1.0 / 6, 1.0 / 3);
    expect(1.0 / 3, 1.0 / 6, 0);
    expect(2.0 / 3, 5.0 / 6, 1);
    expect(1, 5.0 / 6, 2.0 / 3);
    expect(0.25, 0.375, 0.5);
    expect(0.9, 1.05, 1.2); // over the vertex
    expect(1.2, 1.05, 0.9);
}

// Of an ellipse the speed is uneven; half of it is half the length all the same.
TEST(EdgeCurve, FractionsOfAnEllipseGoBackAndForth) {
    const EdgeCurve ellipse(BRepBuilderAPI_MakeEdge(gp_Elips(gp_Ax2(), 5.0, 1.0)).Edge());
    // Perimeter 4 a E(e), E the complete elliptic integral of the second kind.
    EXPECT_NEAR(ellipse.length(), 4 * 5 * std::comp_ellint_2(std::sqrt(1 - 1 / 25.0)), 1e-6);
    for (const double f : {0.01, 0.2, 0.37, 0.5, 0.93}) {
        EXPECT_NEAR(ellipse.fraction(ellipse.at(f)), f, 1e-9);
    }
    EXPECT_NEAR(ellipse.at(0.5).x, -5, 1e-6);
    EXPECT_NEAR(ellipse.tangent(0.25).x, -1, 1e-6);
}

} // namespace
