// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "cli/command.h"
#include "endmill/planning/iso_parametric.h"
#include "endmill/planning/verified_plan.h"

namespace endmill {

/// The parameter along which the passes run.
enum class PlanDirection { U, V, Both };

/// The planner that chooses passes and points.
enum class PlanMode {
    Paper,     ///< as published, misprints corrected
    Verified,  ///< the straight motion of the ball keeps the tolerances everywhere
};

/// The points between which travel is measured where one number decides.
enum class TravelKind {
    Contact,  ///< chords between contacts
    Tip,      ///< the tip of the cutter, as the machine travels
};

/// The options of `endmill plan`. An empty option takes the default that the help states.
struct PlanOptions {
    CommonOptions common;
    std::string part;
    std::optional<double> cutter_diameter;  ///< of the ball, mm
    std::optional<double> chord_tolerance;  ///< mm
    std::optional<double> scallop_height;   ///< mm
    std::optional<double> inner_tolerance;  ///< mm
    std::optional<double> outer_tolerance;  ///< mm
    std::optional<double> safe_height;      ///< mm along the axis
    std::optional<double> feed_mm_per_min;
    PlanDirection direction = PlanDirection::Both;
    PlanMode mode = PlanMode::Verified;
    TravelKind distance = TravelKind::Contact;
    bool count_links = true;
    bool g1_is_required = false;
    IsoParametricOptions planning;  ///< the policies
    MotionTolerances motion{};  ///< the values in force; they also judge PlanMode::Paper
};

/// Adds every option of `plan` to `command`.
void add_plan_options(CLI::App& command, PlanOptions& options);

/// \throws DomainError naming an option that has no effect in the mode or with the
/// others.
void refuse_idle_plan_options(const PlanOptions& options);

/// The word for `mode` in summaries.
std::string mode_word(PlanMode mode);

/// The options of a verified plan along `along`.
VerifiedOptions verified_options(const PlanOptions& options, Parameter along);

/// Adds every policy with the value in force to a summary.
void add_policies(Json& summary, const PlanOptions& options);

}  // namespace endmill
