// SPDX-License-Identifier: LGPL-2.1-or-later
// Points of a CAD edge by the fraction of its length.
#pragma once

#include "nmgs/support/vec3.h"

#include <BRepAdaptor_Curve.hxx>
#include <TopoDS_Edge.hxx>

namespace nmgs::cad {

class EdgeCurve {
public:
    // Runs from the edge's first vertex (in the sense of its curve, not of its orientation).
    explicit EdgeCurve(const TopoDS_Edge &edge);

    [[nodiscard]] double length() const { return length_; }
    // Point at a fraction in [0, 1] of the length.
    [[nodiscard]] Vec3 at(double fraction) const;
    // Fraction of the length at the edge's point that is nearest to p.
    [[nodiscard]] double fraction(Vec3 p) const;

private:
    BRepAdaptor_Curve curve_;
    double length_;
};

} // namespace nmgs::cad
