// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/edge_curve.h"

#include "nmgs/support/error.h"

#include <Extrema_ExtPC.hxx>
#include <GCPnts_AbscissaPoint.hxx>

#include <algorithm>

namespace nmgs::cad {

EdgeCurve::EdgeCurve(const TopoDS_Edge &edge) : curve_(edge) {
    length_ = GCPnts_AbscissaPoint::Length(curve_);
}

Vec3 EdgeCurve::at(double fraction) const {
    const double first = curve_.FirstParameter();
    const double last = curve_.LastParameter();
    double parameter = first;
    if (fraction >= 1) {
        parameter = last;
    } else if (fraction > 0) {
        if (curve_.GetType() == GeomAbs_Line || curve_.GetType() == GeomAbs_Circle) {
            parameter = first + fraction * (last - first);
        } else {
            const GCPnts_AbscissaPoint point(curve_, fraction * length_, first);
            if (!point.IsDone()) {
                throw GeometryError("an edge's length cannot be divided", {});
            }
            parameter = point.Parameter();
        }
    }
    const gp_Pnt p = curve_.Value(parameter);
    return {p.X(), p.Y(), p.Z()};
}

double EdgeCurve::fraction(Vec3 p) const {
    if (norm2(at(0) - p) <= norm2({1e-9 * length_, 0, 0})) {
        return 0;
    }
    if (norm2(at(1) - p) <= norm2({1e-9 * length_, 0, 0})) {
        return 1;
    }
    const double first = curve_.FirstParameter();
    const double last = curve_.LastParameter();
    const Extrema_ExtPC extrema({p.x, p.y, p.z}, curve_, first, last);
    double best = norm2(at(0) - p) <= norm2(at(1) - p) ? first : last;
    double nearest = std::min(norm2(at(0) - p), norm2(at(1) - p));
    if (extrema.IsDone()) {
        for (int i = 1; i <= extrema.NbExt(); ++i) {
            if (extrema.SquareDistance(i) < nearest) {
                nearest = extrema.SquareDistance(i);
                best = extrema.Point(i).Parameter();
            }
        }
    }
    if (best <= first || best >= last) {
        return best <= first ? 0 : 1;
    }
    return GCPnts_AbscissaPoint::Length(curve_, first, best) / length_;
}

} // namespace nmgs::cad
