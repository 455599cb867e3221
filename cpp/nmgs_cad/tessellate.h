// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangles over the faces of a shape that meet at its edges: what TetGen takes for its boundary.
#pragma once

#include "nmgs/support/progress.h"
#include "nmgs/support/vec3.h"
#include "nmgs_cad/cad_shape.h"

#include <array>
#include <cstdint>
#include <vector>

namespace nmgs::cad {

struct Tessellation {
    std::vector<Vec3> points;
    std::vector<std::array<std::int32_t, 3>> triangles; // 0-based points
    std::vector<std::int32_t> faces;                    // n of FaceN, one a triangle
    std::vector<Vec3> solid_points;                     // a point inside SolidN, at n - 1
    std::vector<Vec3> void_points;                      // a point in each cavity of a solid
};

// OpenCASCADE's triangulation of the whole shape. Faces share the points of their common edges by
// topology, so the surface is closed where the shape is, without any tolerance. deviation: largest
// distance of a triangle from its face; angle: largest angle between neighbours, in radians.
// Raises GeometryError that names the faces or solids, Cancelled.
Tessellation tessellate(const CadShape &shape, double deviation, double angle,
                        const Progress &progress = {});

} // namespace nmgs::cad
