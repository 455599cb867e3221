// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/edge_curve.h"

#include "nmgs/support/error.h"

#include <GCPnts_AbscissaPoint.hxx>

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

} // namespace nmgs::cad
