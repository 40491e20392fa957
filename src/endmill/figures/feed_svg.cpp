// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/feed_svg.h"

#include <array>
#include <functional>
#include <optional>

#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/figures/detail/stacked_chart.h"

// The abscissa is the length of cut at the end of each move. Moves in the air have no
// geometry; their values are unknown and leave gaps in the curves.

namespace endmill {
namespace {

constexpr LineStyle first_style{"#1d4f91", 1.2, ""};
constexpr LineStyle second_style{"#d1402f", 1.2, ""};

using Values = std::vector<std::optional<double>>;

// The values `value_of(row)` of all rows.
template <class Row, class ValueOf>
Values values(std::span<const Row> rows, const ValueOf& value_of)
{
    Values all;
    all.reserve(rows.size());
    for (const Row& row : rows)
        all.push_back(std::invoke(value_of, row));
    return all;
}

// An angle in degrees, if it is known.
std::optional<double> degrees(const std::optional<double>& radians)
{
    if (!radians)
        return std::nullopt;
    return Angle::radians(*radians).degrees();
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

// The causes that govern feed and spindle speed of all rows.
std::vector<ChartStrip> strips_of(std::span<const SegmentFeed> rows)
{
    std::vector<ChartStrip> strips{
        {"the feed is limited by", {feed_causes.begin(), feed_causes.end()}, {}},
        {"the spindle speed is limited by",
         {speed_causes.begin(), speed_causes.end()},
         {}}};
    for (const SegmentFeed& row : rows) {
        strips[0].cause.push_back(static_cast<std::size_t>(reported_limit(row)));
        strips[1].cause.push_back(static_cast<std::size_t>(row.table.speed_limit));
    }
    return strips;
}

}  // namespace

std::string feed_svg(std::span<const SegmentCut> cuts, std::span<const SegmentFeed> rows,
                     const FeedFigure& figure)
{
    require(cuts.size() == rows.size(), "feed_svg: need one row for each move");
    std::vector<double> places;
    double along = 0;
    for (const SegmentCut& cut : cuts)
        places.push_back(along += cut.length_mm);
    const std::vector<ChartPanel> panels{
        {"slope, degrees",
         {{"across the feed", first_style,
           values(cuts, [](const SegmentCut& c) { return degrees(c.mu); })},
          {"along the feed", second_style,
           values(cuts, [](const SegmentCut& c) { return degrees(c.lambda); })}}},
        {"pick feed, mm",
         {{"between centres", first_style, values(cuts, &SegmentCut::pick_feed_mm)},
          {"horizontal", second_style,
           values(cuts, &SegmentCut::pick_feed_horizontal_mm)}}},
        {"depth, mm",
         {{"stock over the tip", first_style, values(cuts, &SegmentCut::depth_mm)}}},
        {"feed, mm/min",
         {{"feed", first_style,
           values(rows, [](const SegmentFeed& r) { return r.table.feed_mm_per_min; })}}},
        {"spindle, rpm", {{"speed", first_style, values(rows, [](const SegmentFeed& r) {
                               return r.table.spindle_rpm;
                           })}}}};
    return stacked_chart({figure.title, figure.captions, "length of cut, mm"}, places,
                         panels, strips_of(rows));
}

}  // namespace endmill
