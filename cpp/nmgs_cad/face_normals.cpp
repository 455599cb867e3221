// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/face_normals.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>

namespace nmgs::cad {

std::vector<PointNormal> sample_normals(const TopoDS_Face &face, int each_way) {
    const BRepAdaptor_Surface surface(face, Standard_False);
    double u0 = 0;
    double u1 = 0;
    double v0 = 0;
    double v1 = 0;
    BRepTools::UVBounds(face, u0, u1, v0, v1);
    const double sign = face.Orientation() == TopAbs_REVERSED ? -1 : 1;
    std::vector<PointNormal> result;
    for (int i = 0; i < each_way; ++i) {
        for (int j = 0; j < each_way; ++j) {
            gp_Pnt p;
            gp_Vec du;
            gp_Vec dv;
            surface.D1(u0 + (u1 - u0) * (i + 0.5) / each_way, v0 + (v1 - v0) * (j + 0.5) / each_way,
                       p, du, dv);
            const gp_Vec n = du.Crossed(dv);
            const double length = n.Magnitude();
            if (length > 1e-12 * du.Magnitude() * dv.Magnitude() && length > 0) {
                const double s = sign / length;
                result.push_back({{p.X(), p.Y(), p.Z()}, {s * n.X(), s * n.Y(), s * n.Z()}});
            }
        }
    }
    return result;
}

} // namespace nmgs::cad
