// SPDX-License-Identifier: LGPL-2.1-or-later
// What keeps a solid from mid-point subdivision (see midpoint.h) into good blocks.
#pragma once

#include "nmgs_cad/cad_shape.h"

#include <numbers>
#include <set>

namespace nmgs::cad {

// Least angle of a corner of a block, in radians.
constexpr double least_angle = std::numbers::pi / 15;

// Numbers of the shape's edges, vertices and faces.
struct Obstacles {
    double weight = 0;
    int awkward = 0;        // plane faces whose middle does not see all sides
    std::set<int> edges;    // concave, smooth, closed, or with an end where a face has no corner
    std::set<int> cusps;    // where the solid runs out to nothing, or leaves nothing: no cut helps
    std::set<int> vertices; // where other than three edges meet
    std::set<int> round;    // faces with a seam or more than one loop
    std::set<int> inner;    // faces inside the solid
};

Obstacles obstacles_of(const CadShape &cad, int solid);

} // namespace nmgs::cad
