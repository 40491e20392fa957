// SPDX-License-Identifier: GPL-3.0-or-later
#include "interference/equations/equation_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "endmill/cutter/plane_offset.h"

namespace endmill {
namespace {

using Point = Eigen::Vector2d;

constexpr double right_angle_deg = 90;
constexpr int outline_samples = 256;

// The errors of a direction as the normal of a curve with this tangent.
NormalErrors errors_of(const Point& normal, const Point& tangent)
{
    const double cosine = std::abs(normal.dot(tangent));
    const double sine = std::abs(tangent.x() * normal.y() - tangent.y() * normal.x());
    return {
        std::abs(Angle::radians(std::atan2(sine, cosine)).degrees() - right_angle_deg),
        std::abs(sine - 1)};
}

// The smallest distance of the cutter's outline from a plane through `contact`, in the
// plane of the cutter's axis that is perpendicular to it. \param out horizontal and
// \param up vertical component of the plane's normal, out >= 0.
// \param reference position relative to the contact, along the same two directions.
double least_distance(const Cutter& cutter, double out, double up, const Point& reference)
{
    double least = std::numeric_limits<double>::infinity();
    const auto include = [&](double rho) {
        const double height = cutter.profile(rho) - cutter.corner_radius();
        least =
            std::min(least, (reference.x() - rho) * out + (reference.y() + height) * up);
    };
    for (int k = 0; k <= outline_samples; ++k)
        include(cutter.radius() * k / outline_samples);
    // The point of the outline that is parallel to the plane.
    include(
        std::min(cutter.radius(), cutter.flat_radius() + cutter.corner_radius() * out));
    return least;
}

}  // namespace

NormalErrors worse(const NormalErrors& one, const NormalErrors& other)
{
    return {std::max(one.angle_deg, other.angle_deg),
            std::max(one.distance_share, other.distance_share)};
}

NormalErrors printed_normal_errors(Angle slope)
{
    const double a = std::atan(1 / std::tan(slope.radians()));
    return errors_of({std::cos(a), std::sin(a)},
                     {std::cos(slope.radians()), std::sin(slope.radians())});
}

NormalErrors corrected_normal_errors(Angle slope)
{
    return errors_of(profile_normal(std::tan(slope.radians())),
                     {std::cos(slope.radians()), std::sin(slope.radians())});
}

double left_side_error(double x, double distance)
{
    const double a = std::numbers::pi / 4;
    const double offset_x = x + distance * std::cos(a);
    const double printed_difference = offset_x;
    return std::abs(printed_difference - (offset_x - x));
}

std::vector<SurfaceTangents> tangents_on_grid(const Surface& surface, int lines)
{
    const Interval u = surface.range(Parameter::U);
    const Interval v = surface.range(Parameter::V);
    std::vector<SurfaceTangents> grid;
    for (int j = 0; j < lines; ++j)
        for (int i = 0; i < lines; ++i)
            grid.push_back(surface.tangents(std::lerp(u.low, u.high, i / (lines - 1.0)),
                                            std::lerp(v.low, v.high, j / (lines - 1.0))));
    return grid;
}

double gap_in_plane(const Cutter& cutter)
{
    constexpr int samples = 400;
    constexpr double height = 12;  // mm
    constexpr double length = 60;  // mm
    std::vector<ProfilePoint> profile;
    for (int k = 1; k < samples; ++k) {
        const double w = std::numbers::pi / length;
        const double x = length * k / samples;
        profile.push_back({{x, height * std::cos(w * x)},
                           profile_normal(-height * w * std::sin(w * x))});
    }
    const auto offset = plane_offset(cutter, profile);
    double greatest = 0;
    for (std::size_t k = 0; k < profile.size(); ++k) {
        const auto& [point, normal] = profile[k];
        const double gap =
            least_distance(cutter, normal.x(), normal.y(), offset[k] - point);
        greatest = std::max(greatest, std::abs(gap));
    }
    return greatest;
}

double gap_in_space(const Cutter& cutter, const std::vector<SurfaceTangents>& grid)
{
    double greatest = 0;
    for (const SurfaceTangents& at : grid) {
        const Vec3 normal = unit_normal(at);
        if (is_level(normal))
            continue;
        const Vec3 offset = control_point(cutter, {at.point, normal}) - at.point;
        const double out = std::hypot(normal.x(), normal.y());
        const double across = (offset.x() * normal.x() + offset.y() * normal.y()) / out;
        const double gap = least_distance(cutter, out, normal.z(), {across, offset.z()});
        greatest = std::max(greatest, std::abs(gap));
    }
    return greatest;
}

double distance_spread(const Cutter& cutter, const std::vector<SurfaceTangents>& grid)
{
    double low = std::numeric_limits<double>::infinity();
    double high = 0;
    for (const SurfaceTangents& at : grid) {
        const double distance = control_offset(cutter, unit_normal(at)).norm();
        low = std::min(low, distance);
        high = std::max(high, distance);
    }
    return (high - low) / cutter.radius();
}

double gouge_without_normal(double radius, const std::vector<SurfaceTangents>& grid)
{
    const Cutter flat = Cutter::flat(radius);
    double deepest = 0;
    for (const SurfaceTangents& at : grid) {
        const Vec3 normal = unit_normal(at);
        const double out = std::hypot(normal.x(), normal.y());
        if (is_level(normal))
            continue;
        const double across = radius * std::abs(normal.x()) / out;
        deepest = std::max(deepest, -least_distance(flat, out, normal.z(), {across, 0}));
    }
    return deepest;
}

double tangent_component(const std::vector<SurfaceTangents>& grid)
{
    double greatest = 0;
    for (const SurfaceTangents& at : grid) {
        const Vec3 normal = unit_normal(at);
        for (const Vec3& partial : {at.du, at.dv})
            greatest = std::max(greatest, std::abs(normal.dot(partial)) / partial.norm());
    }
    return greatest;
}

}  // namespace endmill
