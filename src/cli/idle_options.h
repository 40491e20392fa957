// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "cli/command.h"

namespace endmill {

/// Refuses options that have no effect, since the user expects one from each option.
/// \param names options without effect, such as "--gap".
/// \param found the reason, such as "--mode verified".
/// \param expected an option with which they have an effect, such as "--mode paper".
/// \throws DomainError naming the first option of `names` that was given.
void refuse_idle_options(const CommonOptions& options, std::span<const char* const> names,
                         const std::string& found, const std::string& expected);

}  // namespace endmill
