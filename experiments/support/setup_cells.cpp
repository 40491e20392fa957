// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/setup_cells.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/setup/setup.h"
#include "support/studied_part.h"

namespace endmill {
namespace {

// Tool axes within this sine of z, 0.006 degrees, have no azimuth: a cell is a thousand
// times as wide.
constexpr double upright = 1e-4;

double degrees(double radians)
{
    return Angle::radians(radians).degrees();
}

CsvCell azimuth(const Vec3& axis)
{
    if (std::hypot(axis.x(), axis.y()) < upright)
        return std::monostate{};
    return degrees(std::atan2(axis.y(), axis.x()));
}

CsvCell lean(const Vec3& axis)
{
    if (std::abs(axis.x()) < upright)
        return std::monostate{};
    return word(axis.x() > 0);
}

}  // namespace

RotaryFamily family_of_word(const std::string& word)
{
    require(word == "CA" || word == "AB", "family_of_word: need CA or AB");
    return word == "CA" ? RotaryFamily::CA : RotaryFamily::AB;
}

SetupMode mode_of_word(const std::string& word)
{
    const auto mode = setup_mode(word);
    require(mode.has_value(), "mode_of_word: need a mode's name");
    return *mode;
}

SetupObjective objective_of_word(const std::string& word)
{
    if (word == "floored-area")
        return SetupObjective::FlooredArea;
    if (word == "total-range")
        return SetupObjective::TotalRange;
    require(word == "tilt", "objective_of_word: need floored-area, total-range or tilt");
    return SetupObjective::Tilt;
}

std::string type_name(const MachineConfiguration& machine)
{
    const auto is_head = [&](std::size_t axis) {
        return machine.rotary.at(axis).side == MachineSide::Head;
    };
    if (is_head(0) != is_head(1))
        return "table and spindle";
    return is_head(0) ? "spindle tilting" : "table tilting";
}

double square_degrees(double square_radians)
{
    constexpr double degrees = 180 / std::numbers::pi;
    return square_radians * degrees * degrees;
}

double in_degrees(SetupObjective objective, double value)
{
    return objective == SetupObjective::FlooredArea ? square_degrees(value)
                                                    : degrees(value);
}

NamedCells axis_cells(const Vec3& axis)
{
    const double tilt = std::atan2(std::hypot(axis.x(), axis.y()), axis.z());
    return {{"axis_x", axis.x()},           {"axis_y", axis.y()},
            {"axis_z", axis.z()},           {"tilt_deg", degrees(tilt)},
            {"azimuth_deg", azimuth(axis)}, {"leans_to_x", lean(axis)}};
}

NamedCells range_cells(RotaryFamily family, const FittedPose& fit)
{
    const auto phi = magnitudes(fit.phi);
    const auto theta = magnitudes(fit.theta);
    return {{"area_deg2", square_degrees(fit.area)},
            {"phi_s_deg", degrees(phi[0])},
            {"phi_l_deg", degrees(phi[1])},
            {"theta_s_deg", degrees(theta[0])},
            {"theta_l_deg", degrees(theta[1])},
            {"width_deg", degrees(pose_ranges(family, fit).width)}};
}

}  // namespace endmill
