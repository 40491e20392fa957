// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
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
void refuse_options_idle_on(std::span<const SearchedMachine> machines,
                            const SetupCommandOptions& options);

/// The mode of the search. Nothing if it has no effect: on one valid machine of fewer
/// than five axes all modes but `set` are the same, and `set` reports its objective.
std::optional<SetupMode> effective_mode(std::span<const SearchedMachine> machines,
                                        const SetupCommandOptions& options);

}  // namespace endmill
