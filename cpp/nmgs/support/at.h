// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace nmgs {

// A number from 0 on as the place in a vector.
constexpr std::size_t at(std::int32_t n) {
    return static_cast<std::size_t>(n);
}

} // namespace nmgs
