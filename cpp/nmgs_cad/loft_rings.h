// SPDX-License-Identifier: LGPL-2.1-or-later
// A source face, rings of four-sided faces, and a target face.
#pragma once

#include "nmgs_cad/face_loops.h"

#include <map>
#include <optional>
#include <vector>

namespace nmgs::cad {

// A four-sided face of a ring: from its low edge to its high edge.
struct LoftWall {
    int face = 0;
    // As the face's loop runs: low along its start to its end, right up, high back, left down.
    // right and left are one edge where the face is closed.
    EdgeUse low, right, high, left;
};

struct LoftRings {
    int source = 0, target = 0;
    std::vector<std::map<int, LoftWall>> rings; // by the low edge
};

// All of the solid's faces are used. Nothing when no face of the solid is such a source.
std::optional<LoftRings> loft_rings(const CadShape &shape, int solid);

} // namespace nmgs::cad
