// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "cli/surface_facts.h"
#include "endmill/core/angle.h"
#include "endmill/core/vec.h"
#include "endmill/setup/setup.h"
#include "endmill/visibility/visibility.h"

namespace endmill {

/// The options of `endmill setup`.
struct SetupCommandOptions {
    CommonOptions common;
    PartOptions part;  ///< its path is empty with `points` and `toolpath`
    std::optional<double> chord_tolerance;  ///< mm, of the mesh of a surface
    std::string skip_facets;                ///< list of facets; empty: none
    std::string points;                     ///< CSV of directions instead of a part
    std::string toolpath;                   ///< path to run instead of a part
    std::string machine;                    ///< word, file, folder, or "all"
    std::optional<RotaryFamily> family;     ///< instead of a machine
    std::string limits;                     ///< see `rotary_limits_help`; empty: none
    std::string sphere = "hex:10";
    SetupMode mode = SetupMode::Paper;
    VisibilityKind visibility = VisibilityKind::Global;
    double incidence_deg = 90;
    SetupObjective objective = SetupObjective::FlooredArea;
    double floor_deg = 5.9;
    double gap = 0.05;
    int max_nodes = 200'000;
    int max_setups = 1;
    double arc_tolerance_deg = 2.95;
    std::optional<Vec3> clamp;  ///< mm, position of the part's origin on the machine
    TravelRule travel = TravelRule::Checked;  ///< whether travel bounds the search
    std::string tool;                         ///< file
    std::string from_visibility;              ///< file
    bool write_bsm_csv = false;
};

/// Adds every option of `setup` to `command`.
void add_setup_options(CLI::App& command, SetupCommandOptions& options);

/// The word of a mode, as --mode takes it.
std::string_view setup_mode_word(SetupMode mode);

/// The word of an objective, as --objective takes it.
std::string_view setup_objective_word(SetupObjective objective);

/// The word of a kind of visibility, as --visibility takes it.
std::string_view visibility_word(VisibilityKind kind);

}  // namespace endmill
