// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <utility>

namespace endmill {

/// The finished share of work that consists of many items, for a progress callback. Any
/// thread may report items.
class FinishedShare {
public:
    /// \param progress is called with the share, 0 to 1, by the threads that report. Empty:
    ///        nothing is reported.
    /// \param items    number of items of the whole work.
    /// \param step     the callback is called whenever this many more items are finished.
    FinishedShare(std::function<void(double share)> progress, std::size_t items,
                  std::size_t step = 1)
        : progress_{std::move(progress)},
          items_{items},
          step_{step}
    {
    }

    /// Notes that `more` items are finished.
    void add(std::size_t more)
    {
        if (!progress_)
            return;
        const std::size_t before = finished_.fetch_add(more);
        if (before / step_ != (before + more) / step_)
            progress_(static_cast<double>(before + more) / static_cast<double>(items_));
    }

private:
    std::function<void(double share)> progress_;
    std::size_t items_;
    std::size_t step_;
    std::atomic<std::size_t> finished_ = 0;
};

}  // namespace endmill
