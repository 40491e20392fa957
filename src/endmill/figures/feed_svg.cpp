// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/feed_svg.h"

#include <array>
#include <functional>
#include <optional>

#include "endmill/core/angle.h"
#include "endmill/core/detail/large_pages.h"
#include "endmill/core/error.h"
#include "endmill/figures/detail/stacked_chart.h"

// The abscissa is the length of cut at the end of each move. Moves in the air have no
// geometry; their values are unknown and leave gaps in the curves.

namespace endmill {
namespace {

constexpr LineStyle first_style{"#1d4f91", 1.2, ""};
constexpr LineStyle second_style{"#d1402f", 1.2, ""};

// A function of angles in degrees, from one in radians.
MoveValue in_degrees(const MoveValue& radians)
{
    return [&radians](std::size_t move) {
        std::optional<double> angle = radians(move);
        if (angle)
            angle = Angle::radians(*angle).degrees();
        return angle;
    };
}

// What limits the feed, in the order of FeedLimit.
constexpr std::array feed_causes{StripCause{"force across the tool axis", "#0072b2"},
                                 StripCause{"force along the tool axis", "#56b4e9"},
                                 StripCause{"torque", "#cc79a7"},
                                 StripCause{"feed per tooth of the material", "#009e73"},
                                 StripCause{"time of a block", "#e69f00"},
                                 StripCause{"no feasible feed", "#c0241c"}};

// What limits the spindle speed, in the order of SpeedLimit.
constexpr std::array speed_causes{StripCause{"tool life (economic speed)", "#009e73"},
                                  StripCause{"spindle speed", "#0072b2"},
                                  StripCause{"spindle power", "#cc79a7"},
                                  StripCause{"feed drive", "#e69f00"}};

// The causes that govern feed and spindle speed of all moves.
std::vector<ChartStrip> strips_of(const FeedCurves& curves)
{
    return {{"the feed is limited by",
             {feed_causes.begin(), feed_causes.end()},
             {curves.count,
              [&](std::size_t i) { return static_cast<std::size_t>(curves.limit(i)); }}},
            {"the spindle speed is limited by",
             {speed_causes.begin(), speed_causes.end()},
             {curves.count, [&](std::size_t i) {
                  return static_cast<std::size_t>(curves.speed_limit(i));
              }}}};
}

}  // namespace

std::string feed_svg(std::span<const SegmentCut> cuts, std::span<const SegmentFeed> rows,
                     const FeedFigure& figure)
{
    require(cuts.size() == rows.size(), "feed_svg: need one row for each move");
    return feed_svg(
        {.count = cuts.size(),
         .length_mm = [&](std::size_t i) { return cuts[i].length_mm; },
         .mu = [&](std::size_t i) { return cuts[i].mu; },
         .lambda = [&](std::size_t i) { return cuts[i].lambda; },
         .pick_feed_mm = [&](std::size_t i) { return cuts[i].pick_feed_mm; },
         .pick_feed_horizontal_mm =
             [&](std::size_t i) { return cuts[i].pick_feed_horizontal_mm; },
         .depth_mm = [&](std::size_t i) { return cuts[i].depth_mm; },
         .feed_mm_per_min = [&](std::size_t i) { return rows[i].table.feed_mm_per_min; },
         .spindle_rpm = [&](std::size_t i) { return rows[i].table.spindle_rpm; },
         .limit = [&](std::size_t i) { return reported_limit(rows[i]); },
         .speed_limit = [&](std::size_t i) { return rows[i].table.speed_limit; }},
        figure);
}

std::string feed_svg(const FeedCurves& curves, const FeedFigure& figure)
{
    const std::size_t count = curves.count;
    std::vector<double> places;
    reserve_in_large_pages(places, count);
    double along = 0;
    for (std::size_t i = 0; i < count; ++i)
        places.push_back(along += curves.length_mm(i));
    const std::vector<ChartPanel> panels{
        {"slope, degrees",
         {{"across the feed", first_style, {count, in_degrees(curves.mu)}},
          {"along the feed", second_style, {count, in_degrees(curves.lambda)}}}},
        {"pick feed, mm",
         {{"between centres", first_style, {count, curves.pick_feed_mm}},
          {"horizontal", second_style, {count, curves.pick_feed_horizontal_mm}}}},
        {"depth, mm", {{"stock over the tip", first_style, {count, curves.depth_mm}}}},
        {"feed, mm/min", {{"feed", first_style, {count, curves.feed_mm_per_min}}}},
        {"spindle, rpm", {{"speed", first_style, {count, curves.spindle_rpm}}}}};
    return stacked_chart({figure.title, figure.captions, "length of cut, mm"}, places,
                         panels, strips_of(curves));
}

}  // namespace endmill
