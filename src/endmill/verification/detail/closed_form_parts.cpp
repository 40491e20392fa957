// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/closed_form_parts.h"

#include <cmath>

#include "endmill/surface/nurbs.h"

namespace endmill {
namespace {

constexpr double R = 5;  // radius of all balls, mm

}  // namespace

ToolPath tip_path(const std::vector<Vec3>& tips)
{
    ToolPath path;
    for (const Vec3& tip : tips)
        path.points.push_back({.pass = 0,
                               .point = static_cast<int>(path.points.size()),
                               .move = Move::Cut,
                               .location = {tip, Vec3::UnitZ()}});
    return path;
}

Part plane_part(const Vec3& along_u, const Vec3& along_v)
{
    const Nurbs plane{{1, {0, 0, 1, 1}},
                      {1, {0, 0, 1, 1}},
                      {Vec3::Zero(), along_u, along_v, along_u + along_v},
                      {}};
    return std::vector<Surface>{nurbs_surface(plane)};
}

Part cylinder_part(double rho, Interval angles)
{
    const double half = angles.length() / 2;
    Nurbs cylinder{{1, {0, 0, 1, 1}}, {2, {0, 0, 0, 1, 1, 1}}, {}, {}};
    for (const int k : {0, 1, 2}) {
        const double angle = angles.low + k * half;
        const double weight = k == 1 ? std::cos(half) : 1;
        for (const double x : {0.0, 4.0}) {
            cylinder.control_points.emplace_back(x, rho * std::cos(angle) / weight,
                                                 rho * std::sin(angle) / weight);
            cylinder.weights.push_back(weight);
        }
    }
    return std::vector<Surface>{nurbs_surface(cylinder)};
}

ToolPath level_passes(double apart, std::optional<int> left_out)
{
    // The passes overrun the part, so the links between them do not touch it.
    const double from = -R - 1;
    const double to = 20 + R + 1;
    std::vector<Vec3> tips;
    for (int i = 0; i <= std::lround(12 / apart); ++i) {
        if (i == left_out)
            continue;
        const bool is_back = tips.size() % 4 != 0;
        tips.emplace_back(is_back ? to : from, i * apart, 0);
        tips.emplace_back(is_back ? from : to, i * apart, 0);
    }
    return tip_path(tips);
}

ToolPath passes_along_cylinder(double centre_radius, double from, double step)
{
    std::vector<Vec3> tips;
    for (int i = 0; i <= std::lround(2 / step) + 1; ++i) {
        const double angle = from + i * step;
        const double y = centre_radius * std::cos(angle);
        const double z = centre_radius * std::sin(angle) - R;
        tips.emplace_back(i % 2 ? 5 : -1, y, z);
        tips.emplace_back(i % 2 ? -1 : 5, y, z);
    }
    return tip_path(tips);
}

ToolPath lowered_path(double slope, double lowered)
{
    const Vec3 normal{-std::sin(slope), 0, std::cos(slope)};
    const Vec3 up{std::cos(slope), 0, std::sin(slope)};
    std::vector<Vec3> tips;
    for (int i = 0; i <= 60; ++i)
        for (const double y : {i % 2 ? 6.0 : 0.0, i % 2 ? 0.0 : 6.0})
            tips.push_back(0.1 * i * up + Vec3{0, y, 0} + R * normal -
                           Vec3{0, 0, R + lowered});
    return tip_path(tips);
}

}  // namespace endmill
