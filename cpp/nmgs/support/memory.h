// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

namespace nmgs {

// Bytes that a new allocation can hope for; a very large number where the system does not tell.
std::int64_t available_memory();

// Raises ArgumentError with both figures when a request of that many bytes cannot fit.
void require_memory(std::int64_t bytes, const char *what);

} // namespace nmgs
