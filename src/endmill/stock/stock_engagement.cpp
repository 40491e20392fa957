// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/stock_engagement.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/stock/detail/removable_path.h"
#include "endmill/stock/detail/stock_probe.h"

// For each move the cutter stands in its middle and the stock is the one before the move.
// 1. `rings_of` divides the profile into rings, from the bottom over the corner up the
//    cylinder.
// 2. `is_engaged` tests the middle of each cell of a ring: its normal must face the
//    direction of the move, and the interpolated stock must be higher.
// 3. `find_intervals` joins neighbouring engaged cells of a ring to intervals of azimuth.
// Then the move is removed from the stock.

namespace endmill {
namespace {

using std::numbers::pi;

// Limits the number of rings on a cylinder that is sunk deep into the stock.
constexpr int most_cylinder_rings = 1000;

// Returns the rings of a cutter from its tip to `height` above it, with nothing engaged
// yet.
std::vector<EngagedRing> rings_of(const Cutter& cutter, int rings, double height)
{
    const double r = cutter.corner_radius();
    const double c = cutter.flat_radius();
    const double width = (cutter.is_flat() ? cutter.radius() : r * pi / 2) / rings;
    std::vector<EngagedRing> all;
    const int on_bottom = static_cast<int>(std::ceil(c / width));
    const double on_cylinder = std::clamp(std::ceil((height - r) / width), 0.0,
                                          static_cast<double>(most_cylinder_rings));
    all.reserve(static_cast<std::size_t>(on_bottom) + rings +
                static_cast<std::size_t>(on_cylinder));
    for (int k = 0; k < on_bottom; ++k)
        all.push_back({0, c * (k + 0.5) / on_bottom, 0, c / on_bottom, {}});
    for (int k = 0; k < rings && !cutter.is_flat(); ++k) {
        const double latitude = pi / 2 * (k + 0.5) / rings;
        all.push_back({latitude,
                       c + r * std::sin(latitude),
                       r - r * std::cos(latitude),
                       width,
                       {}});
    }
    for (int k = 0; k < most_cylinder_rings && r + (k + 0.5) * width < height; ++k)
        all.push_back({pi / 2, cutter.radius(), r + (k + 0.5) * width, width, {}});
    return all;
}

// The cutter in the middle of a move.
struct Pose {
    Vec3 tip;
    Vec3 way;       // direction of the move, unit
    double feed_x;  // direction of azimuth 0, unit
    // Direction of azimuth 0, unit.
    double feed_y;
};

// Whether the place of the cutter at this ring and azimuth faces the move and is in the
// stock.
bool is_engaged(const HeightStock& stock, const Pose& pose, const EngagedRing& ring,
                double azimuth)
{
    const double cosine = std::cos(azimuth);
    const double sine = std::sin(azimuth);
    const Vec3 outwards{pose.feed_x * cosine - pose.feed_y * sine,
                        pose.feed_y * cosine + pose.feed_x * sine, 0};
    const Vec3 normal =
        std::sin(ring.latitude) * outwards - std::cos(ring.latitude) * Vec3::UnitZ();
    if (normal.dot(pose.way) <= 0)
        return false;
    const Vec3 place = pose.tip + ring.radius * outwards;
    const auto height = interpolated_height(stock, place.x(), place.y());
    return height && *height > stock.grid().bottom_z &&
           *height > pose.tip.z() + ring.above;
}

// Fills the engaged intervals of a ring.
void find_intervals(const HeightStock& stock, const Pose& pose, int azimuths,
                    EngagedRing& ring)
{
    for (int k = 0; k < azimuths; ++k) {
        const double from = -pi + 2 * pi * k / azimuths;
        const double to = -pi + 2 * pi * (k + 1) / azimuths;
        if (!is_engaged(stock, pose, ring, (from + to) / 2))
            continue;
        if (!ring.engaged.empty() && ring.engaged.back().to == from)
            ring.engaged.back().to = to;
        else
            ring.engaged.push_back({from, to});
    }
}

// A move between two tips, mm.
struct StraightMove {
    Vec3 from;
    Vec3 to;
};

// Returns the engaged region in the middle of a move. `top_z` bounds the stock's heights.
Engagement engagement_on(const HeightStock& stock, const Cutter& cutter,
                         const StraightMove& move, const EngagementOptions& options,
                         double top_z)
{
    Engagement engagement;
    const Vec3 way = move.to - move.from;
    const double length = way.norm();
    const double level = std::hypot(way.x(), way.y());
    if (length == 0 || (level == 0 && way.z() > 0))
        return engagement;
    const Pose pose{(move.from + move.to) / 2, way / length,
                    level > 0 ? way.x() / level : 1, level > 0 ? way.y() / level : 0};
    for (EngagedRing& ring : rings_of(cutter, options.rings, top_z - pose.tip.z())) {
        find_intervals(stock, pose, options.azimuths, ring);
        if (!ring.engaged.empty())
            engagement.rings.push_back(std::move(ring));
    }
    return engagement;
}

}  // namespace

void for_each_engagement(
    HeightStock& stock, const ToolPath& path, const Cutter& cutter,
    const std::function<void(std::size_t number, const Engagement& engagement)>& visit,
    const EngagementOptions& options)
{
    require(options.rings >= 1 && options.azimuths >= 1,
            "for_each_engagement: need a ring and an azimuth");
    require_removable(path);
    const auto range = height_range(stock);
    const double top_z = range ? range->high : stock.grid().bottom_z;
    for (std::size_t k = 0; k < path.points.size(); ++k) {
        const Vec3& to = path.points[k].location.tip;
        const Vec3& from = k == 0 ? to : path.points[k - 1].location.tip;
        if (k > 0)
            visit(k, engagement_on(stock, cutter, {from, to}, options, top_z));
        if (k > 0 || cuts_at_start(path))
            remove_swept(stock, cutter, swept_move(from, to));
    }
}

}  // namespace endmill
