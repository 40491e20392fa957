// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "cli/setup_answer.h"

namespace endmill {

/// The line of a report on the pose: ranges of the rotary axes, area, tool axis. Empty
/// without a pose.
/// \param is_within whether the ranges are within the limits, which are named otherwise.
std::string setup_pose_text(const Json& summary, bool is_within);

/// summary.json of `setup`. It describes the first, best answer, and ranks all answers
/// if there are several.
Json setup_summary(const SetupInput& input, const SetupVisibility& visibility,
                   std::span<const SetupAnswer> answers,
                   const SetupCommandOptions& options);

/// The report on the terminal.
std::string setup_text(const Json& summary);

/// The keys of a pose: `area_deg2`, `phi_deg`, `theta_deg`, `tool_axis`, `r1_axis`,
/// `r2_axis`. Their values are null without a pose.
Json pose_json(const std::optional<FittedPose>& fit);

/// The keys of a machine: `machine` (its file), `configuration`, `type`, and `reason`
/// if the configuration is not valid.
Json machine_json(const SearchedMachine& machine);

/// The keys of the rotary limits: `limits_phi_deg`, `limits_theta_deg`.
Json limits_json(const RotaryLimits& limits);

/// [min, max] in degrees.
Json range_json(const RotaryRange& range);

/// The word of a status: "ok", "3-axis", "4-axis" or "not in an open hemisphere".
std::string setup_status_word(SetupStatus status);

}  // namespace endmill
