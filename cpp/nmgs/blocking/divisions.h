// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers of divisions that agree over a whole model. Opposite edges of a block have one count, and
// so have edges that blocks share: the directions of all blocks fall into chains (the sheets of
// Tam and Armstrong, Finite element mesh control by integer programming, 1993), each with one
// count.
#pragma once

#include "nmgs/blocking/topology.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace nmgs {

struct Chains {
    int dimension = 3;
    // Of direction d of block b, at b * dimension + d: its chain from 0 on, and whether it runs
    // against the chain's first direction.
    std::vector<std::int32_t> chain;
    std::vector<char> reversed;
    // Chains that come back to their own direction turned round (a Moebius strip): their spacing
    // must be symmetric.
    std::vector<char> twisted;
    std::int32_t count = 0;
};
Chains find_chains(const BlockModel &model, const Topology &topology);

// A wish for a count of a block's direction. A hard one must be met; of soft ones of a chain
// without a hard one, the largest is.
struct DivisionWish {
    std::int32_t block = 0; // 0-based
    int direction = 0;
    std::int32_t count = 1;
    bool hard = true;
};

// Divisions of all blocks: of a chain with hard wishes, that count; else the largest soft wish;
// else, where size > 0, the fewest with no element longer than size on the chain's longest edge
// (one where a patch of the chain ends in a cusp, see cusp.h); else the largest of the model's
// divisions. Raises BlockingError naming the blocks and the chain of blocks that links them when
// hard wishes contradict each other; ArgumentError for blocks, directions, counts, sizes out of
// range.
std::vector<std::array<std::int32_t, 3>> solve_divisions(const BlockModel &model,
                                                         const Topology &topology,
                                                         std::span<const DivisionWish> wishes,
                                                         double size = 0);

// Arc length of a quadratic edge through its ends and its mid-side node.
double edge_length(Vec3 low, Vec3 middle, Vec3 high);
// Mean and greatest arc length of a block's edges along a direction.
struct DirectionLength {
    double mean, longest;
};
DirectionLength direction_length(const BlockModel &model, std::size_t block, int direction);

} // namespace nmgs
