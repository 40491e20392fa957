// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace endmill {

/// Whether the canonical command `name` neither moves the tool nor changes the meaning of
/// a later command: comments, coolant, overrides, stops and the like.
/// The list follows the functions that print canonical output in LinuxCNC's
/// src/emc/sai/saicanon.cc.
bool is_idle_command(std::string_view name);

}  // namespace endmill
