// SPDX-License-Identifier: LGPL-2.1-or-later
// What is left of solids after some cuts through all of them, and what these pieces ask for.
#pragma once

#include "nmgs_cad/cut_proposals.h"
#include "nmgs_cad/midpoint_obstacles.h"
#include "nmgs_cad/split.h"

#include <optional>
#include <span>
#include <vector>

namespace nmgs::cad {

struct CutState {
    std::vector<Cut> cuts;
    Pieces pieces;
    std::vector<int> bad;             // pieces with obstacles to mid-point subdivision
    std::vector<Obstacles> obstacles; // of these
    Proposals proposals;
    double weight = 0; // how far from pieces without obstacles
};

// The pieces of a state, or of the solids where it is null, cut by more planes and cylinders.
std::optional<CutState> cut_further(const CadShape &shape, std::span<const int> solids,
                                    const CutState *before, std::span<const Cut> more,
                                    Refusal &refusal);

// What it takes to look at pieces, in plain faces; others take longer to intersect.
int work_of(const Pieces &pieces);

} // namespace nmgs::cad
