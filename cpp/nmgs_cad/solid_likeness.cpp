// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs_cad/solid_likeness.h"

#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>

namespace nmgs::cad {

SolidLikeness likeness_of(const CadShape &shape, int solid) {
    SolidLikeness result;
    const TopoDS_Solid of = shape.solid(solid);
    GProp_GProps whole;
    BRepGProp::VolumeProperties(of, whole);
    auto &size = result.size;
    size[0] = std::abs(whole.Mass());
    constexpr std::array<TopAbs_ShapeEnum, 3> kinds{TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX};
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        TopTools_IndexedMapOfShape parts;
        TopExp::MapShapes(of, kinds[k], parts);
        result.count[k] = parts.Extent();
        for (int n = 1; n <= parts.Extent(); ++n) {
            double measure = 0;
            if (kinds[k] == TopAbs_VERTEX) {
                measure = BRep_Tool::Pnt(TopoDS::Vertex(parts(n))).Distance(whole.CentreOfMass());
            } else {
                GProp_GProps properties;
                kinds[k] == TopAbs_FACE ? BRepGProp::SurfaceProperties(parts(n), properties)
                                        : BRepGProp::LinearProperties(parts(n), properties);
                measure = properties.Mass();
            }
            size[2 * k + 1] += measure;
            size[2 * k + 2] += measure * measure;
        }
    }
    return result;
}

bool alike(const SolidLikeness &a, const SolidLikeness &b) {
    if (a.count != b.count) {
        return false;
    }
    constexpr double same = 1e-6;
    for (std::size_t i = 0; i < a.size.size(); ++i) {
        if (std::abs(a.size[i] - b.size[i]) >
            same * std::max(std::abs(a.size[i]), std::abs(b.size[i]))) {
            return false;
        }
    }
    return true;
}

} // namespace nmgs::cad
