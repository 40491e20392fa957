// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/setup/detail/axis_view.h"
#include "endmill/setup/detail/azimuth_window.h"
#include "endmill/setup/detail/cone_set.h"

namespace endmill {

/// The cells of a view in bins of azimuth and level, with what all cells of a bin miss
/// together: tells in under a microsecond that no window will do. Keeps its memory between
/// views; one a thread.
class CoverageTable {
public:
    explicit CoverageTable(const ConeSet& cones) : cones_{&cones} {}

    /// Fills the table from `view`, whose levels matter up to `reach` (rad, to either side) only.
    void fill(const AxisView& view, const std::array<double, 2>& reach);

    /// False only if WindowSweep::least would find no window narrower than `width` rad.
    /// \pre limits.upto is not above the `reach` of fill.
    bool may_fit(const LevelLimits& limits, double width);

    /// Where in the view such windows may be: WindowSweep::least finds the same ones here as in
    /// the whole view. Empty if it would find none, and all of it where cells of any azimuth
    /// do; until the next call.
    std::span<const SweptRange> places(const LevelLimits& limits, double width);

private:
    template <std::size_t W>
    void fill_bins(const AxisView& view);
    template <std::size_t W>
    bool find_runs(const LevelLimits& limits, std::size_t run, bool all);
    std::size_t level_bin(int side, double level) const;
    std::size_t bins_of(double width) const;

    const ConeSet* cones_;
    std::array<double, 2> bins_per_rad_{};
    double longest_ = 0;  ///< part of a cell, rad
    std::vector<SeenCell> free_;
    std::vector<std::size_t>
        first_;  ///< by azimuth: its first cell in the view; and the end
    std::vector<std::uint64_t>
        bins_;  ///< by side, level, azimuth; a bin holds lower levels too
    std::vector<std::uint64_t> both_;  ///< by azimuth: what both sides miss
    std::vector<std::uint64_t> tail_;  ///< what is missed from here to the end of a block
    std::vector<std::uint64_t> sum_;   ///< what is missed since the block began
    std::vector<char> is_start_;       ///< by azimuth: whether a run begins here
    std::vector<SweptRange> places_;
};

}  // namespace endmill
