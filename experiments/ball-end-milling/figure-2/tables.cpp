// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball-end-milling/figure-2/tables.h"

#include <cmath>
#include <cstdint>
#include <numbers>

#include "endmill/core/angle.h"
#include "endmill/figures/detail/ball_lines.h"
#include "endmill/process/detail/engaged_region.h"

namespace endmill {
namespace {

using std::numbers::pi;

double latitude_of(const Vec3& point)
{
    return std::atan2(std::hypot(point.x(), point.y()), -point.z());
}

}  // namespace

CsvTable border_table(const std::vector<EngagementBorder>& borders, double radius_mm)
{
    CsvTable table{
        {"border", "piece", "x_mm", "y_mm", "z_mm", "latitude_deg", "azimuth_deg"}};
    std::int64_t piece = 0;
    for (const EngagementBorder& border : borders) {
        for (const Vec3& point : border.points) {
            const Vec3 place = radius_mm * point;
            table.add_row({border.name, piece, place.x(), place.y(), place.z(),
                           Angle::radians(latitude_of(point)).degrees(),
                           Angle::radians(std::atan2(point.x(), point.y())).degrees()});
        }
        ++piece;
    }
    return table;
}

NamedCells latitude_cells(const BallEngagement& engagement, double latitude, int samples)
{
    const std::vector<AzimuthRange> ranges = engaged_ranges(engagement, latitude);
    double engaged = 0;
    for (const AzimuthRange& range : ranges)
        engaged += range.to - range.from;
    int hits = 0;
    for (int k = 0; k < samples; ++k) {
        const double azimuth = 2 * pi * (k + 0.5) / samples - pi / 2;
        hits += is_engaged(engagement, latitude, azimuth) ? 1 : 0;
    }
    NamedCells cells{{"ranges", static_cast<std::int64_t>(ranges.size())},
                     {"engaged_deg", Angle::radians(engaged).degrees()},
                     {"sampled_deg", 360.0 * hits / samples}};
    if (!ranges.empty()) {
        cells.emplace_back("from_deg", Angle::radians(ranges.front().from).degrees());
        cells.emplace_back("to_deg", Angle::radians(ranges.back().to).degrees());
    }
    return cells;
}

double i6_by_ranges(const BallEngagement& engagement, int latitudes)
{
    const double highest = highest_latitude(engagement);
    const double step = highest / latitudes;
    double sum = 0;
    for (int k = 0; k < latitudes; ++k) {
        const double latitude = (k + 0.5) * step;
        for (const AzimuthRange& range : engaged_ranges(engagement, latitude))
            sum += (range.to - range.from) * std::sin(latitude) * step;
    }
    return sum / (2 * pi);
}

}  // namespace endmill
