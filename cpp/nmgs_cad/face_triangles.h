// SPDX-License-Identifier: LGPL-2.1-or-later
// A triangulation of a face, cut open along its seams, with nodes inside at a given spacing.
#pragma once

#include "nmgs_cad/face_mesh.h"
#include "nmgs_cad/refusal.h"

#include <array>
#include <optional>
#include <set>
#include <vector>

namespace nmgs::cad {

struct FaceTriangles {
    FaceMesh nodes;                                     // without quads; a pole is one node
    std::vector<std::array<std::int32_t, 3>> triangles; // counter-clockwise about the normal
    std::set<std::array<std::int32_t, 2>> kept;         // edges inside the face that lie on CAD
};

struct Spacing {
    double scale = 1; // of the distance of nodes inside against what the boundary asks for
    double angle = 0; // largest turn of the surface between neighbours, in radians
    double size = 0;  // largest distance; 0: none
};

// inner: lines of nodes inside the face that edges of triangles must cover.
std::optional<FaceTriangles> triangulate_face(const FaceSurface &surface,
                                              const std::vector<BoundaryLoop> &boundary,
                                              const std::vector<BoundaryLoop> &inner,
                                              const Spacing &spacing, Refusal &refusal);

} // namespace nmgs::cad
