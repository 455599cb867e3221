// SPDX-License-Identifier: LGPL-2.1-or-later
// Halves blocks until their faces are as near to the CAD as is asked for.
#pragma once

#include "nmgs/support/progress.h"
#include "nmgs_cad/cad_blocks.h"
#include "nmgs_cad/cad_shape.h"

#include <set>

namespace nmgs::cad {

// Splits along whole chains of blocks, only in directions in which the quadratic does not follow
// the CAD, until no block's face is farther than tolerance from its CAD face, or no more than
// max_rounds times. Chains whose halving would lead to more than most_blocks blocks are kept, the
// least bad ones first: in unstructured layouts a chain goes through most of the blocks. The
// report's errors are measured anew and say what was reached. share_of_size: an entry of the report
// asks for that part of its own size where this is less than the tolerance; 0: never. kept: edges
// (n of EdgeN) whose chains are not halved: their segments were counted.
CadBlocks refine_to_tolerance(const CadShape &shape, CadBlocks blocks, double tolerance,
                              int max_rounds, const Progress &progress = {},
                              std::size_t most_blocks = 4096, double share_of_size = 0,
                              const std::set<int> &kept = {});

// Largest distance of the faces of blocks [first, last) from the CAD faces that they lie on, by
// sampling, and where.
struct FitError {
    double distance = 0;
    std::array<double, 3> place{0, 0, 0};
};
FitError measure(const CadShape &shape, const CadBlocks &blocks, std::int32_t first,
                 std::int32_t last);

// Measures each entry of the report that has blocks, and writes error and place into it.
void measure_report(const CadShape &shape, CadBlocks &blocks);

} // namespace nmgs::cad
