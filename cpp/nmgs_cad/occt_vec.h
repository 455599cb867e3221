// SPDX-License-Identifier: LGPL-2.1-or-later
// Points and vectors of OpenCASCADE as ours, and back.
#pragma once

#include "nmgs/support/vec3.h"

#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>
#include <gp_XYZ.hxx>

namespace nmgs::cad {

inline Vec3 vec(const gp_XYZ &p) {
    return {p.X(), p.Y(), p.Z()};
}
inline Vec3 vec(const gp_Pnt &p) {
    return vec(p.XYZ());
}
inline Vec3 vec(const gp_Vec &v) {
    return vec(v.XYZ());
}
inline gp_Pnt pnt(Vec3 p) {
    return {p.x, p.y, p.z};
}

} // namespace nmgs::cad
