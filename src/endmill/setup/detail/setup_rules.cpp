// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/setup_rules.h"

#include <array>
#include <cstddef>

namespace endmill {
namespace {

// In the order of the enumerators, so that a mode is an index.
constexpr std::array all_rules{
    //                                  wide   vertices  both   low    signed
    SetupRules{SetupMode::PaperLiteral, false, true, false, false, false},
    SetupRules{SetupMode::Paper, false, false, false, false, false},
    SetupRules{SetupMode::Corrected, true, false, true, true, true},
    SetupRules{SetupMode::WholeCones, true, false, true, true, true}};

}  // namespace

const SetupRules& setup_rules(SetupMode mode)
{
    return all_rules[static_cast<std::size_t>(mode)];
}

}  // namespace endmill
