// SPDX-License-Identifier: LGPL-2.1-or-later
// How far a solid is from one that can be swept: a guess from its faces, quickly made.
#pragma once

#include "nmgs_cad/cad_shape.h"

#include <set>
#include <vector>

namespace nmgs::cad {

struct SweepDirection {
    Vec3 along;          // unit
    std::set<int> faces; // neither walls along it nor caps over it, or caps that meet in an edge
    int edges = 0;       // askew on walls
    [[nodiscard]] int cost() const { return static_cast<int>(faces.size()) + edges; }
};

struct Sweepability {
    int cost = 0; // 0: some strategy should fill it
    // Normals of plane faces and axes of round ones, the most promising first; empty where the
    // solid is one of revolution, a loft, or for mid-point subdivision.
    std::vector<SweepDirection> directions;
};

Sweepability sweepability(const CadShape &shape, int solid);

} // namespace nmgs::cad
