// SPDX-License-Identifier: LGPL-2.1-or-later
// A CAD face's surface by its parameters: points, derivatives, and normals that are defined at
// poles as well.
#pragma once

#include "nmgs/support/vec3.h"

#include <BRepAdaptor_Surface.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopoDS_Face.hxx>

#include <array>
#include <optional>

namespace nmgs::cad {

// Parameters of a surface.
struct Uv {
    double u, v;
};
constexpr Uv operator+(Uv a, Uv b) {
    return {a.u + b.u, a.v + b.v};
}
constexpr Uv operator-(Uv a, Uv b) {
    return {a.u - b.u, a.v - b.v};
}
constexpr Uv operator*(double s, Uv a) {
    return {s * a.u, s * a.v};
}

class FaceSurface {
public:
    explicit FaceSurface(const TopoDS_Face &face);

    [[nodiscard]] Vec3 at(Uv p) const;
    // Point and normal(): both at once cost less.
    struct Place {
        Vec3 point, normal;
    };
    [[nodiscard]] Place place(Uv p) const;
    // Point and the derivatives by u and v.
    [[nodiscard]] std::array<Vec3, 3> derivatives(Uv p) const;
    // Unit normal on the side to which the oriented face's normal points. Where the derivatives do
    // not span a plane it is that of a place a little further towards the middle of the face; zero
    // when there is none either.
    [[nodiscard]] Vec3 normal(Uv p) const;
    // The larger of the two principal curvatures' magnitudes, 0 where they are not defined.
    [[nodiscard]] double curvature(Uv p) const;
    // Parameters of the surface's point nearest to p, found from a guess, in the guess's period.
    [[nodiscard]] Uv nearest(Vec3 p, Uv guess) const;
    // Least and largest parameters of the face itself.
    [[nodiscard]] Uv low() const { return low_; }
    [[nodiscard]] Uv high() const { return high_; }
    [[nodiscard]] bool plane() const;
    // The face's orientation is against its surface's.
    [[nodiscard]] bool reversed() const { return reversed_; }

private:
    BRepAdaptor_Surface surface_;
    Handle(ShapeAnalysis_Surface) analysis_;
    // The unit normal where the derivatives, from a D1, span a plane; else nothing.
    [[nodiscard]] std::optional<Vec3> normal_of(const std::array<Vec3, 3> &d) const;

    Uv low_{}, high_{};
    bool reversed_;
    std::array<Vec3, 3> flat_{}; // of a plane: its origin and axes
};

} // namespace nmgs::cad
