// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "cli/setup_machine.h"
#include "cli/setup_options.h"

namespace endmill {

/// Refuses options of `endmill setup` that would change nothing beside the others: each was
/// meant for something.
/// \throws DomainError with the option, and what it is of use with.
void refuse_idle_setup_options(const SetupCommandOptions& options);

/// The same for what would change nothing on these machines. Of several nothing is refused, and
/// on a word that is no machine nothing either: its reason is the answer.
/// \throws DomainError as above
void refuse_options_idle_on(std::span<const SetupMachine> machines,
                            const SetupCommandOptions& options);

}  // namespace endmill
