// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/pole_points.h"

#include <cmath>

#include <Eigen/Geometry>

#include "endmill/setup/detail/spherical_hull.h"

namespace endmill {

PoleFrame::PoleFrame(const Vec3& tool_axis)
    : pole{tool_axis},
      x{exact_perpendiculars(tool_axis)[0].normalized()},
      y{tool_axis.cross(x)}
{
}

Vec3 PoleFrame::equator(double azimuth) const
{
    return std::cos(azimuth) * x + std::sin(azimuth) * y;
}

PolePoints::PolePoints(const Vec3& tool_axis, std::span<const Vec3> directions)
    : frame{tool_axis}
{
    for (std::vector<double>* coordinates : {&x, &y, &z})
        coordinates->reserve(directions.size());
    for (const Vec3& v : directions) {
        x.push_back(frame.x.dot(v));
        y.push_back(frame.y.dot(v));
        z.push_back(frame.pole.dot(v));
    }
}

double PolePoints::polar(std::size_t i) const
{
    return std::atan2(std::hypot(x[i], y[i]), z[i]);
}

double PolePoints::azimuth(std::size_t i) const
{
    return std::atan2(y[i], x[i]);
}

double full_turn(double angle)
{
    constexpr double turn = 2 * std::numbers::pi;
    return angle - turn * std::floor(angle / turn);
}

}  // namespace endmill
