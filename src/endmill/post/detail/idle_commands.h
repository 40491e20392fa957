// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace endmill {

/// Whether the canonical command `name` can neither move the tool nor change what a later
/// command means: comments, coolant, overrides, stops and the like.
/// Source: the functions that LinuxCNC's src/emc/sai/saicanon.cc prints.
bool is_idle_command(std::string_view name);

}  // namespace endmill
