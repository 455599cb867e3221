// SPDX-License-Identifier: LGPL-2.1-or-later
// Spacing of the lattice planes along a direction of a block: n + 1 ascending positions from 0 to
// 1, for BlockModel::spacing. Sizes are parts of the whole length 1. All raise ArgumentError that
// names the argument and its value when n < 1, a size or ratio is not positive and finite, or no
// spacing has these sizes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace nmgs::grading {

// Every element is `ratio` times as long as the one before.
std::vector<double> geometric(std::int32_t n, double ratio);
// As above, with the ratio that makes the first (last) element `size` long.
std::vector<double> geometric_first(std::int32_t n, double size);
std::vector<double> geometric_last(std::int32_t n, double size);

// From each end to the middle, every element is `ratio` times as long as the one before.
std::vector<double> two_sided(std::int32_t n, double ratio);
// As above from the first and last sizes: sizes grow (or shrink) from both ends by one ratio to
// where they meet. n >= 3, or n = 2 and first + last = 1.
std::vector<double> two_sided(std::int32_t n, double first, double last);

// Hyperbolic tangent from both ends (Vinokur, On one-dimensional stretching functions for
// finite-difference calculations, J. Comput. Phys. 50, 1983): smoother than two_sided. The slopes
// at the ends are adjusted until the first and last elements have the sizes asked for.
std::vector<double> tanh(std::int32_t n, double first, double last);
// Hyperbolic tangent from the low end only (Thompson, Warsi, Mastin, Numerical Grid Generation,
// 1985, ch. VIII); the far end has slope as it comes.
std::vector<double> tanh_first(std::int32_t n, double first);

// The positions scaled from their first and last values to 0 and 1; they must ascend.
std::vector<double> explicit_positions(std::span<const double> positions);

// 1 - p in reverse order: the same spacing seen from the other end.
std::vector<double> reversed(std::span<const double> positions);

} // namespace nmgs::grading
