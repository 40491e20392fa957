// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/program.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "endmill/core/detail/units.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {

std::size_t points_within(double memory_gib)
{
    // A growing vector needs the memory of its points three times: once for the old
    // array, and twice for the new array of double size.
    constexpr double bytes_per_point = 3 * sizeof(PathPoint);
    constexpr double most = std::numeric_limits<int>::max();  // point numbers are int
    return static_cast<std::size_t>(
        std::min(std::floor(memory_gib * bytes_per_gib / bytes_per_point), most));
}

void require_sound(const GcodeReadOptions& options)
{
    const auto is_positive = [](double value) {
        return std::isfinite(value) && value > 0;
    };
    require(is_positive(options.arc_tolerance_mm),
            "GcodeReadOptions: need 0 < arc tolerance");
    require(is_positive(options.max_extent_mm),
            "GcodeReadOptions: need 0 < largest extent");
    require(std::isfinite(options.programmed_point_height_mm) &&
                options.programmed_point_height_mm >= 0,
            "GcodeReadOptions: need 0 <= height of the programmed point");
    require(!options.rotary || options.rotary->frame != Interpolation::Linear,
            "GcodeReadOptions: need the frame Joint or Tcp");
    require(options.most_points <= std::numeric_limits<int>::max(),
            "GcodeReadOptions: need at most 2^31 - 1 points");
}

double millimetres_per(ProgramUnit unit)
{
    return unit == ProgramUnit::Inch ? mm_per_inch : 1;
}

bool is_descent(const ToolPath& path, std::size_t point)
{
    const Move move = path.points[point].move;
    return move == Move::Plunge || (point == 0 && move != Move::Rapid);
}

void set_feeds(ToolPath& path, const FeedSettings& feeds)
{
    require(feeds.cutting_mm_per_min.value_or(1) > 0 &&
                feeds.plunge_mm_per_min.value_or(1) > 0,
            "set_feeds: need feeds above 0");
    require(0 < feeds.plunge_share && feeds.plunge_share <= 1,
            "set_feeds: need a share above 0, at most 1");
    MinMax cutting;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        std::optional<double>& feed = path.points[i].conditions.feed_mm_per_min;
        if (path.points[i].move == Move::Rapid)
            continue;
        const bool descends = is_descent(path, i);
        if (feeds.cutting_mm_per_min && (feeds.choice == FeedChoice::OfSettings || !feed))
            feed = descends ? feeds.plunge(*feeds.cutting_mm_per_min)
                            : *feeds.cutting_mm_per_min;
        if (descends && feeds.plunge_mm_per_min)
            feed = feeds.plunge_mm_per_min;
        if (!descends && feed)
            cutting.add(*feed);
    }
    if (feeds.plunge_mm_per_min && cutting.greatest &&
        *feeds.plunge_mm_per_min > *cutting.greatest)
        throw DomainError{"the plunge feed " + to_text(*feeds.plunge_mm_per_min) +
                          " mm/min is above the cutting feed; expected at most " +
                          to_text(*cutting.greatest) + " mm/min"};
}

}  // namespace endmill
