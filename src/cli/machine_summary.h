// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command.h"
#include "cli/machine_options.h"
#include "endmill/machine/kinematics.h"

namespace endmill {

/// What a machine can do, and as far as `options` ask for them the directions that it can take
/// and the positions of its axes.
/// \throws DomainError for positions of axes that it does not have.
Json machine_summary(const Machine& machine, const MachineOptions& options);

}  // namespace endmill
