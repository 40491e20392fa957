// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/move_conditions.h"

#include <cmath>
#include <string>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/post/detail/plain_number.h"

namespace endmill {
namespace {

[[noreturn]] void refuse(std::size_t point, const std::string& found,
                         const std::string& expected)
{
    throw DomainError{"point " + std::to_string(point) + " of the path has " + found +
                      "; expected " + expected};
}

}  // namespace

MoveConditions::MoveConditions(const ToolPath& path, const CuttingConditions& otherwise,
                               const ConditionFormat& format)
    : path_{path},
      otherwise_{otherwise},
      format_{format}
{
}

// Neighbouring moves usually have the same numbers, so a number is checked only where it
// changes.
CuttingConditions MoveConditions::at(std::size_t point)
{
    CuttingConditions conditions = path_.points[point].conditions;
    if (!conditions.feed_mm_per_min)
        conditions.feed_mm_per_min = otherwise_.feed_mm_per_min;
    if (!conditions.spindle_rpm)
        conditions.spindle_rpm = otherwise_.spindle_rpm;
    if (!conditions.tool)
        conditions.tool = otherwise_.tool;

    if (path_.points[point].move == Move::Rapid)
        conditions.feed_mm_per_min.reset();
    else if (!conditions.feed_mm_per_min)
        refuse(point, "no feed", "a feed for every move but rapids (--feed)");
    else
        add_feed(point, *conditions.feed_mm_per_min);
    if (conditions.spindle_rpm && *conditions.spindle_rpm != checked_speed_) {
        checked_speed_ = *conditions.spindle_rpm;
        check(point, {"spindle speed", checked_speed_, "rpm", checked_speed_,
                      format_.speed_decimals});
        speeds_.add(checked_speed_);
    }
    if (conditions.tool && *conditions.tool < 0)
        refuse(point, "tool " + std::to_string(*conditions.tool), "a number from 0");
    return conditions;
}

void MoveConditions::add_feed(std::size_t point, double feed)
{
    const bool descends = is_descent(path_, point);
    double& checked = descends ? checked_plunge_feed_ : checked_feed_;
    if (feed == checked)
        return;
    checked = feed;
    check(point, {"feed", feed, "mm/min", feed / format_.unit_mm, format_.feed_decimals});
    (descends ? plunge_feeds_ : feeds_).add(feed);
}

void MoveConditions::check(std::size_t point, const Condition& condition) const
{
    const std::string name = std::string{"a "} + condition.name;
    if (!(condition.value > 0 && std::isfinite(condition.value)))
        refuse(point, name + " that is not a number above 0",
               std::string{"one in "} + condition.unit);
    std::string text;
    if (!(append_trimmed(text, condition.written, condition.decimals) > 0))
        refuse(point,
               name + " of " + to_text(condition.value) + ' ' + condition.unit +
                   ", which rounds to 0 with " +
                   counted(static_cast<std::size_t>(condition.decimals), "decimal"),
               "a higher one, or more --decimals");
}

}  // namespace endmill
