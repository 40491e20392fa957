// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/feed_svg.h"

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
         {{"mu, across the feed", first_style,
           values(cuts, [](const SegmentCut& c) { return degrees(c.mu); })},
          {"lambda, of the feed", second_style,
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
                         panels);
}

}  // namespace endmill
