// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/primitive.h"

#include "cad_filling.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <gp_GTrsf.hxx>

#include <numbers>

namespace {

using nmgs::cad::fill_all;
using nmgs::cad::fill_primitive;
using nmgs::cad::make_shape;
using std::numbers::pi;

// Volume of the mesh against the closed form: 32 chords in place of a circle leave 0.64 % of it
// out, and twice that of a torus.
void expect_filled(const TopoDS_Shape &shape, double volume, double worst) {
    const auto result = fill_all(&fill_primitive, make_shape(shape));
    ASSERT_TRUE(result.filled) << result.refusal.reason;
    EXPECT_GT(result.worst, worst);
    EXPECT_NEAR(result.volume, volume, 0.015 * volume);
}

TEST(Primitive, Cylinder) {
    expect_filled(BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape(), 20 * pi, 0.4);
}
TEST(Primitive, Tube) {
    const TopoDS_Shape outer = BRepPrimAPI_MakeCylinder(3.0, 4.0).Shape();
    const TopoDS_Shape inner = BRepPrimAPI_MakeCylinder(2.0, 4.0).Shape();
    expect_filled(BRepAlgoAPI_Cut(outer, inner).Shape(), 20 * pi, 0.4);
}
TEST(Primitive, Cone) {
    expect_filled(BRepPrimAPI_MakeCone(3.0, 0.0, 2.0).Shape(), 6 * pi, 0.3);
}
TEST(Primitive, Frustum) {
    expect_filled(BRepPrimAPI_MakeCone(3.0, 1.0, 3.0).Shape(), 13 * pi, 0.4);
}
TEST(Primitive, Ball) {
    expect_filled(BRepPrimAPI_MakeSphere(3.0).Shape(), 36 * pi, 0.4);
}
TEST(Primitive, HollowSphere) {
    const TopoDS_Shape outer = BRepPrimAPI_MakeSphere(3.0).Shape();
    const TopoDS_Shape inner = BRepPrimAPI_MakeSphere(1.5).Shape();
    expect_filled(BRepAlgoAPI_Cut(outer, inner).Shape(), 31.5 * pi, 0.2);
}
TEST(Primitive, Torus) {
    expect_filled(BRepPrimAPI_MakeTorus(5.0, 1.0).Shape(), 10 * pi * pi, 0.4);
}
TEST(Primitive, SteppedShaftWithAHoleFromOneEnd) {
    const TopoDS_Shape thick = BRepPrimAPI_MakeCylinder(3.0, 6.0).Shape();
    const TopoDS_Shape groove = BRepAlgoAPI_Cut(
        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 4), gp::DZ()), 4.0, 2.0).Shape(),
        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 4), gp::DZ()), 2.0, 2.0).Shape());
    const TopoDS_Shape hole = BRepPrimAPI_MakeCylinder(1.0, 3.0).Shape();
    const TopoDS_Shape stepped = BRepAlgoAPI_Cut(thick, groove).Shape();
    expect_filled(BRepAlgoAPI_Cut(stepped, hole).Shape(), (54 - 10 - 3) * pi, 0.2);
}
// OpenCASCADE makes one B-spline face with two poles of it: no longer a sphere by its kind.
TEST(Primitive, EllipsoidOfThreeAxes) {
    gp_GTrsf scale;
    scale.SetVectorialPart(gp_Mat(1, 0, 0, 0, 1.5, 0, 0, 0, 2));
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(1.0).Shape();
    expect_filled(BRepBuilderAPI_GTransform(ball, scale, Standard_True).Shape(), 4 * pi, 0.2);
}
TEST(Primitive, RefusesWhatIsNotTurnedAndSaysWhy) {
    const auto result =
        fill_all(&fill_primitive, make_shape(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape()));
    EXPECT_FALSE(result.filled);
    EXPECT_EQ(result.refusal.blockers, std::vector<std::string>{"Solid1"});
}

} // namespace
