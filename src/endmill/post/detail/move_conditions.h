// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>

#include "endmill/path/tool_path.h"
#include "endmill/post/program.h"

namespace endmill {

/// Feed, spindle speed and tool of each move of a path: those of the path, or else given
/// defaults, after a check.
class MoveConditions {
public:
    /// \param path the path; must outlive this object.
    /// \param otherwise values of the conditions that a move does not have.
    /// \param decimals digits after the point with which a feed is written.
    MoveConditions(const ToolPath& path, const CuttingConditions& otherwise,
                   int decimals);

    /// Conditions of the move to the point with this index. A rapid has no feed.
    /// \throws DomainError if a move at feed has no feed; for a feed or spindle speed
    ///         that is not finite or not above 0 after rounding; for a negative tool
    ///         number.
    CuttingConditions at(std::size_t point);

    const MinMax& feeds() const { return feeds_; }  ///< mm/min, range of the feeds so far
    const MinMax& speeds() const { return speeds_; }  ///< rpm, range of the speeds so far

private:
    struct Condition {
        const char* name;
        double value;
        const char* unit;
    };

    void check(std::size_t point, const Condition& condition) const;

    const ToolPath& path_;
    CuttingConditions otherwise_;
    int decimals_;
    double checked_feed_ = std::numeric_limits<double>::quiet_NaN();
    double checked_speed_ = std::numeric_limits<double>::quiet_NaN();
    MinMax feeds_;
    MinMax speeds_;
};

}  // namespace endmill
