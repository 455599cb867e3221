// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace nmgs {

// Bytes that a new allocation can hope for; a very large number where the system does not tell.
std::int64_t available_memory();

// Raises ArgumentError with both figures when a request of that many bytes cannot fit.
void require_memory(std::int64_t bytes, const char *what);

// Memory for count values of that many bytes each, aligned for any type and not written yet. Large
// blocks ask the system for large pages: handing out fresh memory page by page otherwise takes
// longer than filling it. Raises std::bad_alloc. Give it back with release().
void *allocate(std::size_t count, std::size_t bytes_each);
void release(void *memory);

} // namespace nmgs
