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
    double begin = 0;
    double width = 0;  ///< in [0, 2 pi]
};

/// The cells of a view that count: levels up to `upto[side]`, rad.
struct LevelLimits {
    std::array<double, 2> upto;
};

/// Neighbours in AxisView::swept.
struct SweptRange {
    std::size_t first = 0;
    std::size_t end = 0;  ///< one beyond the last
};

/// Finds least windows by one circular sweep over the cells of a view. Keeps its memory between
/// calls; one a thread. Derived in paper/notes/whole-cones.md.
class WindowSweep {
public:
    explicit WindowSweep(const ConeSet& cones) : cones_{&cones} {}

    /// A window of least width that touches a part of some counting cell of each cone, of those
    /// in `places`, ascending and apart, or of any azimuth. Nothing if that takes `cap` (rad)
    /// or more. Where parts differ in length the width may be too small by the difference,
    /// never too large (rounding apart: 1e-15).
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
    std::vector<const std::uint64_t*> missing_;  ///< of the swept cells that count
    std::vector<double> begin_;                  ///< of their parts
    std::vector<double> end_;  ///< never falls: the farthest end so far, two rounds
    std::vector<std::uint64_t> always_;  ///< what the cells of any azimuth miss
    std::vector<std::uint64_t> front_;   ///< what cells from here to the split miss
    std::vector<std::uint64_t> back_;    ///< what those beyond it miss
};

}  // namespace endmill
