// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/setup_pose.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// In the order of the enumerators, so that a mode is an index.
constexpr std::array all_rules{
    //                       name            wide   vertices  both   low    signed
    SetupRules{SetupMode::PaperLiteral, "paper-literal", false, true, false, false,
               false},
    SetupRules{SetupMode::Paper, "paper", false, false, false, false, false},
    SetupRules{SetupMode::Corrected, "corrected", true, false, true, true, true},
    SetupRules{SetupMode::WholeCones, "set", true, false, true, true, true}};

bool is_valid_range(const RotaryRange& range)
{
    // rad; the two ends of a whole turn are each rounded when they are converted from
    // degrees.
    constexpr double conversion_error = 1e-12;
    return range.from <= 0 && 0 <= range.to &&
           range.to - range.from <= 2 * std::numbers::pi + conversion_error;
}

}  // namespace

const SetupRules& setup_rules(SetupMode mode)
{
    return all_rules[static_cast<std::size_t>(mode)];
}

std::optional<SetupMode> setup_mode(std::string_view name)
{
    const auto* const found =
        std::find_if(all_rules.begin(), all_rules.end(),
                     [name](const SetupRules& rules) { return rules.name == name; });
    if (found == all_rules.end())
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
