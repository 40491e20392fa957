// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/azimuth_window.h"

#include <algorithm>
#include <numbers>

// How the sweep finds the least window.
//
// The cells that count are sorted by the begins of their intervals, over two rounds. A
// window can be moved back until it ends at the begin of an interval; it then has to
// begin before the end of one interval of each cone.
// 1. `last` runs over all begins. The cells head ... last are a queue.
// 2. While the cells of the queue meet all cones, the window from the end of the first
//    cell to the begin of the last one is a candidate, and the first cell leaves the
//    queue.
// 3. The AND of the columns of a queue is kept by two stacks: the front stack stores the
//    AND from each cell to the split, the back is a single AND. When the front is empty,
//    the back is turned into it. So each cell costs a constant number of ANDs. The ends
//    are replaced by their running maximum, so that a long interval hides short ones.
//    This can make a window too narrow, never too wide.

namespace endmill {
namespace {

constexpr double turn = 2 * std::numbers::pi;

}  // namespace

/// Lists the cells that count. \return false if they miss a cone together.
template <std::size_t W>
bool WindowSweep::gather(const AxisView& view, std::span<const SweptRange> places,
                         const LevelLimits& limits)
{
    const MissingWords<W> words{cones_->words()};
    always_.assign(cones_->everything(), cones_->everything() + words.count());
    for (const SeenCell& cell : view.free)
        if (cell.level <= limits.upto[cell.side])
            words.meet(always_.data(), cones_->missing(cell.cell));
    back_ = always_;
    missing_.clear();
    begin_.clear();
    end_.clear();
    for (const SweptRange& place : places) {
        for (std::size_t k = place.first; k < place.end; ++k) {
            const SeenCell& cell = view.swept[k];
            if (cell.level > limits.upto[cell.side])
                continue;
            const std::uint64_t* const missing = cones_->missing(cell.cell);
            missing_.push_back(missing);
            begin_.push_back(cell.begin);
            end_.push_back(cell.end);
            words.meet(back_.data(), missing);
        }
    }
    return words.complete(back_.data(), back_.data());
}

/// Extends the ends of the intervals to two rounds and replaces them by their running
/// maximum.
void WindowSweep::raise_ends()
{
    const std::size_t count = begin_.size();
    end_.resize(2 * count);
    for (std::size_t k = 0; k < count; ++k)
        end_[count + k] = end_[k] + turn;
    for (std::size_t k = 1; k < 2 * count; ++k)
        end_[k] = std::max(end_[k], end_[k - 1]);
}

/// Fills the front stack: for each of `head` ... `last` the AND of the columns from it to
/// `last`.
template <std::size_t W>
void WindowSweep::fill_front(std::size_t head, std::size_t last)
{
    const MissingWords<W> words{cones_->words()};
    const std::size_t stride = words.count();
    const std::size_t count = begin_.size();
    for (std::size_t k = last + 1; k-- > head;) {
        std::uint64_t* const here = front_.data() + k * stride;
        words.copy(here, k == last ? always_.data() : here + stride);
        words.meet(here, missing_[k < count ? k : k - count]);
    }
    words.copy(back_.data(), always_.data());
}

/// Sweeps twice around. The front stack holds the cells head ... split - 1, the back
/// those from split to last.
template <std::size_t W>
std::optional<AzimuthWindow> WindowSweep::sweep(double cap)
{
    const MissingWords<W> words{cones_->words()};
    const std::size_t count = begin_.size();
    const std::size_t stride = words.count();
    front_.resize(2 * count * stride);
    words.copy(back_.data(), always_.data());
    std::optional<AzimuthWindow> best;
    std::size_t head = 0;
    std::size_t split = 0;
    for (std::size_t last = 0; last < 2 * count; ++last) {
        const std::size_t cell = last < count ? last : last - count;
        words.meet(back_.data(), missing_[cell]);
        const double at = begin_[cell] + (last < count ? 0 : turn);
        for (; head <= last; ++head) {
            const std::uint64_t* const front =
                head == split ? back_.data() : front_.data() + head * stride;
            if (!words.complete(front, back_.data()))
                break;
            if (head == split) {
                fill_front<W>(head, last);
                split = last + 1;
            }
            const double width = std::max(at - end_[head], 0.0);
            if (width >= cap)
                continue;
            best = AzimuthWindow{std::min(end_[head], at), width};
            cap = width;
        }
    }
    return best;
}

std::optional<AzimuthWindow> WindowSweep::least(const AxisView& view,
                                                std::span<const SweptRange> places,
                                                const LevelLimits& limits, double cap)
{
    return with_words(cones_->words(), [&](auto w) -> std::optional<AzimuthWindow> {
        constexpr std::size_t W = decltype(w)::value;
        if (!gather<W>(view, places, limits) || cap <= 0)
            return std::nullopt;
        const MissingWords<W> words{cones_->words()};
        if (words.complete(always_.data(), always_.data()))
            return AzimuthWindow{};
        raise_ends();
        return sweep<W>(cap);
    });
}

}  // namespace endmill
