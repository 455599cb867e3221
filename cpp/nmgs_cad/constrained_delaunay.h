// SPDX-License-Identifier: LGPL-2.1-or-later
// A constrained Delaunay triangulation of the plane: C. L. Lawson's insertion by flips (1977) and
// S. W. Sloan's recovery of edges (A fast algorithm for generating constrained Delaunay
// triangulations, 1993). What the topology depends on is decided exactly.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace nmgs::cad {

using Point2 = std::array<double, 2>;

struct Segment {
    std::int32_t a, b;
    bool bounds; // the domain lies on its left; else it lies on both sides
};

// Triangles, counter-clockwise, of the domain to the left of the bounding segments. None when a
// point appears twice or lies on a segment, or when segments cross.
std::optional<std::vector<std::array<std::int32_t, 3>>>
constrained_delaunay(std::span<const Point2> points, std::span<const Segment> segments);

} // namespace nmgs::cad
