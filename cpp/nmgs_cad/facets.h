// SPDX-License-Identifier: LGPL-2.1-or-later
// A shape's faces as triangles that fit together: the piecewise linear complex for TetGen.
#pragma once

#include "nmgs/support/vec3.h"
#include "nmgs_cad/cad_shape.h"

#include <array>
#include <cstdint>
#include <vector>

namespace nmgs::cad {

struct Facets {
    std::vector<Vec3> points;
    std::vector<std::array<std::int32_t, 3>> triangles; // normal out of the face, 0-based nodes
    std::vector<std::int32_t> face;                     // of each triangle, 1-based as FaceN
    std::vector<Vec3> solid_points;                     // a point inside each solid, in order
    std::vector<Vec3> hole_points;                      // a point inside each empty cavity
};

// Triangles no farther than deviation from their faces (BRepMesh_IncrementalMesh), with nodes
// shared over edges and vertices; a face between two solids comes once. Raises GeometryError that
// names the faces that OpenCASCADE cannot triangulate, or the solid without a point inside.
Facets make_facets(const CadShape &shape, double deviation);

} // namespace nmgs::cad
