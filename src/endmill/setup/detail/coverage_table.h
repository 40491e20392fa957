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

/// A filter before WindowSweep: the cells of a view in bins of azimuth and level, with
/// the AND of the columns of each bin. It excludes windows in less than a microsecond.
/// Keeps its memory between views; one for each thread.
/// Source: paper/notes/whole-cones.md, section 6.
class CoverageTable {
public:
    /// \param cones must outlive the table.
    explicit CoverageTable(const ConeSet& cones) : cones_{&cones} {}

    /// Fills the table.
    /// \param view cells. \param reach largest level to either side that later calls use,
    ///         rad.
    void fill(const AxisView& view, const std::array<double, 2>& reach);

    /// Tests whether a window narrower than `width`, rad, may meet all cones.
    /// \return false only if WindowSweep::least would find no such window.
    /// \pre limits.upto does not exceed the `reach` of fill.
    bool may_fit(const LevelLimits& limits, double width);

    /// Selects the parts of the view in which windows narrower than `width`, rad, may
    /// lie. WindowSweep::least gives the same result for these parts as for the whole
    /// view.
    /// \return ascending ranges, valid until the next call; empty if there is no such
    ///         window.
    std::span<const SweptRange> places(const LevelLimits& limits, double width);

private:
    template <std::size_t W>
    void fill_bins(const AxisView& view);
    // How many runs to find.
    enum class RunSearch { AnyRun, EveryRun };
    // Looks for runs of `run` azimuth bins in which every cone is met. Marks the first
    // bins of all runs in `is_start_` if the search is EveryRun; stops at a run if it is
    // AnyRun. Returns whether it found one.
    template <std::size_t W>
    bool find_runs(const LevelLimits& limits, std::size_t run, RunSearch search);
    std::size_t level_bin(int side, double level) const;
    std::size_t bins_of(double width) const;

    const ConeSet* cones_;
    std::array<double, 2> bins_per_rad_{};
    double longest_ = 0;  ///< longest interval of a cell, rad
    std::vector<SeenCell> free_;
    /// By azimuth bin: first cell in the view; and the end.
    std::vector<std::size_t> first_;
    std::vector<std::uint64_t> bins_;  ///< by side, level, azimuth: AND up to this level
    std::vector<std::uint64_t> both_;  ///< by azimuth bin: AND of both sides
    /// AND of the bins from here to the end of a block.
    std::vector<std::uint64_t> tail_;
    std::vector<std::uint64_t> sum_;  ///< AND of the bins since the block began
    std::vector<char> is_start_;      ///< by azimuth bin: 1 if a run begins here
    std::vector<SweptRange> places_;
};

}  // namespace endmill
