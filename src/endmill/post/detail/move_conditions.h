// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <optional>

#include "endmill/path/tool_path.h"
#include "endmill/post/program.h"

namespace endmill {

/// How feeds and speeds are written.
struct ConditionFormat {
    int feed_decimals = 4;   ///< digits after the point of a feed
    int speed_decimals = 4;  ///< digits after the point of a spindle speed
    double unit_mm = 1;      ///< mm, length of one unit of the program
};

/// Feed, spindle speed and tool of each move of a path: those of the path, or else given
/// defaults, after a check.
class MoveConditions {
public:
    /// \param path the path; must outlive this object.
    /// \param otherwise values of the conditions that a move does not have.
    /// \param format how the numbers are written.
    MoveConditions(const ToolPath& path, const CuttingConditions& otherwise,
                   const ConditionFormat& format);

    /// Conditions of the move to the point with this index. A rapid has no feed.
    /// \throws DomainError if a move at feed has no feed; for a feed or spindle speed
    ///         that is not finite or not above 0 after rounding; for a negative tool
    ///         number.
    CuttingConditions at(std::size_t point);

    /// mm/min, range of the feeds so far, without those of descents.
    const MinMax& feeds() const { return feeds_; }
    /// mm/min, range of the feeds of descents so far.
    const MinMax& plunge_feeds() const { return plunge_feeds_; }
    const MinMax& speeds() const { return speeds_; }  ///< rpm, range of the speeds so far

private:
    struct Condition {
        const char* name;
        double value;
        const char* unit;
        double written;  // in units of the program
        int decimals;
    };

    void add_feed(std::size_t point, double feed);
    void check(std::size_t point, const Condition& condition) const;

    const ToolPath& path_;
    CuttingConditions otherwise_;
    ConditionFormat format_;
    double checked_feed_ = std::numeric_limits<double>::quiet_NaN();
    double checked_speed_ = std::numeric_limits<double>::quiet_NaN();
    double checked_plunge_feed_ = std::numeric_limits<double>::quiet_NaN();
    MinMax feeds_;
    MinMax plunge_feeds_;
    MinMax speeds_;
};

}  // namespace endmill
