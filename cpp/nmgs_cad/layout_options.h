// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "nmgs/support/progress.h"
#include "nmgs_cad/layout.h"
#include "nmgs_cad/refusal.h"

#include <chrono>
#include <numbers>

namespace nmgs::cad {

// How coarse a layout is. The blocks are divided later; a layout only needs to be as fine as the
// shape asks for.
struct LayoutOptions {
    double size = 0; // longest segment of an edge; 0: as long as the shape allows
    double angle = std::numbers::pi / 2; // largest turn of an edge along one segment, in radians
    int attempts = 5; // how often a strategy may lay its sections out, finer from time to time
    // What searches over cuts may still do: the faces of all the pieces that they look at, which
    // they take from it. None: as much as one search ever needs.
    int *cut_work = nullptr;
    // Searches over cuts end then, whatever they still may do: a mesh must come in time.
    std::chrono::steady_clock::time_point until = std::chrono::steady_clock::time_point::max();
};

inline bool late(const LayoutOptions &options) {
    return std::chrono::steady_clock::now() > options.until;
}

// A way to fill a solid with hexahedra. True: they were added to the layout. False: the layout is
// as it was and the refusal says why. What the layout already has on the solid's edges and faces
// (from its neighbours) is kept, or is a reason to refuse.
using FillSolid = bool (*)(const CadShape &shape, int solid, Layout &layout,
                           const LayoutOptions &options, Refusal &refusal,
                           const Progress &progress);

} // namespace nmgs::cad
