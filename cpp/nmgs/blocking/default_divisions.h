// SPDX-License-Identifier: LGPL-2.1-or-later
// Divisions for those who give no size: fine enough for the blocks' curvature, not too many.
#pragma once

#include "nmgs/blocking/topology.h"

#include <array>
#include <cstdint>
#include <numbers>
#include <vector>

namespace nmgs {

struct DefaultDivisions {
    double angle = 10 * std::numbers::pi / 180; // turn along an element, in radians
    // Along both directions of a face that turns in both: its volume error adds up.
    double both_angle = 7.2 * std::numbers::pi / 180;
    // Of linear blocks against quadratic ones, of each part; of patches the area's; infinite: any.
    double volume_error = 0.006;
    std::int64_t most_cells = 200'000;
    // From so many blocks on the size does not count, and the angles of blocks that come from no
    // structured strategy are so many times larger.
    std::size_t many_blocks = 1500;
    double many_blocks_factor = 4;
    // Of each block: the part, from 0, that it belongs to. Empty: all are one.
    std::vector<std::int32_t> part;
    // Of each part: whether a structured strategy made it, so that its chains are short. Empty:
    // none is.
    std::vector<char> structured;
};

// Divisions of all blocks that agree along chains (see divisions.h): no element longer than size,
// nor turning by more than the angle, nor the volume (the area) of a part's linear cells off by
// more than is asked for. Where that takes more than most_cells, size and angle grow until it does
// not, or every block has one division. Patches that end in a cusp and blocks of structured parts
// whose corners divisions would spoil (see cusp.h) keep one unless others of their chains turn too
// much. Raises ArgumentError for a size that is not positive, and for parts that are not one a
// block or have no entry in `structured`.
std::vector<std::array<std::int32_t, 3>> default_divisions(const BlockModel &model,
                                                           const Topology &topology, double size,
                                                           const DefaultDivisions &options = {});

} // namespace nmgs
