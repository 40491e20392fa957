// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cli/command.h"
#include "cli/machine_options.h"
#include "endmill/machine/kinematics.h"

namespace endmill {

/// Properties of a machine. If `options` ask for them, the summary also has the reachable
/// directions and the axis positions.
/// \throws DomainError for positions of axes that the machine does not have.
Json machine_summary(const Machine& machine, const MachineOptions& options);

/// The report on the terminal: sentences that state what the summary holds.
std::string machine_text(const Json& summary, const MachineOptions& options);

}  // namespace endmill
