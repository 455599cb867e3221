// SPDX-License-Identifier: LGPL-2.1-or-later
// A face's surface: nearest point from a guess, normal and curvature.
#pragma once

#include "nmgs/support/vec3.h"

#include <BRepAdaptor_Surface.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopoDS_Face.hxx>

namespace nmgs::cad {

struct Uv {
    double u = 0, v = 0;
};

// The surface at a point of it. Curvatures are in 1 / length; major is the one of larger amount.
struct SurfaceFrame {
    bool regular = false; // false at a pole, where there is neither normal nor curvature
    Vec3 normal{0, 0, 0}; // outwards, by the face's orientation
    double major = 0, minor = 0;
    Vec3 major_direction{0, 0, 0};

    // Curvature of the surface along a direction, which need not be tangent; always positive.
    [[nodiscard]] double along(Vec3 direction) const;
};

class FaceGeometry {
public:
    explicit FaceGeometry(const TopoDS_Face &face);

    [[nodiscard]] Vec3 at(Uv uv) const;
    // Parameters of the point of the surface that is nearest to p: in closed form for elementary
    // surfaces, else by Newton's method from the guess, else by a search over the face.
    [[nodiscard]] Uv nearest(Vec3 p, Uv guess) const;
    [[nodiscard]] SurfaceFrame frame(Uv uv) const;
    [[nodiscard]] bool planar() const { return surface_.GetType() == GeomAbs_Plane; }
    // Neither turns by more than a little from one point to the next, nor changes its curvature.
    [[nodiscard]] bool elementary() const;

private:
    [[nodiscard]] bool newton(Vec3 p, Uv &uv) const;

    BRepAdaptor_Surface surface_;
    Handle(ShapeAnalysis_Surface) search_;
    bool reversed_;
    Uv low_, high_; // of the face
    double scale_;  // size of the face, for tolerances
};

} // namespace nmgs::cad
