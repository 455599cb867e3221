// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "nmgs_cad/cad_shape.h"

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

// Why a face is not four-sided, in words, and what stands in the way.
struct SidesRefusal {
    std::string reason;
    std::vector<std::string> blockers;
};

// The sides, or nothing and the refusal.
std::optional<FourSides> four_sides(const CadShape &shape, int face, SidesRefusal &refusal);

} // namespace nmgs::cad
