// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>

namespace nmgs {

// Both numbers, the smaller first: the key of what lies between two points, from either side.
template <class Number>
constexpr std::array<Number, 2> ascending(Number a, Number b) {
    return a < b ? std::array{a, b} : std::array{b, a};
}

} // namespace nmgs
