// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/setup/detail/axis_fit.h"
#include "endmill/setup/detail/cone_set.h"
#include "endmill/setup/detail/minimal_cones.h"

namespace endmill {

/// Fits ranges that meet all minimal cones, with a small set of these cones that grows.
///
/// A range that meets the set is checked against all cones. If it misses some, a few of
/// them join the set and the range is fitted again. About most axes a few dozen cones
/// decide, out of tens of thousands. A bound for the set holds for all cones, because
/// further cones only exclude poses. One fitter for each thread.
class AdaptiveFitter {
public:
    /// \param cones must outlive the fitter. \param problem its cones are replaced by the
    ///         growing set.
    AdaptiveFitter(const MinimalCones& cones, const ConeFitting& problem);

    AdaptiveFitter(const AdaptiveFitter&) = delete;
    AdaptiveFitter& operator=(const AdaptiveFitter&) = delete;

    /// Replaces the set. \param cones numbers of minimal cones, each once.
    void begin_with(std::span<const std::size_t> cones);

    /// Numbers of the cones of the set: first those that it began with.
    std::span<const std::size_t> set() const { return set_; }

    /// The problem with the cones of the set, which change with calls.
    const ConeFitting& fitting() const { return fitting_; }

    /// The result of AxisFitter::best for all minimal cones, except that a cell within
    /// 1e-12 rad of the range counts as reached.
    std::optional<AxisFit> best(const Vec3& axis, const FitRequest& request);

    /// Adds a few of the cones that hold none of these cells to the set. \param reached
    /// indices of centres. \return true if there are such cones outside the set.
    bool grow(std::span<const std::uint32_t> reached);

private:
    const MinimalCones& cones_;
    std::vector<std::size_t> set_;
    std::vector<char> is_in_set_;  // by minimal cone
    ConeSet columns_;              // of the set
    ConeFitting fitting_;
    AxisFitter fitter_;
};

}  // namespace endmill
