// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/face_geometry.h"

#include "nmgs_cad/occt_vec.h"

#include <BRepLProp_SLProps.hxx>
#include <BRep_Tool.hxx>
#include <ElSLib.hxx>
#include <Precision.hxx>

#include <algorithm>
#include <cmath>

namespace nmgs::cad {
namespace {} // namespace

double SurfaceFrame::along(Vec3 direction) const {
    const Vec3 tangent = direction - dot(direction, normal) * normal;
    const double l = norm2(tangent);
    if (!regular || l == 0) {
        return std::abs(major);
    }
    const double c = dot(tangent, major_direction);
    const double share = std::min(1.0, c * c / l);
    return std::abs(major * share + minor * (1 - share));
}

FaceGeometry::FaceGeometry(const TopoDS_Face &face)
    : surface_(face, Standard_True), search_(new ShapeAnalysis_Surface(BRep_Tool::Surface(face))),
      reversed_(face.Orientation() == TopAbs_REVERSED), low_{surface_.FirstUParameter(),
                                                             surface_.FirstVParameter()},
      high_{surface_.LastUParameter(), surface_.LastVParameter()} {
    const Vec3 a = at(low_);
    const Vec3 b = at({0.5 * (low_.u + high_.u), 0.5 * (low_.v + high_.v)});
    scale_ = std::max(distance(a, b), Precision::Confusion());
}

bool FaceGeometry::elementary() const {
    switch (surface_.GetType()) {
    case GeomAbs_Plane:
    case GeomAbs_Cylinder:
    case GeomAbs_Cone:
    case GeomAbs_Sphere:
    case GeomAbs_Torus:
        return true;
    default:
        return false;
    }
}

Vec3 FaceGeometry::at(Uv uv) const {
    return vec(surface_.Value(uv.u, uv.v).XYZ());
}

bool FaceGeometry::newton(Vec3 p, Uv &uv) const {
    const bool round_u = surface_.IsUPeriodic();
    const bool round_v = surface_.IsVPeriodic();
    Uv x = uv;
    double before = -1;
    for (int step = 0; step < 12; ++step) {
        gp_Pnt s;
        gp_Vec su, sv, suu, svv, suv;
        surface_.D2(x.u, x.v, s, su, sv, suu, svv, suv);
        const gp_Vec r(pnt(p), s);
        const double distance2 = r.SquareMagnitude();
        if (before >= 0 && distance2 > before * 1.5 + 1e-20 * scale_ * scale_) {
            return false;
        }
        before = distance2;
        const double gu = r * su;
        const double gv = r * sv;
        const double lu = su.SquareMagnitude();
        const double lv = sv.SquareMagnitude();
        // Where the Hessian is not definite, its part that is (Gauss-Newton).
        double a = lu + r * suu;
        double b = su * sv + r * suv;
        double c = lv + r * svv;
        if (a <= 0 || a * c - b * b <= 1e-6 * lu * lv) {
            a = lu;
            b = su * sv;
            c = lv;
        }
        const double det = a * c - b * b;
        if (det <= 1e-14 * lu * lv) {
            return false;
        }
        Uv next{x.u - (c * gu - b * gv) / det, x.v - (a * gv - b * gu) / det};
        if (!round_u) {
            next.u = std::clamp(next.u, low_.u, high_.u);
        }
        if (!round_v) {
            next.v = std::clamp(next.v, low_.v, high_.v);
        }
        const double du = next.u - x.u;
        const double dv = next.v - x.v;
        // Round and round a periodic surface leads nowhere; OpenCASCADE fails far out.
        if (!(std::abs(du) <= high_.u - low_.u) || !(std::abs(dv) <= high_.v - low_.v)) {
            return false;
        }
        x = next;
        if (du * du * lu + dv * dv * lv < 1e-18 * scale_ * scale_) {
            uv = x;
            return true;
        }
    }
    return false;
}

Uv FaceGeometry::nearest(Vec3 p, Uv guess) const {
    Uv uv = guess;
    switch (surface_.GetType()) {
    case GeomAbs_Plane:
        ElSLib::Parameters(surface_.Plane(), pnt(p), uv.u, uv.v);
        return uv;
    case GeomAbs_Cylinder:
        ElSLib::Parameters(surface_.Cylinder(), pnt(p), uv.u, uv.v);
        return uv;
    case GeomAbs_Cone:
        ElSLib::Parameters(surface_.Cone(), pnt(p), uv.u, uv.v);
        return uv;
    case GeomAbs_Sphere:
        ElSLib::Parameters(surface_.Sphere(), pnt(p), uv.u, uv.v);
        return uv;
    case GeomAbs_Torus:
        ElSLib::Parameters(surface_.Torus(), pnt(p), uv.u, uv.v);
        return uv;
    default:
        break;
    }
    if (newton(p, uv)) {
        return uv;
    }
    const gp_Pnt2d found = search_->ValueOfUV(pnt(p), Precision::Confusion());
    return {found.X(), found.Y()};
}

SurfaceFrame FaceGeometry::frame(Uv uv) const {
    SurfaceFrame frame;
    BRepLProp_SLProps properties(surface_, uv.u, uv.v, 2, 1e-9);
    if (!properties.IsNormalDefined()) {
        return frame;
    }
    const gp_Vec du = properties.D1U();
    const gp_Vec dv = properties.D1V();
    const double area = du.Crossed(dv).Magnitude();
    if (area <= 1e-9 * du.Magnitude() * dv.Magnitude() || du.Magnitude() < 1e-9 * scale_ ||
        dv.Magnitude() < 1e-9 * scale_) {
        // Parameters with a length of their own may make short derivatives; only poles matter.
        if (area <= 1e-12 * std::max(du.SquareMagnitude(), dv.SquareMagnitude())) {
            return frame;
        }
    }
    frame.regular = true;
    frame.normal = vec(properties.Normal().XYZ());
    if (reversed_) {
        frame.normal = -1.0 * frame.normal;
    }
    if (!planar() && properties.IsCurvatureDefined()) {
        frame.major = properties.MaxCurvature();
        frame.minor = properties.MinCurvature();
        gp_Dir most, least;
        if (properties.IsUmbilic()) {
            frame.major_direction = (1 / du.Magnitude()) * vec(du.XYZ());
        } else {
            properties.CurvatureDirections(most, least);
            frame.major_direction = vec(most.XYZ());
            if (std::abs(frame.minor) > std::abs(frame.major)) {
                std::swap(frame.major, frame.minor);
                frame.major_direction = vec(least.XYZ());
            }
        }
    }
    return frame;
}

} // namespace nmgs::cad
