// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/setup_pose.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "endmill/core/error.h"

namespace endmill {
namespace {

struct NamedMode {
    std::string_view name;
    SetupMode mode;
};

constexpr std::array named_modes{NamedMode{"paper-literal", SetupMode::PaperLiteral},
                                 NamedMode{"paper", SetupMode::Paper},
                                 NamedMode{"corrected", SetupMode::Corrected},
                                 NamedMode{"set", SetupMode::WholeCones}};

bool is_valid_range(const RotaryRange& range)
{
    // rad; the two ends of a whole turn are each rounded when they are converted from
    // degrees.
    constexpr double conversion_error = 1e-12;
    return range.from <= 0 && 0 <= range.to &&
           range.to - range.from <= 2 * std::numbers::pi + conversion_error;
}

}  // namespace

std::optional<SetupMode> setup_mode(std::string_view name)
{
    const auto* const found = std::ranges::find(named_modes, name, &NamedMode::name);
    if (found == named_modes.end())
        return std::nullopt;
    return found->mode;
}

void check_pose_fit_options(const PoseFitOptions& options)
{
    require(
        options.mode != SetupMode::WholeCones,
        "setup: need a mode that fits given directions, not the search over whole cones");
    require(is_valid_range(options.limits.phi) && is_valid_range(options.limits.theta),
            "setup: need limits that contain 0 and are at most 360 degrees wide");
}

}  // namespace endmill
