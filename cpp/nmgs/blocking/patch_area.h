// SPDX-License-Identifier: LGPL-2.1-or-later
// Area of an 8-node patch, and what of it quads with straight sides keep.
#pragma once

#include "nmgs/blocking/topology.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace nmgs {

struct PatchArea {
    double linear = 0; // of the quads of a uniform lattice: half the cross product of diagonals
    double exact = 0;  // of the patch, by 3 x 3 Gauss points
};

// block: from 0; divisions: of the lattice, 1 or more each.
PatchArea patch_area(const BlockModel &model, std::size_t block,
                     const std::array<std::int32_t, 3> &divisions);

} // namespace nmgs
