// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/support/memory.h"

#include "nmgs/support/error.h"

#include <fstream>
#include <limits>
#include <string>

namespace nmgs {

std::int64_t available_memory() {
    std::ifstream file("/proc/meminfo");
    std::string key;
    std::int64_t kibibytes = 0;
    std::string unit;
    while (file >> key >> kibibytes) {
        if (key == "MemAvailable:") {
            return kibibytes * 1024;
        }
        std::getline(file, unit);
    }
    return std::numeric_limits<std::int64_t>::max();
}

void require_memory(std::int64_t bytes, const char *what) {
    const std::int64_t available = available_memory();
    if (bytes > available) {
        throw ArgumentError(std::string(what) + " needs " + std::to_string(bytes) +
                            " bytes of memory, and " + std::to_string(available) +
                            " are available");
    }
}

} // namespace nmgs
