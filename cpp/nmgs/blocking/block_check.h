// SPDX-License-Identifier: LGPL-2.1-or-later
// What is wrong with a model before it is meshed. Costs time by the number of blocks, not by their
// divisions, except where two blocks touch without sharing a face.
#pragma once

#include "nmgs/blocking/topology.h"
#include "nmgs/support/error.h"
#include "nmgs/support/progress.h"

#include <string>
#include <vector>

namespace nmgs {

enum class ProblemKind {
    folded,    // a block's Jacobian changes its sign
    collapsed, // ... or reaches zero
    mirrored,  // a block numbered left-handed, or a patch turned over against its neighbour
    divisions, // blocks that meet with different divisions
    spacing,   // ... or gradings
    gap,       // blocks that nearly meet
    overlap    // blocks that share space
};
// "folded", "collapsed", ...
const char *name(ProblemKind kind);

struct BlockProblem {
    ProblemKind kind;
    std::int32_t block_a, block_b; // 0-based; block_b is -1 where one block is concerned
    Vec3 place;
    std::string text; // the whole sentence, naming the blocks from 1 on, as "Block2 face 1-2-3-4"
};

// In order of kind, then of blocks; after a thousand overlaps no more are looked for. A gap is more
// than topology.tolerance and less than a fifth of the smallest element edge. The model must be
// valid (see validate).
std::vector<BlockProblem> check_blocks(const BlockModel &model, const Topology &topology,
                                       const Progress &progress = {});

// The problems as one error: the first in words, the number of the others.
BlockingError as_error(const std::vector<BlockProblem> &problems);

} // namespace nmgs
