// SPDX-License-Identifier: LGPL-2.1-or-later
// Progress and cancel of long work. The work calls poll() at least every 50 ms.
#pragma once

#include "nmgs/support/error.h"

#include <functional>

namespace nmgs {

// Called with the finished fraction in [0, 1]; false asks the work to stop. Always called from the
// thread that started the work. Empty: nobody listens.
using Progress = std::function<bool(double fraction)>;

// Raises Cancelled when the listener asks to stop.
inline void poll(const Progress &progress, double fraction) {
    if (progress && !progress(fraction)) {
        throw Cancelled();
    }
}

} // namespace nmgs
