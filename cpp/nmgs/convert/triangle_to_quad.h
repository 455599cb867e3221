// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangles into quadrilaterals (thesis 2.2.1, Figs. 2.6 and 2.7): two of a pair into one, or each
// into three.
#pragma once

#include "nmgs/support/progress.h"
#include "nmgs/support/vec3.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace nmgs {

struct PairedTriangles {
    // Quads of two triangles each, and the numbers of these, the lower first.
    std::vector<std::array<std::int32_t, 4>> quads;
    std::vector<std::array<std::int32_t, 2>> parents;
    std::vector<std::int32_t> left; // triangles without a partner, ascending
};

// As many pairs as can be and, among these choices, the one with the largest sum of the quads'
// scaled Jacobians: a maximum-weight matching over the whole mesh. Triangles are paired over an
// edge that they alone share, when the quad is convex, their normals are less than 60 degrees apart
// and their labels (M, or none) are the same. triangles: M * 3 nodes. The matching itself cannot be
// interrupted (about 0.1 s for 10 000 triangles). Raises ArgumentError when a node is not in [0,
// points.size()).
PairedTriangles pair_triangles(std::span<const Vec3> points,
                               std::span<const std::int32_t> triangles,
                               std::span<const std::int32_t> labels, const Progress &progress = {});

// Quads at the corners of each cell of k corners: corner, middle of the edge behind it, centre,
// middle of the edge before it. cells: M * 2 k nodes, corners and mid-sides (triangle6 or quad8);
// centre of cell c: first_centre + c. quads: M * 4 k.
void split_at_corners(int corners, std::span<const std::int32_t> cells, std::int32_t first_centre,
                      std::span<std::int32_t> quads, const Progress &progress = {});

} // namespace nmgs
