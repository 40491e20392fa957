// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "cli/command.h"

namespace endmill {

/// Refuses options that would have no effect: whoever gave one expected something of it.
/// \param names of the options without effect, such as "--gap".
/// \param found what makes them so, such as "--mode verified".
/// \param expected what would give them an effect, such as "--mode paper".
/// \throws DomainError naming the first option of `names` that was given.
void refuse_idle_options(const CommonOptions& options, std::span<const char* const> names,
                         const std::string& found, const std::string& expected);

}  // namespace endmill
