// SPDX-License-Identifier: LGPL-2.1-or-later
// Corners of patches and blocks that are good only as long as their elements are not too small:
// where sides leave in the same direction, or in opposite ones, though the corners are well apart.
#pragma once

#include "nmgs/support/vec3.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace nmgs {

// Whether two sides of an 8-node patch leave one of its corners in about the same direction, though
// its corners are apart: undivided it is a good quad, and the finer it is divided, the nearer the
// angle there comes to nothing. nodes: eight, corners first.
bool ends_in_cusp(std::span<const Vec3> nodes);

// Of a 20-node block: the directions along which two divisions would spoil a corner that one
// division leaves as it should be.
std::array<bool, 3> spoilt_by_division(std::span<const Vec3, 20> nodes);

// Whether a 20-node block has such a corner at which sides leave in the same direction: that angle
// is the shape's own. Where they leave in opposite ones, other blocks may have no such corner.
bool ends_in_knife(std::span<const Vec3, 20> nodes);

// The point of a block's edge from a corner (0 to 7) along a direction, at a share of its length.
using EdgePlace = std::function<Vec3(std::size_t corner, std::size_t direction, double share)>;
// Of a 20-node block's own edges.
EdgePlace edges_of(std::span<const Vec3, 20> nodes);

// Shares of a block's directions that the element at their start and their end must have at least
// for the corners to be as good as they can be: [direction][0 at -1, 1 at +1], 0 where the given
// divisions, each of the same size, do already. nodes tell which corners need a closer look.
std::array<std::array<double, 2>, 3> shares_of_ends(std::span<const Vec3, 20> nodes,
                                                    const EdgePlace &edges,
                                                    const std::array<std::int32_t, 3> &divisions);

} // namespace nmgs
