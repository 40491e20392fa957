// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "cli/setup_answer.h"

namespace endmill {

/// What `endmill setup` tells of its best answer, the first one; with the ranking of all where
/// there are several.
Json setup_summary(const SetupInput& input, const SetupVisibility& visibility,
                   std::span<const SetupAnswer> answers,
                   const SetupCommandOptions& options);

/// The same for a person: some lines.
std::string setup_text(const Json& summary);

/// Keys of a pose and its ranges: `area_deg2`, `phi_deg`, `theta_deg`, `tool_axis`, `r1_axis`,
/// `r2_axis`; null without one.
Json pose_json(const std::optional<FittedPose>& fit);

/// Of a machine: `machine` (its file), `configuration`, `type` and `reason`, why it is none.
Json machine_json(const SetupMachine& machine);

/// Of what a pose is compared with: `limits_phi_deg`, `limits_theta_deg`.
Json limits_json(const RotaryLimits& limits);

/// [min, max] in degrees.
Json range_json(const RotaryRange& range);

/// The word of a status: "ok", "3-axis", "4-axis" or "not in an open hemisphere".
std::string setup_status_word(SetupStatus status);

}  // namespace endmill
