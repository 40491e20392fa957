// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>

#include "endmill/path/tool_path.h"
#include "endmill/post/program.h"

namespace endmill {

/// Feed, speed and tool of each move of a path, from the path or else from what is told
/// for all of it, checked.
class MoveConditions {
public:
    /// \param path outlives this. \param otherwise where the path says nothing.
    /// \param decimals to which a feed is rounded when it is written.
    /// \throws DomainError unless the path has no conditions or one a point.
    MoveConditions(const ToolPath& path, const CuttingConditions& otherwise,
                   int decimals);

    /// Those of the move to a point, from 0. A rapid has no feed.
    /// \throws DomainError if a move at feed has none; for a feed or a spindle speed that
    ///         is not finite, or not above 0 once rounded; for a tool number below 0.
    CuttingConditions at(std::size_t point);

    const NumberRange& feeds() const { return feeds_; }    ///< so far, in mm/min
    const NumberRange& speeds() const { return speeds_; }  ///< so far, in rpm

private:
    struct Condition {
        const char* name;
        double value;
        const char* unit;
    };

    void check(std::size_t point, const Condition& told) const;

    const ToolPath& path_;
    CuttingConditions otherwise_;
    int decimals_;
    double checked_feed_ = std::numeric_limits<double>::quiet_NaN();
    double checked_speed_ = std::numeric_limits<double>::quiet_NaN();
    NumberRange feeds_;
    NumberRange speeds_;
};

}  // namespace endmill
