// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "nmgs_cad/cad_shape.h"
#include "nmgs_cad/refusal.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace nmgs::cad {

// A face's four sides, counter-clockwise about its outward normal: side i runs from corner i to
// corner i + 1. Edges and corners are 1-based numbers of the shape.
struct FourSides {
    std::array<int, 4> edge;
    std::array<int, 4> corner;
};

// The sides, or nothing and the refusal.
std::optional<FourSides> four_sides(const CadShape &shape, int face, Refusal &refusal);

} // namespace nmgs::cad
