// SPDX-License-Identifier: LGPL-2.1-or-later
// Loops over threads. Every index is handled once, by any thread, so a body that writes only what
// belongs to its index gives the same bytes for any number of threads.
#pragma once

#include "nmgs/support/progress.h"

#include <cstddef>
#include <functional>

namespace nmgs {

// Number of threads that parallel_for uses: the machine's, or what set_threads asked for.
int threads();

// count >= 1, or 0 for the machine's own number. Raises ArgumentError when negative.
void set_threads(int count);

// Calls body(first, last) over [0, size) in chunks of at most grain indices. The calling thread
// takes part and polls progress between its chunks, mapping the work to [from, to] of the whole.
// An exception of a body, or a cancel, ends the loop and is raised here once all threads stopped.
void parallel_for(std::size_t size, std::size_t grain,
                  const std::function<void(std::size_t first, std::size_t last)> &body,
                  const Progress &progress = {}, double from = 0.0, double to = 1.0);

} // namespace nmgs
