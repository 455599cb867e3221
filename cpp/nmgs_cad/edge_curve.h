// SPDX-License-Identifier: LGPL-2.1-or-later
// Points of a CAD edge by the fraction of its length.
#pragma once

#include "nmgs/support/vec3.h"

#include <BRepAdaptor_Curve.hxx>
#include <TopoDS_Edge.hxx>

#include <vector>

namespace nmgs::cad {

// Not for two threads at a time: OpenCASCADE's curves remember the span that they were asked for
// last. See CadGeometry for one a thread.
class EdgeCurve {
public:
    // Runs from the edge's first vertex (in the sense of its curve, not of its orientation).
    explicit EdgeCurve(const TopoDS_Edge &edge);

    [[nodiscard]] double length() const { return length_; }
    // Point at a fraction in [0, 1] of the length; of a closed edge, any fraction.
    [[nodiscard]] Vec3 at(double fraction) const;
    // Unit tangent there, in the sense of the curve; zero where the curve has none.
    [[nodiscard]] Vec3 tangent(double fraction) const;
    // Fraction of the length at the edge's point that is nearest to p. The point where a closed
    // edge begins and ends has fraction 0.
    [[nodiscard]] double fraction(Vec3 p) const;

    // The part of the edge from one of its points to another. Of a closed edge two parts run
    // between them and its vertex has two fractions: the one that `middle` lies nearest to counts.
    struct Part {
        double from, to;
    };
    [[nodiscard]] Part part(Vec3 from, Vec3 middle, Vec3 to) const;

private:
    [[nodiscard]] double parameter(double fraction) const;
    [[nodiscard]] double speed(double parameter) const;
    [[nodiscard]] double length_between(double from, double to) const;
    [[nodiscard]] double nearest_parameter(Vec3 p) const;
    [[nodiscard]] Vec3 point(double parameter) const;

    BRepAdaptor_Curve curve_;
    bool uniform_; // the parameter runs as the length does
    bool closed_;
    // Ends of pieces of the curve that are smooth and short: parameters, lengths up to them and
    // points.
    std::vector<double> parameters_, lengths_;
    std::vector<Vec3> points_;
    double length_;
};

} // namespace nmgs::cad
