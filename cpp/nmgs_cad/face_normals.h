// SPDX-License-Identifier: LGPL-2.1-or-later
// Points and normals of a CAD face, whatever kind of surface carries it.
#pragma once

#include "nmgs/support/vec3.h"

#include <TopoDS_Face.hxx>

#include <vector>

namespace nmgs::cad {

struct PointNormal {
    Vec3 point;
    Vec3 normal; // unit, outward where the face bounds a solid
};

// On a lattice over the face's range of parameters (trimming is not heeded), without those points
// that have no normal.
std::vector<PointNormal> sample_normals(const TopoDS_Face &face, int each_way = 5);

} // namespace nmgs::cad
