// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/move_conditions.h"

#include <cmath>
#include <string>

#include "endmill/core/error.h"
#include "endmill/core/numbers.h"
#include "endmill/post/plain_number.h"

namespace endmill {
namespace {

[[noreturn]] void refuse(std::size_t point, const std::string& found,
                         const std::string& expected)
{
    throw DomainError{"point " + std::to_string(point + 1) + " of the path has " + found +
                      "; expected " + expected};
}

}  // namespace

MoveConditions::MoveConditions(const ToolPath& path, const CuttingConditions& otherwise,
                               int decimals)
    : path_{path},
      otherwise_{otherwise},
      decimals_{decimals}
{
    require(path.conditions.empty() || path.conditions.size() == path.points.size(),
            "post: need conditions for no point or for all");
}

CuttingConditions MoveConditions::at(std::size_t point)
{
    CuttingConditions told =
        path_.conditions.empty() ? CuttingConditions{} : path_.conditions[point];
    if (!told.feed_mm_per_min)
        told.feed_mm_per_min = otherwise_.feed_mm_per_min;
    if (!told.spindle_rpm)
        told.spindle_rpm = otherwise_.spindle_rpm;
    if (!told.tool)
        told.tool = otherwise_.tool;

    if (path_.points[point].move == Move::Rapid)
        told.feed_mm_per_min.reset();
    else if (!told.feed_mm_per_min)
        refuse(point, "no feed", "a feed for every move but rapids (--feed)");
    else
        check_feed(point, *told.feed_mm_per_min);
    if (told.spindle_rpm && !(*told.spindle_rpm >= 0 && std::isfinite(*told.spindle_rpm)))
        refuse(point, "a spindle speed that is no number from 0", "one in rpm");
    if (told.spindle_rpm)
        speeds_.add(*told.spindle_rpm);
    if (told.tool && *told.tool < 0)
        refuse(point, "tool " + std::to_string(*told.tool), "a number from 0");
    return told;
}

void MoveConditions::check_feed(std::size_t point, double feed)
{
    if (feed == checked_feed_)
        return;
    if (!(feed > 0 && std::isfinite(feed)))
        refuse(point, "a feed that is no number above 0", "one in mm/min");
    std::string text;
    if (!(append_trimmed(text, feed, decimals_) > 0))
        refuse(point,
               "a feed of " + to_text(feed) + " mm/min, which rounds to 0 with " +
                   counted(static_cast<std::size_t>(decimals_), "decimal"),
               "a higher one, or more --decimals");
    feeds_.add(feed);
    checked_feed_ = feed;
}

}  // namespace endmill
