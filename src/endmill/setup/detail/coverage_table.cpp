// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/coverage_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace endmill {
namespace {

constexpr std::size_t azimuth_bins = 96;  // 3.75 degrees: the table stays in the cache
constexpr std::size_t level_bins = 16;    // on each side
constexpr double bins_per_turn = azimuth_bins / (2 * std::numbers::pi);

}  // namespace

std::size_t CoverageTable::level_bin(int side, double level) const
{
    const double bin = level * bins_per_rad_[std::size_t(side)];
    return std::size_t(std::clamp(bin, 0.0, double(level_bins - 1)));
}

template <std::size_t W>
void CoverageTable::fill_bins(const AxisView& view)
{
    const MissingWords<W> words{cones_->words()};
    const std::size_t stride = words.count();
    const std::size_t row = azimuth_bins * stride;
    bins_.resize(2 * level_bins * row);
    for (std::size_t k = 0; k < 2 * level_bins * azimuth_bins; ++k)
        words.copy(bins_.data() + k * stride, cones_->everything());
    longest_ = 0;
    first_.assign(azimuth_bins + 1, view.swept.size());
    for (std::size_t k = view.swept.size(); k-- > 0;) {
        const SeenCell& cell = view.swept[k];
        const std::size_t level =
            cell.side * level_bins + level_bin(cell.side, cell.level);
        const auto azimuth =
            std::min(std::size_t(cell.begin * bins_per_turn), azimuth_bins - 1);
        words.meet(bins_.data() + level * row + azimuth * stride,
                   cones_->missing(cell.cell));
        first_[azimuth] = k;
        longest_ = std::max(longest_, cell.end - cell.begin);
    }
    for (std::size_t k = azimuth_bins; k-- > 0;)
        first_[k] = std::min(first_[k], first_[k + 1]);
    for (std::size_t side = 0; side < 2; ++side) {
        for (std::size_t level = 1; level < level_bins; ++level) {
            std::uint64_t* const here = bins_.data() + (side * level_bins + level) * row;
            const std::uint64_t* const below = here - row;
            for (std::size_t k = 0; k < row; ++k)
                here[k] &= below[k];
        }
    }
}

void CoverageTable::fill(const AxisView& view, const std::array<double, 2>& reach)
{
    for (std::size_t side = 0; side < 2; ++side)
        bins_per_rad_[side] = reach[side] > 0 ? level_bins / reach[side] : 0;
    free_ = view.free;
    with_words(cones_->words(), [&](auto w) { fill_bins<decltype(w)::value>(view); });
}

/// Finds the runs of `run` neighbouring bins that together meet all cones: all of them,
/// or only whether there is one.
///
/// A run is the end of one block of `run` bins and the beginning of the next block. The
/// ANDs of all ends (tail_) and of the growing beginning (sum_) give each run by one AND,
/// as in the algorithm of van Herk for running minima.
template <std::size_t W>
bool CoverageTable::find_runs(const LevelLimits& limits, std::size_t run,
                              RunSearch search)
{
    const MissingWords<W> words{cones_->words()};
    const std::size_t stride = words.count();
    const std::size_t row = azimuth_bins * stride;
    sum_.assign(cones_->everything(), cones_->everything() + stride);
    for (const SeenCell& cell : free_)
        if (cell.level <= limits.upto[cell.side])
            words.meet(sum_.data(), cones_->missing(cell.cell));
    both_.resize(row);
    const std::uint64_t* const side0 = bins_.data() + level_bin(0, limits.upto[0]) * row;
    const std::uint64_t* const side1 =
        bins_.data() + (level_bins + level_bin(1, limits.upto[1])) * row;
    for (std::size_t k = 0; k < azimuth_bins; ++k) {
        std::uint64_t* const here = both_.data() + k * stride;
        words.copy(here, side0 + k * stride);
        words.meet(here, side1 + k * stride);
        words.meet(here, sum_.data());
    }
    auto bin = [&](std::size_t k) { return both_.data() + k % azimuth_bins * stride; };
    is_start_.assign(azimuth_bins, 0);
    bool is_found = false;
    tail_.resize((run + 1) * stride);
    for (std::size_t block = 0; block < azimuth_bins; block += run) {
        words.copy(tail_.data() + run * stride, cones_->everything());
        for (std::size_t k = run; k-- > 0;) {
            std::uint64_t* const here = tail_.data() + k * stride;
            words.copy(here, here + stride);
            words.meet(here, bin(block + k));
        }
        words.copy(sum_.data(), cones_->everything());
        for (std::size_t k = 0; k < run; ++k) {
            if (words.complete(tail_.data() + k * stride, sum_.data())) {
                if (search == RunSearch::AnyRun)
                    return true;
                is_found = true;
                is_start_[(block + k) % azimuth_bins] = 1;
            }
            words.meet(sum_.data(), bin(block + run + k));
        }
    }
    return is_found;
}

/// Largest number of bins in which the cells that a window meets begin. An interval that
/// meets the window begins within it, or before it by at most its own length.
std::size_t CoverageTable::bins_of(double width) const
{
    const double bins = (width + longest_) * bins_per_turn + 2;
    return bins < double(azimuth_bins) ? std::size_t(bins) : azimuth_bins;
}

bool CoverageTable::may_fit(const LevelLimits& limits, double width)
{
    return with_words(cones_->words(), [&](auto w) {
        return find_runs<decltype(w)::value>(limits, bins_of(width), RunSearch::AnyRun);
    });
}

std::span<const SweptRange> CoverageTable::places(const LevelLimits& limits, double width)
{
    const std::size_t run = bins_of(width);
    with_words(cones_->words(), [&](auto w) {
        find_runs<decltype(w)::value>(limits, run, RunSearch::EveryRun);
    });
    places_.clear();
    std::size_t open = 0;  // number of bins that the last run still covers
    for (std::size_t k = 0; k < azimuth_bins; ++k)
        if (is_start_[k] != 0 && k + run > azimuth_bins)
            open = k + run - azimuth_bins;
    for (std::size_t k = 0; k < azimuth_bins; ++k) {
        open = is_start_[k] != 0 ? run : open;
        if (open == 0)
            continue;
        --open;
        if (!places_.empty() && places_.back().end == first_[k])
            places_.back().end = first_[k + 1];
        else
            places_.push_back({first_[k], first_[k + 1]});
    }
    return places_;
}

}  // namespace endmill
