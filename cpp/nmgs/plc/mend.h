// SPDX-License-Identifier: LGPL-2.1-or-later
// Mends that change no geometry: what a mesher would have to guess is left alone.
#pragma once

#include "nmgs/plc/check.h"

#include <string>

namespace nmgs {

struct Mended {
    Plc plc;
    std::vector<std::int32_t> facet_of; // facet of the old PLC for each one of the new
    std::vector<std::string> done;      // in words, one line a kind
};

// Merges duplicate points; removes facets without area (a triangle that is a line first gives its
// middle point to the facets beside it, so that no gap stays) and all but the first of duplicate
// facets; turns facets so that surfaces are oriented, outwards where they close.
Mended mend(const Plc &plc, const CheckOptions &options = {}, const Progress &progress = {});

} // namespace nmgs
