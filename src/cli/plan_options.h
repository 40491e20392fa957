// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "cli/command.h"
#include "cli/rotary_options.h"
#include "cli/surface_facts.h"
#include "endmill/core/angle.h"
#include "endmill/cutter/cutter.h"
#include "endmill/orientation/axis_field.h"
#include "endmill/orientation/oriented_options.h"
#include "endmill/planning/economy.h"
#include "endmill/planning/planned_path.h"

namespace endmill {

/// The parameter along which the passes run, or the best direction of upright planes.
enum class PlanDirection { U, V, Both, Best };

/// The strategies that the command offers.
enum class StrategyChoice {
    Iso,         ///< along parameter lines, both directions or one of them
    IsoU,        ///< Strategy::IsoU
    IsoV,        ///< Strategy::IsoV
    Planar,      ///< Strategy::Planar
    IsoScallop,  ///< Strategy::IsoScallop
    Field,       ///< Strategy::Field
    Best,        ///< the shortest of all strategies
};

/// The lower bound with which a path is compared, where no closed form is known.
enum class PlanBound {
    Estimated,  ///< BoundGrade::Estimated
    Certified,  ///< BoundGrade::Certified
    None        ///< not computed
};

/// The options of `endmill plan`. An empty option takes the default that the help states.
struct PlanOptions {
    CommonOptions common;
    PartOptions part;
    PartOptions
        guard;  ///< a part that the path must not enter; none if its path is empty
    std::vector<int> faces;        ///< the faces to cut, from 1, ascending; empty: all
    std::string skip_facets;       ///< list of facets that stay uncut; empty: none
    std::string setup;             ///< summary.json of a setup; empty: the part as it is
    std::string setups;            ///< the same for several directions; empty: one axis
    std::optional<Cutter> cutter;  ///< a ball that fits if empty
    RequestedTolerances requested;
    std::optional<double> safe_height;  ///< mm along the axis
    std::optional<double> feed_mm_per_min;
    PlanDirection direction = PlanDirection::Both;
    Planner mode = Planner::Verified;
    /// How passes are laid.
    StrategyChoice strategy = StrategyChoice::Best;
    std::optional<Angle> pass_direction;  ///< of StrategyChoice::Planar; best if empty
    std::optional<AxisMode> axis_mode;    ///< how the axis turns; a fixed axis if empty
    Inclination inclination;              ///< of an axis that turns
    LeanRange lead_range;                 ///< of AxisMode::Field
    LeanRange tilt_range;                 ///< of AxisMode::Field
    RotaryOptions rotary;                 ///< machine of AxisMode::Field; may be none
    std::string tool;                     ///< tool file of AxisMode::Field; may be empty
    PlanBound bound =
        PlanBound::Estimated;  ///< that a path by a strategy is compared with
    TravelKind distance = TravelKind::Contact;
    CountedMoves counted = CountedMoves::CutsAndLinks;
    RequiredContinuity required = RequiredContinuity::None;
    IsoParametricOptions planning;  ///< the policies
    MotionTolerances motion{};  ///< the values in force; they also judge Planner::Paper
};

/// Adds every option of `plan` to `command`.
void add_plan_options(CLI::App& command, PlanOptions& options);

/// Chooses Iso if no strategy was given, but an option of it: a parameter, the outer
/// tolerance, `--mode paper` or the like. Chooses Planar likewise for a direction of it, and
/// Best for a protected part.
void complete_strategy(PlanOptions& options);

/// Chooses the strategy of a part for --axis-mode, unless it was given: on a mesh Planar for a
/// direction or a cutter that is no ball, else IsoScallop.
/// \throws DomainError naming an option that has no effect on such a part.
void complete_for_oriented_part(PlanOptions& options, bool is_mesh);

/// \throws DomainError naming an option that has no effect in the mode or with the
/// others, or a tolerance of 0 that the mode cannot keep.
void refuse_idle_plan_options(const PlanOptions& options);

/// The word for `mode` in summaries.
std::string mode_word(Planner mode);
/// The word for `mode` in summaries.
std::string axis_mode_word(AxisMode mode);
/// The word for `strategy` in summaries.
std::string strategy_word(StrategyChoice strategy);

/// The options of the planner along `along`.
PlannerOptions planner_options(const PlanOptions& options, Parameter along);

/// Adds every policy with the value in force to a summary.
void add_policies(Json& summary, const PlanOptions& options);

}  // namespace endmill
