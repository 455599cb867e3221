// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nmgs/support/parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace nmgs {
namespace {

std::atomic<int> requested_threads{0};

} // namespace

int threads() {
    const int requested = requested_threads.load();
    return requested > 0 ? requested
                         : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void set_threads(int count) {
    if (count < 0) {
        throw ArgumentError("threads: expected 0 or more, got " + std::to_string(count));
    }
    requested_threads = count;
}

void parallel_for(std::size_t size, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)> &body,
                  const Progress &progress, double from, double to) {
    grain = std::max<std::size_t>(grain, 1);
    const std::size_t chunks = (size + grain - 1) / grain;
    std::atomic<std::size_t> next{0};
    std::atomic<std::size_t> done{0};
    std::atomic<bool> stop{false};
    std::exception_ptr failure;
    std::mutex failure_mutex;

    const auto work = [&](bool polls) {
        try {
            for (std::size_t chunk = next++; chunk < chunks && !stop; chunk = next++) {
                body(chunk * grain, std::min(size, (chunk + 1) * grain));
                ++done;
                if (polls) {
                    const double share = static_cast<double>(done) / static_cast<double>(chunks);
                    poll(progress, from + (to - from) * share);
                }
            }
            // The caller keeps polling while the other threads finish their last chunks.
            while (polls && progress && done < chunks && !stop) {
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
                const double share = static_cast<double>(done) / static_cast<double>(chunks);
                poll(progress, from + (to - from) * share);
            }
        } catch (...) {
            const std::lock_guard lock(failure_mutex);
            if (!failure) {
                failure = std::current_exception();
            }
            stop = true;
        }
    };

    const std::size_t helpers = std::min<std::size_t>(static_cast<std::size_t>(threads()), chunks);
    {
        std::vector<std::jthread> pool;
        for (std::size_t i = 1; i < helpers; ++i) {
            pool.emplace_back([&work] { work(false); });
        }
        work(true);
    }
    if (failure) {
        std::rethrow_exception(failure);
    }
}

} // namespace nmgs
