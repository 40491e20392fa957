// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/fed_path.h"

#include <cmath>

#include "endmill/core/error.h"

namespace endmill {
namespace {

bool is_positive(double value)
{
    return std::isfinite(value) && value > 0;
}

}  // namespace

double saving_percent(double varied_min, double constant_min)
{
    constexpr double percent = 100;
    require(is_positive(varied_min) && is_positive(constant_min),
            "saving_percent: need 0 < times");
    return percent * (1 - varied_min / constant_min);
}

FeedTimes feed_times(const TimeParts& parts)
{
    require(is_positive(parts.cut_length_mm) && is_positive(parts.cut_min),
            "feed_times: need 0 < length and time of cuts");
    require(
        !parts.noncut_min || (std::isfinite(*parts.noncut_min) && *parts.noncut_min >= 0),
        "feed_times: need 0 <= time besides cuts");
    require(
        !parts.constant_feed_mm_per_min || is_positive(*parts.constant_feed_mm_per_min),
        "feed_times: need 0 < constant feed");
    FeedTimes times{.cut_min = parts.cut_min, .noncut_min = parts.noncut_min};
    if (!parts.noncut_min)
        return times;
    times.total_min = parts.cut_min + *parts.noncut_min;
    if (!parts.constant_feed_mm_per_min)
        return times;
    times.constant_feed_min =
        parts.cut_length_mm / *parts.constant_feed_mm_per_min + *parts.noncut_min;
    times.saving_percent = saving_percent(*times.total_min, *times.constant_feed_min);
    return times;
}

RunParts parts_of_runs(const ConstantFeedRun& one, const ConstantFeedRun& other)
{
    for (const ConstantFeedRun& run : {one, other})
        require(is_positive(run.feed_mm_per_min) && is_positive(run.total_min),
                "parts_of_runs: need 0 < feed and time");
    require(one.feed_mm_per_min != other.feed_mm_per_min,
            "parts_of_runs: need two different feeds");
    const double length = (one.total_min - other.total_min) /
                          (1 / one.feed_mm_per_min - 1 / other.feed_mm_per_min);
    return {length, one.total_min - length / one.feed_mm_per_min};
}

}  // namespace endmill
