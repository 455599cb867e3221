// SPDX-License-Identifier: LGPL-2.1-or-later
// Fills solids with hexahedra: tries the structured strategies on each and takes the best.
#pragma once

#include "nmgs_cad/layout_options.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nmgs::cad {

struct SolidStrategy {
    std::string_view name;
    FillSolid fill;
};
// In the order in which they are tried.
std::span<const SolidStrategy> solid_strategies();

struct SolidLayoutOptions {
    LayoutOptions layout;
    std::string method = "auto"; // or the name of a strategy
    double good = 0.3;           // a worst scaled Jacobian that calls for no dearer strategy
    bool cuts = true;            // whether solids may be cut
};

// Solids that share faces get hexahedra that share nodes: such a group is filled as a whole or not
// at all. Of the strategies that fill a solid the one with the best measured quality wins, above
// options.good the one with the fewest blocks. The hexahedra of a solid follow each other. An entry
// a solid: its method, or the reasons why none applies.
// Raises ArgumentError when the method is not known, Cancelled.
std::vector<FitEntry> layout_solids(const CadShape &shape, std::span<const int> solids,
                                    Layout &layout, const SolidLayoutOptions &options = {},
                                    const Progress &progress = {});

} // namespace nmgs::cad
