// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/inclination.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "endmill/core/error.h"

namespace endmill {
namespace {

constexpr double most_lean_deg = 89;

void require_in_range(const Inclination& inclination)
{
    const double most = Angle::degrees(most_lean_deg).radians();
    require(std::abs(inclination.lead.radians()) <= most &&
                std::abs(inclination.tilt.radians()) <= most,
            "an inclination needs a lead and a tilt of at most 89 degrees");
}

// The tangential direction in which the axis leans, by its components along f and b, and the
// sine of the angle between axis and normal. Without a lean the direction is that of the feed.
struct Lean {
    double along;
    double across;
    double sine;
};

Lean lean_of(const Inclination& inclination)
{
    const double along = std::tan(inclination.lead.radians());
    const double across = std::tan(inclination.tilt.radians());
    const double tangent = std::hypot(along, across);
    if (tangent == 0)
        return {1, 0, 0};
    return {along / tangent, across / tangent, tangent / std::hypot(1, tangent)};
}

}  // namespace

Vec3 inclined_axis(const Vec3& normal, const Vec3& feed, const Inclination& inclination)
{
    require_in_range(inclination);
    return (normal + std::tan(inclination.lead.radians()) * feed +
            std::tan(inclination.tilt.radians()) * normal.cross(feed))
        .normalized();
}

std::optional<double> remaining_curvature(const Cutter& cutter,
                                          const ContactCurvature& part,
                                          const Inclination& inclination)
{
    require_in_range(inclination);
    const double r = cutter.corner_radius();
    const auto [f, b, sine] = lean_of(inclination);
    // curvature of the cutter across its lean; 0 below a flat bottom
    const double own =
        cutter.is_ball() ? 1 / r : sine / (cutter.flat_radius() + r * sine);
    if (cutter.is_flat()) {
        // the corner is sharp: its curvature along the lean has no bound
        const double across_lean =
            own + b * b * part.along - 2 * f * b * part.mixed + f * f * part.across;
        if (!(across_lean > 0) || f == 0)
            return std::nullopt;
        return across_lean / (f * f);
    }
    const double along = f * f / r + b * b * own + part.along;
    const double across = b * b / r + f * f * own + part.across;
    const double mixed = f * b * (1 / r - own) + part.mixed;
    const double determinant = along * across - mixed * mixed;
    if (!(along > 0) || !(determinant > 0))
        return std::nullopt;
    return determinant / along;
}

std::optional<double> contact_skew(const Cutter& cutter, const ContactCurvature& part,
                                   const Inclination& inclination)
{
    if (!remaining_curvature(cutter, part, inclination))
        return std::nullopt;
    const auto [f, b, sine] = lean_of(inclination);
    if (cutter.is_flat())
        return -b / f;
    const double r = cutter.corner_radius();
    const double own =
        cutter.is_ball() ? 1 / r : sine / (cutter.flat_radius() + r * sine);
    return -(f * b * (1 / r - own) + part.mixed) / (f * f / r + b * b * own + part.along);
}

std::optional<double> strip_width(const Cutter& cutter, const ContactCurvature& part,
                                  const Inclination& inclination, double scallop_height)
{
    require(scallop_height > 0, "strip_width: need a scallop height above 0");
    const auto curvature = remaining_curvature(cutter, part, inclination);
    if (!curvature)
        return std::nullopt;
    return std::min(2 * cutter.radius(), 2 * std::sqrt(2 * scallop_height / *curvature));
}

std::optional<Angle> least_lead(const Cutter& cutter, const ContactCurvature& part)
{
    const double r = cutter.corner_radius();
    double along = std::numeric_limits<double>::infinity();
    if (r > 0) {
        along = 1 / r + part.along;
        if (!(along > 0))
            return std::nullopt;
    }
    const double k = -part.across + part.mixed * part.mixed / along;
    if (k <= 0)
        return Angle::radians(0);
    const double sine = cutter.flat_radius() * k / (1 - r * k);
    if (r * k >= 1 || sine > 1)
        return std::nullopt;
    return Angle::radians(std::asin(sine));
}

std::optional<Angle> heel_lead(const Cutter& cutter, double concave_radius)
{
    require(concave_radius > 0, "heel_lead: need a positive radius");
    if (std::isinf(concave_radius) || cutter.is_ball())
        return concave_radius > cutter.corner_radius() ? std::optional{Angle::radians(0)}
                                                       : std::nullopt;
    if (concave_radius < cutter.radius())
        return std::nullopt;
    return Angle::radians(std::asin(
        std::min(1.0, cutter.flat_radius() / (concave_radius - cutter.corner_radius()))));
}

}  // namespace endmill
