// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/idle_options.h"

#include <fmt/format.h>

#include "endmill/core/error.h"

namespace endmill {

void refuse_idle_options(const CommonOptions& options, std::span<const char* const> names,
                         const std::string& found, const std::string& expected)
{
    for (const char* name : names)
        if (options.given.contains(name))
            throw DomainError{fmt::format("{}: has no effect with {}; expected {}", name,
                                          found, expected)};
}

}  // namespace endmill
