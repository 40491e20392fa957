// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <mutex>

namespace endmill {

/// Makes something once, however many threads ask for it. If it throws, the next call makes
/// it. std::call_once ends the program if memory runs out in it.
class Once {
public:
    /// Calls `make()` unless an earlier call has succeeded.
    template <typename Make>
    void operator()(const Make& make)
    {
        if (is_made_.load(std::memory_order_acquire))
            return;
        const std::lock_guard lock{mutex_};
        if (is_made_.load(std::memory_order_relaxed))
            return;
        make();
        is_made_.store(true, std::memory_order_release);
    }

private:
    std::atomic<bool> is_made_ = false;
    std::mutex mutex_;
};

}  // namespace endmill
