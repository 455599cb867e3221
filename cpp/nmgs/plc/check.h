// SPDX-License-Identifier: LGPL-2.1-or-later
// What is wrong with a PLC before TetGen sees it. Decisions beyond the tolerance are exact.
#pragma once

#include "nmgs/plc/plc.h"
#include "nmgs/plc/problem.h"
#include "nmgs/support/progress.h"

namespace nmgs {

struct CheckOptions {
    // Points nearer than this are one, and a point this near to a plane lies in it. Below 0:
    // TetGen's own 1e-8 of the diagonal of the box round all points.
    double tolerance = -1;
    // A facet is planar when its points are off its plane by no more than this share of its size.
    double planarity = 1e-6;
    // Most problems of one kind.
    std::size_t limit = 1000;
    // STL files give each triangle points of its own: equal points are then no problem.
    bool equal_points = false;
};

// All problems, ordered by kind and facet. Polls progress. Raises Cancelled.
std::vector<PlcProblem> check(const Plc &plc, const CheckOptions &options = {},
                              const Progress &progress = {});

// The absolute tolerance that the options mean for this PLC.
double tolerance_of(const Plc &plc, const CheckOptions &options);

} // namespace nmgs
