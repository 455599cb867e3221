// SPDX-License-Identifier: AGPL-3.0-or-later
// What keeps the worker from outliving or outgrowing its use.
#pragma once

#include <cstdint>

namespace nmgs::tet {

// Bytes of address space that this process may still add to what it has; 0 for no limit.
void limit_memory(std::int64_t bytes);

// No core files: a crash of TetGen is reported, not kept.
void forbid_core_files();

// Starts a thread that ends the process as soon as nobody holds the pipe's other end. Call before
// the memory is limited; the thread reads nothing before guard_life_line() is called.
void start_life_line(int descriptor);

// From now on all input belongs to the life line.
void guard_life_line();

} // namespace nmgs::tet
