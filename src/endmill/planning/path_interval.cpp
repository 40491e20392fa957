// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/path_interval.h"

#include <cmath>
#include <limits>
#include <locale>
#include <numbers>
#include <sstream>
#include <string>

#include "endmill/core/error.h"

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// A length in mm for a message, to six digits.
std::string rounded(double mm)
{
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << mm;
    return text.str();
}

// R is the radius of the ball in mm, k the curvature in 1/mm.
void require_fit(double R, double k)
{
    if (1 + k * R <= 0)
        throw GeometryError{"a ball of radius " + rounded(R) +
                            " mm does not fit a concavity of radius " + rounded(-1 / k) +
                            " mm, its limit"};
}

// The interval whose contacts lie 90 degrees apart, alpha = 45 degrees.
// Source: paper/notes/path-interval.md, section 6.
PathInterval at_right_angle(double k)
{
    const double rho = 1 / std::abs(k);
    return {std::numbers::sqrt2 * rho, rho, std::numbers::pi / 2 * rho,
            Angle::degrees(45), LengthStatus::Clamped};
}

}  // namespace

PathInterval path_interval(const BallCutter& cutter, double curvature,
                           double scallop_height)
{
    const double R = cutter.radius();
    const double k = curvature;
    require(std::isfinite(k), "path_interval: the curvature must be finite");
    require(0 < scallop_height && scallop_height < 2 * R,
            "path_interval: need 0 < scallop height < 2 cutter radii");
    require_fit(R, k);
    // The whole concavity lies within h of one ball: h >= 2 (|rho| - R), written without
    // division.
    if (1 + 2 * k * R < 0 && 2 + k * (2 * R + scallop_height) <= 0)
        return {infinity, infinity, infinity, Angle::radians(0), LengthStatus::Unlimited};

    const double highest = highest_scallop(cutter, k);
    const bool too_high = scallop_height > highest;
    const double h = too_high ? highest : scallop_height;
    const double g2 = h * (2 * R - h) / ((1 + k * R) * (1 + k * h));
    const double kg2 = k * k * g2;
    if (kg2 > 2 - std::numbers::sqrt2)  // (2 sin 22.5 degrees)^2
        return at_right_angle(k);
    const double g = std::sqrt(g2);
    const double chord = 2 * g * std::sqrt(1 - kg2 / 4);
    // arc = 4 asin(|k| g / 2) / |k|, written as a factor that tends to 1 with k.
    const double sine = std::abs(k) * g / 2;
    const double quarter_angle = std::asin(sine);
    const double arc = 2 * g * (sine > 0 ? quarter_angle / sine : 1);
    return {chord, chord * (1 - kg2 / 2), arc, Angle::radians(2 * quarter_angle),
            too_high ? LengthStatus::Clamped : LengthStatus::Ok};
}

double highest_scallop(const BallCutter& cutter, double curvature)
{
    require(std::isfinite(curvature), "highest_scallop: the curvature must be finite");
    require_fit(cutter.radius(), curvature);
    const double closing = 1 + 2 * curvature * cutter.radius();
    return closing < 0 ? infinity : 2 * cutter.radius() / (1 + std::sqrt(closing));
}

double scallop_height(const BallCutter& cutter, double curvature, double interval)
{
    const double R = cutter.radius();
    const double k = curvature;
    const double l = interval;
    require(std::isfinite(k), "scallop_height: the curvature must be finite");
    require(std::isfinite(l) && l > 0, "scallop_height: need 0 < interval");
    require_fit(R, k);
    // m: distance of a ball centre from the bisector of the two contacts.
    const double m = (1 + k * R) * l / 2;
    if (std::abs(k) * l > 2)
        throw GeometryError{"the interval is longer than the diameter " +
                            rounded(2 / std::abs(k)) + " mm of the section"};
    if (m > R)
        throw GeometryError{"balls further apart than " + rounded(2 * R / (1 + k * R)) +
                            " mm do not meet"};
    const double c = std::sqrt(1 - k * k * l * l / 4);
    const double A = R * c - k * l * l / (4 * (1 + c));
    return (1 + k * R) * l * l / (2 * (1 + c) * (A + std::sqrt(R * R - m * m)));
}

double level_path_interval(const Cutter& cutter, double scallop_height)
{
    const double r = cutter.corner_radius();
    require(0 < scallop_height && scallop_height < 2 * r,
            "level_path_interval: need 0 < scallop height < 2 corner radii");
    return 2 * cutter.flat_radius() +
           path_interval(BallCutter{r}, 0, scallop_height).chord;
}

std::optional<double> level_scallop_height(const Cutter& cutter, double interval)
{
    require(std::isfinite(interval), "level_scallop_height: need a finite interval");
    const double between_corners = interval - 2 * cutter.flat_radius();
    if (between_corners <= 0)
        return 0;
    if (between_corners >= 2 * cutter.corner_radius())
        return std::nullopt;
    return scallop_height(BallCutter{cutter.corner_radius()}, 0, between_corners);
}

}  // namespace endmill
