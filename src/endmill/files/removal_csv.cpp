// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/result_csv.h"

#include <cmath>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/detail/joined_rows.h"
#include "endmill/files/detail/rounded_degrees.h"

namespace endmill {
namespace {

// Large enough that writing piece by piece is as fast as writing the whole text at once.
constexpr std::size_t piece_bytes = std::size_t{1} << 20U;

// Appends a cell with a number.
void append(std::string& text, double number)
{
    require(std::isfinite(number), "removal_csv: a number is not finite");
    text += ',';
    append_text(text, number);
}

// Appends the row of the move that ends at point `i`.
void append_row(std::string& text, const Removal& removal, const ToolPath& path,
                std::size_t i)
{
    const auto tip = [&](std::size_t k) { return path.points[k].location.tip; };
    const double length = i == 0 ? 0 : (tip(i) - tip(i - 1)).norm();
    text += std::to_string(i);
    append(text, length);
    append(text, removal.removed[i]);
    if (const auto per_min = removal_rate(removal, path, i))
        append(text, *per_min);
    else
        text += ',';
    text += '\n';
}

}  // namespace

std::string removal_csv(const Removal& removal, const ToolPath& path)
{
    require(removal.removed.size() == path.points.size(),
            "removal_csv: need a volume for each point");
    return joined_rows("point,length_mm,removed_mm3,rate_mm3_per_min\n",
                       path.points.size(), [&](std::size_t first, std::size_t count) {
                           std::string text;
                           for (std::size_t i = first; i < first + count; ++i)
                               append_row(text, removal, path, i);
                           return text;
                       });
}

EngagementCsv::EngagementCsv(OutputFolder::Sink sink)
    : sink_{std::move(sink)},
      text_{"point,latitude_deg,radius_mm,above_tip_mm,from_deg,to_deg\n"}
{
}

// The first four columns are the same for all intervals of a ring and are formatted once.
void EngagementCsv::add(std::size_t number, const Engagement& engagement)
{
    std::string row;
    for (const EngagedRing& ring : engagement.rings) {
        row = std::to_string(number);
        append(row, rounded_degrees(ring.latitude));
        append(row, ring.radius);
        append(row, ring.above);
        for (const AzimuthInterval& interval : ring.engaged) {
            text_ += row;
            append(text_, rounded_degrees(interval.from));
            append(text_, rounded_degrees(interval.to));
            text_ += '\n';
        }
    }
    if (text_.size() >= piece_bytes)
        finish();
}

void EngagementCsv::finish()
{
    sink_(text_);
    text_.clear();
}

}  // namespace endmill
