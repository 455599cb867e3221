// SPDX-License-Identifier: LGPL-2.1-or-later
// Facets that cross: an edge of one goes through the area of another, or lies in it without being
// one of its edges, or ends in it without being one of its points.
#pragma once

#include "nmgs/plc/problem.h"
#include "nmgs/plc/welded.h"
#include "nmgs/support/box_tree.h"

namespace nmgs {

// Each pair of facets once, ascending; at most `limit`. Edges are handled by all threads.
std::vector<PlcProblem> crossings(const Welded &welded, const BoxTree &tree, std::size_t limit,
                                  const Progress &progress);

} // namespace nmgs
