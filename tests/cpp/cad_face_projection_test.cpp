// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/face_projection.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace {

using nmgs::Vec3;
using nmgs::cad::FaceProjection;

// Points of the surface moved off it by up to `off`; OpenCASCADE's own search over the whole
// surface is the oracle for the distance.
void compare(const TopoDS_Face &face, double off) {
    FaceProjection projection(face);
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    double u0 = 0;
    double u1 = 0;
    double v0 = 0;
    double v1 = 0;
    BRepTools::UVBounds(face, u0, u1, v0, v1);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int n = 0; n < 20; ++n) {
        const gp_Pnt on =
            surface->Value(u0 + (u1 - u0) * unit(random), v0 + (v1 - v0) * unit(random));
        const Vec3 p{on.X() + off * (unit(random) - 0.5), on.Y() + off * (unit(random) - 0.5),
                     on.Z() + off * (unit(random) - 0.5)};
        projection.forget();
        const Vec3 q = projection.nearest(p);
        const GeomAPI_ProjectPointOnSurf oracle({p.x, p.y, p.z}, surface, u0, u1, v0, v1);
        if (oracle.NbPoints() > 0) {
            EXPECT_LE(distance(p, q), oracle.LowerDistance() + 1e-9)
                << surface->DynamicType()->Name() << " at " << on.X() << ' ' << on.Y() << ' '
                << on.Z();
        }
        const GeomAPI_ProjectPointOnSurf back({q.x, q.y, q.z}, surface);
        ASSERT_GT(back.NbPoints(), 0);
        EXPECT_LT(back.LowerDistance(), 1e-9);
    }
}

void compare_all(const TopoDS_Shape &shape, double off) {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    for (int n = 1; n <= faces.Extent(); ++n) {
        compare(TopoDS::Face(faces(n)), off);
    }
}

TEST(FaceProjection, IsAsNearAsOpenCascadesOwnSearch) {
    for (const TopoDS_Shape &shape :
         {BRepPrimAPI_MakeCylinder(2.0, 3.0).Shape(), BRepPrimAPI_MakeCone(2.0, 1.0, 3.0).Shape(),
          BRepPrimAPI_MakeCone(0.0, 1.0, 3.0).Shape(), BRepPrimAPI_MakeSphere(2.0).Shape(),
          BRepPrimAPI_MakeTorus(3.0, 1.0).Shape()}) {
        compare_all(shape, 0.3);
        compare_all(BRepBuilderAPI_NurbsConvert(shape).Shape(), 0.3);
    }
}

TopoDS_Face bumps() {
    TColgp_Array2OfPnt points(1, 9, 1, 9);
    for (int i = 1; i <= 9; ++i) {
        for (int j = 1; j <= 9; ++j) {
            points.SetValue(i, j, gp_Pnt(i, j, 0.5 * std::sin(i) * std::cos(0.7 * j)));
        }
    }
    return BRepBuilderAPI_MakeFace(GeomAPI_PointsToBSplineSurface(points).Surface(), 1e-7).Face();
}

TEST(FaceProjection, OfASplineIsAsNearAsOpenCascadesOwnSearch) {
    compare(bumps(), 0.2);
}

// A sheet bent like a hairpin, its two legs a tenth apart. Points that are nearer to the other leg
// stay on the leg that the row started on.
TEST(FaceProjection, ARowStaysOnItsSideOfAThinGap) {
    constexpr double half = 0.05;
    constexpr int count = 9;
    constexpr std::array<std::array<double, 2>, count> at{
        {{0, -1}, {0.7, -1}, {1.4, -1}, {2, -1}, {2.2, 0}, {2, 1}, {1.4, 1}, {0.7, 1}, {0, 1}}};
    TColgp_Array1OfPnt poles(1, count);
    for (int i = 0; i < count; ++i) {
        const auto &pole = at[static_cast<std::size_t>(i)];
        poles.SetValue(i + 1, gp_Pnt(pole[0], half * pole[1], 0));
    }
    TColStd_Array1OfReal knots(1, count - 2);
    TColStd_Array1OfInteger repeats(1, count - 2);
    for (int i = 1; i <= count - 2; ++i) {
        knots.SetValue(i, i);
        repeats.SetValue(i, i == 1 || i == count - 2 ? 4 : 1);
    }
    const Handle(Geom_Curve) hairpin = new Geom_BSplineCurve(poles, knots, repeats, 3);
    const Handle(Geom_Surface) sheet = new Geom_SurfaceOfLinearExtrusion(hairpin, gp_Dir(0, 0, 1));
    double first = 0;
    double last = 0;
    double low = 0;
    double high = 0;
    sheet->Bounds(first, last, low, high);
    FaceProjection projection(BRepBuilderAPI_MakeFace(sheet, first, last, 0, 1, 1e-7).Face());
    const gp_Pnt corner = hairpin->Value(first);
    projection.start({corner.X(), corner.Y(), corner.Z()});
    for (int i = 1; i <= 10; ++i) {
        const Vec3 q = projection.nearest({0.1 * i, 0.02, 0.5});
        EXPECT_LT(q.y, 0) << i;
    }
    // Without the row, the nearest is on the other leg.
    projection.forget();
    EXPECT_GT(projection.nearest({1.0, 0.02, 0.5}).y, 0);
}

TEST(FaceProjection, NormalsLookOutOfASolid) {
    for (const TopoDS_Shape &shape :
         {BRepPrimAPI_MakeSphere(2.0).Shape(),
          BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeSphere(2.0).Shape()).Shape()}) {
        TopTools_IndexedMapOfShape faces;
        TopExp::MapShapes(shape, TopAbs_FACE, faces);
        FaceProjection projection(TopoDS::Face(faces(1)));
        for (const Vec3 p : {Vec3{2, 0, 0}, Vec3{-1.2, 0.0, 1.6}, Vec3{0, 0, 2}, Vec3{0, 0, -2}}) {
            projection.forget();
            EXPECT_NEAR(dot(projection.normal(p), p), 2, 1e-3);
        }
    }
    // The wall of a hole looks to its axis.
    TopoDS_Shape inside_out = BRepPrimAPI_MakeCylinder(1.0, 1.0).Shape().Reversed();
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(inside_out, TopAbs_FACE, faces);
    FaceProjection wall(TopoDS::Face(faces(1)));
    EXPECT_NEAR(wall.normal({1, 0, 0.5}).x, -1, 1e-12);
}

TEST(FaceProjection, GoesOverASeamThatOpenCascadeDoesNotTakeForClosed) {
    // A cylinder interpolated all round but for 1e-4.
    constexpr int around = 33;
    const double whole = 2 * std::acos(-1.0) - 1e-4;
    TColgp_Array2OfPnt points(1, around, 1, 4);
    for (int i = 1; i <= around; ++i) {
        for (int j = 1; j <= 4; ++j) {
            const double a = whole * (i - 1) / (around - 1);
            points(i, j) = {2 * std::cos(a), 2 * std::sin(a), 1.0 * j};
        }
    }
    const Handle(Geom_BSplineSurface) surface =
        GeomAPI_PointsToBSplineSurface(points, 3, 8, GeomAbs_C2, 1e-6).Surface();
    ASSERT_FALSE(surface->IsUClosed());
    FaceProjection projection(BRepBuilderAPI_MakeFace(surface, 1e-7).Face());
    const auto place = [](double a) { return Vec3{2.05 * std::cos(a), 2.05 * std::sin(a), 2}; };
    projection.start(place(0.3));
    for (double a = 0.3; a > -0.6; a -= 0.1) {
        EXPECT_NEAR(distance(projection.nearest(place(a)), place(a)), 0.05, 1e-3) << a;
    }
}

TEST(FaceProjection, FindsTheFootAtTheTightEndOfABlade) {
    // A thin closed curve with few intervals of its parameter between places of much curvature.
    constexpr int around = 160;
    TColgp_Array1OfPnt points(1, around + 1);
    for (int i = 0; i <= around; ++i) {
        const double a = 2 * std::acos(-1.0) * i / around;
        points(i + 1) = {100 * std::cos(a), 6 * std::sin(a), 0};
    }
    const Handle(Geom_BSplineCurve) curve =
        GeomAPI_PointsToBSpline(points, 3, 3, GeomAbs_C2, 1e-7).Curve();
    const Handle(Geom_Surface) surface = new Geom_SurfaceOfLinearExtrusion(curve, gp_Dir(0, 0, 1));
    const double middle = 0.5 * (curve->FirstParameter() + curve->LastParameter());
    const double last = curve->LastParameter();
    // A little more than one side of it, with one of the tight ends inside.
    const double first = middle - 0.1 * (last - middle);
    FaceProjection projection(BRepBuilderAPI_MakeFace(surface, first, last, 0, 20, 1e-7).Face());
    for (double t = first; t < last; t += 0.003 * (last - first)) {
        gp_Pnt p;
        gp_Vec d;
        curve->D1(t, p, d);
        const gp_Vec inwards = gp_Vec(0, 0, 1).Crossed(d).Normalized() * 0.15;
        projection.forget();
        const Vec3 q{p.X() + inwards.X(), p.Y() + inwards.Y(), 7};
        EXPECT_LE(distance(projection.nearest(q), q), 0.1501) << t;
    }
}

} // namespace
