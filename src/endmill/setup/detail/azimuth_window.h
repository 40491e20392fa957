// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "endmill/setup/detail/axis_view.h"
#include "endmill/setup/detail/cone_set.h"

namespace endmill {

/// Azimuths from `begin` to `begin + width`, rad.
struct AzimuthWindow {
    double begin = 0;  ///< about the axis
    double width = 0;  ///< in [0, 2 pi]
};

/// Upper limits of the levels on both sides. Cells of a view beyond them do not count.
struct LevelLimits {
    std::array<double, 2> upto;  ///< rad
};

/// A range of indices of AxisView::swept.
struct SweptRange {
    std::size_t first = 0;  ///< index of the first cell
    std::size_t end = 0;    ///< one beyond the last
};

/// Finds least windows by one circular sweep over the cells of a view. Keeps its memory
/// between calls; one for each thread. Source: paper/notes/whole-cones.md, section 5.
class WindowSweep {
public:
    /// \param cones must outlive the sweep.
    explicit WindowSweep(const ConeSet& cones) : cones_{&cones} {}

    /// Finds a window of least width that meets an interval of some cell of each cone.
    ///
    /// If intervals differ in length, the width may be too small by the difference. It is
    /// never too large, up to a rounding of 1e-15, so that it is a lower bound.
    /// \param view cells. \param places ranges of its swept cells that count, ascending
    ///         and disjoint; free cells always count. \param limits of the levels.
    /// \param cap rad: windows of this width or more are of no interest.
    /// \return nothing if there is no window narrower than `cap`.
    std::optional<AzimuthWindow> least(const AxisView& view,
                                       std::span<const SweptRange> places,
                                       const LevelLimits& limits, double cap);

private:
    template <std::size_t W>
    bool gather(const AxisView& view, std::span<const SweptRange> places,
                const LevelLimits& limits);
    void raise_ends();
    template <std::size_t W>
    void fill_front(std::size_t head, std::size_t last);
    template <std::size_t W>
    std::optional<AzimuthWindow> sweep(double cap);

    const ConeSet* cones_;
    /// Columns of the swept cells that count.
    std::vector<const std::uint64_t*> missing_;
    std::vector<double> begin_;  ///< begins of their intervals
    std::vector<double> end_;    ///< running maximum of their ends, over two rounds
    std::vector<std::uint64_t> always_;  ///< AND of the columns of the free cells
    std::vector<std::uint64_t> front_;   ///< by cell: AND of the columns up to the split
    std::vector<std::uint64_t> back_;    ///< AND of the columns after the split
};

}  // namespace endmill
