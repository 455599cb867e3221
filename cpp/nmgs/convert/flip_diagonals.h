// SPDX-License-Identifier: LGPL-2.1-or-later
// Mends split hexahedra that the shorter diagonals leave with a tetrahedron of no positive volume.
#pragma once

#include "nmgs/support/vec3.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace nmgs {

// Corners, ascending, of a face that is split by its longer diagonal.
using FlippedFace = std::array<std::int32_t, 4>;

// bad: hexahedra, ascending, that no place of their inner node mends. Of each, the fewest faces are
// split by the other diagonal, on both sides, that leave it and the neighbours with positive
// tetrahedra; where no choice does, it stays as it is. Arrays as in split_hexahedra. Returns the
// faces in ascending order. Takes milliseconds a bad hexahedron.
std::vector<FlippedFace> flip_diagonals(std::span<const Vec3> points,
                                        std::span<const std::int32_t> hexahedra,
                                        std::span<const std::int64_t> bad,
                                        std::span<std::int32_t> tetrahedra,
                                        std::span<Vec3> centroids);

} // namespace nmgs
