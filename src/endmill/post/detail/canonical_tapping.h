// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

namespace endmill {

/// Names of the commands before the current one in canonical output, the latest last.
/// Empty where there is none.
using EarlierCommands = std::array<std::string_view, 4>;

/// Whether a command that starts the spindle is the reversal with which a tapping cycle
/// (G74, G84) leaves its hole. LinuxCNC's interpreter writes such a hole as
///
///     DISABLE_FEED_OVERRIDE, DISABLE_SPEED_OVERRIDE,
///     STRAIGHT_FEED to the depth, STOP_SPINDLE_TURNING, START_SPINDLE_... reversed, DWELL,
///     STRAIGHT_FEED out of the hole, STOP_SPINDLE_TURNING, START_SPINDLE_... as before.
///
/// Anything else in between makes it an ordinary reversal.
/// \param before the commands before it.
/// \param name the command: START_SPINDLE_CLOCKWISE or START_SPINDLE_COUNTERCLOCKWISE.
/// \param rest the text after its line.
bool reverses_for_tapping(const EarlierCommands& before, std::string_view name,
                          std::string_view rest);

}  // namespace endmill
