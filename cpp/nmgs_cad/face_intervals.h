// SPDX-License-Identifier: LGPL-2.1-or-later
// How many segments each edge of some faces gets.
#pragma once

#include "nmgs_cad/edge_sizes.h"
#include "nmgs_cad/face_mapped.h"

#include <map>
#include <optional>
#include <span>
#include <vector>

namespace nmgs::cad {

// What a face is to become; at most one of the last three is set, none: anything.
struct FacePlan {
    int face = 0;
    FaceLoops loops;
    std::optional<LogicalSides> sides; // four sides that can be made equal in pairs
    std::vector<std::size_t> corners;  // of two, three or five sides
    bool ring = false;                 // two loops
    bool poor = false;                 // structured quads were tried and are no good: stays general
    bool cusps = false;                // stays general, and is laid out in the size of elements

    [[nodiscard]] bool general() const { return !sides && corners.empty() && !ring; }
    void give_up() {
        sides.reset();
        corners.clear();
        ring = false;
    }
};

// At least what the sizes ask for; edges that the layout has already keep their segments. Opposite
// sides of faces with four logical sides, two sides, and two loops of rings get equal numbers:
// single edges by equality, chains of edges by adding to the shorter one. A face for which this
// cannot be done becomes a general one. All others get an even number on their boundary, three or
// more on each loop. No two edges
// between the same vertices have a single segment each.
std::map<int, int> assign_intervals(const CadShape &shape, std::vector<FacePlan> &plans,
                                    const EdgeSizes &sizes, const Layout &layout);

// Fractions of the edges' lengths that divide them into the numbers of segments. Single edges that
// face a chain or another edge across a grid are divided as that is, so that the grid is not skew.
std::map<int, std::vector<double>> place_divisions(const std::vector<FacePlan> &plans,
                                                   const std::map<int, int> &counts,
                                                   const EdgeSizes &sizes, const Layout &layout);

} // namespace nmgs::cad
