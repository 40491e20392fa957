// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/detail/ball_lines.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace endmill {
namespace {

// Step along a curved line; the chord is off the arc by less than the width of the line.
constexpr double step_rad = 2 * std::numbers::pi / 180;

// Number of steps along an arc of this angle.
int steps_over(double angle)
{
    return 1 + static_cast<int>(std::abs(angle) / step_rad);
}

}  // namespace

Vec3 BallFrame::turned(const Vec3& place) const
{
    return {place.x(), milling == Milling::Up ? place.y() : -place.y(), place.z()};
}

Vec3 BallFrame::in_room(const Vec3& place) const
{
    return radius_mm * turned(place);
}

std::vector<Vec3> BallFrame::in_room(const std::vector<Vec3>& line) const
{
    std::vector<Vec3> places;
    places.reserve(line.size());
    for (const Vec3& place : line)
        places.push_back(in_room(place));
    return places;
}

double highest_latitude(const BallEngagement& engagement)
{
    return std::acos(std::clamp(1 - engagement.depth_ratio, 0.0, 1.0));
}

Vec3 ball_point(double latitude, double azimuth)
{
    return {std::sin(latitude) * std::sin(azimuth),
            std::sin(latitude) * std::cos(azimuth), -std::cos(latitude)};
}

// The arc is spanned by `from` and the unit vector across it in the plane of both
// directions.
std::vector<Vec3> arc_between(const Vec3& centre, const Vec3& from, const Vec3& to,
                              double radius)
{
    const double angle = std::atan2(from.cross(to).norm(), from.dot(to));
    const Vec3 across = (to - from.dot(to) * from).normalized();
    const int steps = steps_over(angle);
    std::vector<Vec3> line;
    for (int k = 0; k <= steps; ++k) {
        const double at = angle * k / steps;
        line.emplace_back(centre +
                          radius * (std::cos(at) * from + std::sin(at) * across));
    }
    return line;
}

std::vector<Vec3> latitude_line(double latitude, double from, double to)
{
    const int steps = steps_over(to - from);
    std::vector<Vec3> line;
    for (int k = 0; k <= steps; ++k)
        line.push_back(ball_point(latitude, from + (to - from) * k / steps));
    return line;
}

// The name is moved along the arrow, farther for longer names if the arrow is level.
void add_named_arrow(AxonometricFigure& figure, const BallFrame& frame,
                     std::span<const Vec3, 2> ends, std::string_view name,
                     const LineStyle& style)
{
    constexpr double gap_px = 10;
    constexpr double half_letter_px = 4.5;
    const Vec3 from = frame.in_room(ends[0]);
    const Vec3 to = frame.in_room(ends[1]);
    figure.add_arrow(from, to, style);
    const AxonometricView& view = figure.view();
    const PixelPoint along =
        PixelPoint{view.right.dot(to - from), -view.up.dot(to - from)}.normalized();
    const double half_width_px = half_letter_px * static_cast<double>(name.size());
    figure.add_label(to, (gap_px + half_width_px * std::abs(along.x())) * along, name,
                     style.colour);
}

}  // namespace endmill
