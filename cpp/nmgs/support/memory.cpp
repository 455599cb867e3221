// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/support/memory.h"

#include "nmgs/support/error.h"

#include <cstdlib>
#include <fstream>
#include <limits>
#include <new>
#include <string>

#ifdef __linux__
#include <sys/mman.h>
#endif

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

void *allocate(std::size_t count, std::size_t bytes_each) {
    if (count > std::numeric_limits<std::size_t>::max() / 2 / bytes_each) {
        throw std::bad_alloc();
    }
    const std::size_t bytes = count * bytes_each;
    void *memory = nullptr;
#ifdef __linux__
    constexpr std::size_t large_page = std::size_t{1} << 21;
    if (bytes >= 2 * large_page) {
        const std::size_t whole = (bytes + large_page - 1) / large_page * large_page;
        memory = std::aligned_alloc(large_page, whole); // NOLINT(cppcoreguidelines-owning-memory)
        if (memory != nullptr) {
            madvise(memory, whole, MADV_HUGEPAGE); // a hint; nothing is lost where it is refused
        }
    } else
#endif
    {
        // NOLINTNEXTLINE(cppcoreguidelines-no-malloc,cppcoreguidelines-owning-memory)
        memory = std::malloc(bytes);
    }
    if (memory == nullptr) {
        throw std::bad_alloc();
    }
    return memory;
}

void release(void *memory) {
    std::free(memory); // NOLINT(cppcoreguidelines-no-malloc,cppcoreguidelines-owning-memory)
}

} // namespace nmgs
