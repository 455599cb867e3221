// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/face_surface.h"

#include "nmgs_cad/occt_vec.h"

#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GeomLProp_SLProps.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>

namespace nmgs::cad {
namespace {} // namespace

FaceSurface::FaceSurface(const TopoDS_Face &face)
    : surface_(TopoDS::Face(face.Oriented(TopAbs_FORWARD)), Standard_False),
      analysis_(new ShapeAnalysis_Surface(BRep_Tool::Surface(face))),
      reversed_(face.Orientation() == TopAbs_REVERSED) {
    BRepTools::UVBounds(face, low_.u, high_.u, low_.v, high_.v);
    if (plane()) {
        const gp_Pln flat = surface_.Plane();
        flat_ = {vec(flat.Location().XYZ()), vec(flat.XAxis().Direction().XYZ()),
                 vec(flat.YAxis().Direction().XYZ())};
    }
}

Vec3 FaceSurface::at(Uv p) const {
    if (plane()) {
        return flat_[0] + p.u * flat_[1] + p.v * flat_[2];
    }
    return vec(surface_.Value(p.u, p.v).XYZ());
}

std::array<Vec3, 3> FaceSurface::derivatives(Uv p) const {
    if (plane()) {
        return {at(p), flat_[1], flat_[2]};
    }
    gp_Pnt point;
    gp_Vec du;
    gp_Vec dv;
    surface_.D1(p.u, p.v, point, du, dv);
    return {vec(point.XYZ()), vec(du.XYZ()), vec(dv.XYZ())};
}

std::optional<Vec3> FaceSurface::normal_of(const std::array<Vec3, 3> &d) const {
    const Vec3 n = cross(d[1], d[2]);
    const double length = norm(n);
    // The sine of the angle between the derivatives, and that none of them vanishes.
    const double scale = norm(d[1]) * norm(d[2]);
    const double extent = norm(d[1]) * (high_.u - low_.u);
    const double other = norm(d[2]) * (high_.v - low_.v);
    if (length > 1e-6 * scale && scale > 0 && extent > 1e-6 * other && other > 1e-6 * extent) {
        return ((reversed_ ? -1.0 : 1.0) / length) * n;
    }
    return std::nullopt;
}

Vec3 FaceSurface::normal(Uv p) const {
    return place(p).normal;
}

FaceSurface::Place FaceSurface::place(Uv p) const {
    const auto here = derivatives(p);
    if (const auto n = normal_of(here)) {
        return {here[0], *n};
    }
    const Uv middle = 0.5 * (low_ + high_);
    for (const double step : {1e-4, 1e-3, 1e-2, 5e-2}) {
        if (const auto n = normal_of(derivatives(p + step * (middle - p)))) {
            return {here[0], *n};
        }
    }
    return {here[0], {0, 0, 0}};
}

double FaceSurface::curvature(Uv p) const {
    if (plane()) {
        return 0;
    }
    gp_Pnt point;
    gp_Vec du;
    gp_Vec dv;
    gp_Vec duu;
    gp_Vec dvv;
    gp_Vec duv;
    surface_.D2(p.u, p.v, point, du, dv, duu, dvv, duv);
    const gp_Vec n = du.Crossed(dv);
    const double length = n.Magnitude();
    const double e = du.Dot(du);
    const double f = du.Dot(dv);
    const double g = dv.Dot(dv);
    const double det = e * g - f * f;
    if (!(length > 0) || !(det > 1e-12 * e * g)) {
        return 0;
    }
    const double l = duu.Dot(n) / length;
    const double m = duv.Dot(n) / length;
    const double k = dvv.Dot(n) / length;
    const double mean = 0.5 * (e * k - 2 * f * m + g * l) / det;
    const double gauss = (l * k - m * m) / det;
    return std::abs(mean) + std::sqrt(std::max(0.0, mean * mean - gauss));
}

Uv FaceSurface::nearest(Vec3 p, Uv guess) const {
    if (plane()) {
        return {dot(p - flat_[0], flat_[1]), dot(p - flat_[0], flat_[2])};
    }
    const gp_Pnt2d found =
        analysis_->NextValueOfUV({guess.u, guess.v}, {p.x, p.y, p.z}, Precision::Confusion());
    Uv q{found.X(), found.Y()};
    // The answer of the period in which the guess lies.
    if (surface_.IsUPeriodic()) {
        q.u += surface_.UPeriod() * std::round((guess.u - q.u) / surface_.UPeriod());
    }
    if (surface_.IsVPeriodic()) {
        q.v += surface_.VPeriod() * std::round((guess.v - q.v) / surface_.VPeriod());
    }
    return q;
}

bool FaceSurface::plane() const {
    return surface_.GetType() == GeomAbs_Plane;
}

} // namespace nmgs::cad
