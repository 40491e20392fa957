// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "endmill/core/vec.h"

namespace endmill {

/// The options of `endmill machine`.
struct MachineOptions {
    CommonOptions common;
    std::string machine;          ///< word or file
    std::string limits;           ///< see `rotary_limits_help`; empty: none
    std::vector<Vec3> contains;   ///< unit directions, in the part's frame
    std::string at;               ///< positions of rotary axes in degrees; empty: none
    std::optional<Vec3> inverse;  ///< unit direction
    std::optional<Vec3> point;    ///< mm, position of the tip on the part
    double length_mm = 0;         ///< of the tool, from the spindle to the tip
};

/// Adds every option of `machine` to `command`.
void add_machine_options(CLI::App& command, MachineOptions& options);

}  // namespace endmill
