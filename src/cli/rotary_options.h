// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "endmill/machine/kinematics.h"
#include "endmill/post/program.h"

namespace endmill {

/// The machine of a path or a program with rotary axes, and how the part is clamped on it.
struct RotaryOptions {
    std::string machine;                      ///< word or file; empty: none
    std::optional<Interpolation> frame = {};  ///< of X, Y and Z: Joint or Tcp
    std::string setup;                        ///< summary.json of `setup`; may be empty
    std::optional<Vec3> clamp = {};           ///< mm, where the part's origin is clamped
    std::string wrapped;                      ///< rules of rotary words; may be empty
};

/// Adds the options --machine and --clamp.
void add_clamped_machine_options(CLI::App& command, RotaryOptions& options);

/// Adds the options --machine, --frame, --setup, --clamp and --wrapped.
void add_rotary_options(CLI::App& command, RotaryOptions& options);

/// Refuses options that need --machine.
/// \throws DomainError
void refuse_idle_rotary_options(const RotaryOptions& rotary,
                                const CommonOptions& options);

/// The machine with the clamped part.
/// \param tool_length mm, from the spindle nose to the tip.
/// \return nothing without --machine.
/// \throws DomainError for a word that is no machine; FormatError as `read_machine` and
///         `read_setup_pose`.
std::optional<PartOnMachine> part_on_machine(const RotaryOptions& rotary,
                                             double tool_length,
                                             const CommonOptions& options);

/// How the rotary words of a program are read.
/// \param setup the machine. \param cutter_radius mm; 0 if it is not known.
/// \throws DomainError without --frame, and for --wrapped of axes that the machine lacks.
RotaryReading rotary_reading(const RotaryOptions& rotary, const PartOnMachine& setup,
                             double cutter_radius);

}  // namespace endmill
