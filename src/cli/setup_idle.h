// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "cli/setup_machine.h"
#include "cli/setup_options.h"

namespace endmill {

/// Refuses options of `endmill setup` that have no effect with the other options.
/// \throws DomainError naming the option and the options with which it has an effect.
void refuse_idle_setup_options(const SetupCommandOptions& options);

/// Refuses options that have no effect on the machine. Accepts all options if there are
/// several machines, or if the machine is not valid: the command then reports the
/// reason.
/// \throws DomainError as `refuse_idle_setup_options`.
void refuse_options_idle_on(std::span<const SetupMachine> machines,
                            const SetupCommandOptions& options);

}  // namespace endmill
