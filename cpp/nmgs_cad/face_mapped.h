// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces with four logical sides: smooth chains of edges between four corners, one grid of quads.
#pragma once

#include "nmgs_cad/face_mesh.h"
#include "nmgs_cad/refusal.h"

#include <array>
#include <optional>

namespace nmgs::cad {

// Side i runs from the use corner[i] of the face's only loop up to corner[(i + 1) % 4], exclusive;
// ascending.
struct LogicalSides {
    std::array<std::size_t, 4> corner;
};

// The four vertices that are nearest to right angles when all others are nearly straight. A face
// with poles or holes has none.
std::optional<LogicalSides> logical_sides(const FaceLoops &loops, Refusal &refusal);

// A grid by transfinite interpolation of the surface's parameters (W. J. Gordon and C. A. Hall,
// 1973), smoothed where it is skew. Refuses opposite sides with different numbers of segments.
std::optional<FaceMesh> mapped_quads(const FaceSurface &surface, const LogicalSides &sides,
                                     const std::vector<BoundaryLoop> &boundary, Refusal &refusal);

} // namespace nmgs::cad
