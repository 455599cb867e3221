// SPDX-License-Identifier: AGPL-3.0-or-later
#include "nmgs_tet/limits.h"

#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace nmgs::tet {
namespace {

std::atomic<bool> guarded{false};

} // namespace

void limit_memory(std::int64_t bytes) {
    if (bytes <= 0) {
        return;
    }
    // The program's own image and its threads' stacks are not the request's.
    std::int64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const auto limit = static_cast<rlim_t>(bytes + pages * ::sysconf(_SC_PAGESIZE));
    rlimit current{};
    ::getrlimit(RLIMIT_AS, &current);
    if (current.rlim_max == RLIM_INFINITY || limit < current.rlim_max) {
        current.rlim_cur = limit;
        ::setrlimit(RLIMIT_AS, &current);
    }
}

void forbid_core_files() {
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none);
}

void start_life_line(int descriptor) {
    std::thread([descriptor] {
        guarded.wait(false);
        std::array<char, 64> ignored{};
        for (;;) {
            const ssize_t count = ::read(descriptor, ignored.data(), ignored.size());
            if (count == 0 || (count < 0 && errno != EINTR)) {
                std::_Exit(EXIT_FAILURE);
            }
        }
    }).detach();
}

void guard_life_line() {
    guarded = true;
    guarded.notify_one();
}

} // namespace nmgs::tet
