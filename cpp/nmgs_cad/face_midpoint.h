// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces with two, three or five logical sides.
#pragma once

#include "nmgs_cad/face_mesh.h"
#include "nmgs_cad/refusal.h"

#include <optional>
#include <vector>

namespace nmgs::cad {

// Uses of the face's only loop at which it has a corner; none when the loop's other vertices are
// not nearly straight, when there are poles, holes, or not two, three or five corners.
std::vector<std::size_t> midpoint_corners(const FaceLoops &loops);

// Numbers of segments along the lines from the sides to the middle of a face with three or five
// sides of n segments: the block at corner i has lines[i - 1] and lines[i] segments. None when
// there are no such numbers, all positive (T. S. Li, R. M. McKeag and C. G. Armstrong,
// Hexahedral meshing using midpoint subdivision and integer programming, 1995).
std::optional<std::vector<int>> midpoint_lines(const std::vector<int> &n);

// Three or five sides: a block of quads at each corner round a middle node. Two sides with equal
// numbers of segments: two rows of quads along a line between them.
std::optional<FaceMesh> midpoint_quads(const FaceSurface &surface,
                                       const std::vector<std::size_t> &corners,
                                       const std::vector<BoundaryLoop> &boundary, Refusal &refusal);

} // namespace nmgs::cad
