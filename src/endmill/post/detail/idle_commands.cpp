// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/idle_commands.h"

#include <algorithm>
#include <array>

namespace endmill {
namespace {

// In alphabetical order, for the binary search.
constexpr std::array<std::string_view, 45> idle_names{
    "CLAMP_AXIS",
    "CLEAR_AUX_OUTPUT_BIT",
    "CLEAR_MOTION_OUTPUT_BIT",
    "COMMENT",
    "DISABLE_ADAPTIVE_FEED",
    "DISABLE_FEED_HOLD",
    "DISABLE_FEED_OVERRIDE",
    "DISABLE_SPEED_OVERRIDE",
    "DWELL",
    "ENABLE_ADAPTIVE_FEED",
    "ENABLE_FEED_HOLD",
    "ENABLE_FEED_OVERRIDE",
    "ENABLE_SPEED_OVERRIDE",
    "FINISH",
    "FLOOD_OFF",
    "FLOOD_ON",
    "LOG",
    "LOGAPPEND",
    "LOGCLOSE",
    "LOGOPEN",
    "MESSAGE",
    "MIST_OFF",
    "MIST_ON",
    "ON_RESET",
    "OPTIONAL_PROGRAM_STOP",
    "ORIENT_SPINDLE",
    "PALLET_SHUTTLE",
    "PROGRAM_STOP",
    "RELOAD_TOOLDATA",
    "SELECT_POCKET",
    "SET_AUX_OUTPUT_BIT",
    "SET_AUX_OUTPUT_VALUE",
    "SET_FEED_REFERENCE",
    "SET_MOTION_CONTROL_MODE",
    "SET_MOTION_OUTPUT_BIT",
    "SET_MOTION_OUTPUT_VALUE",
    "SET_NAIVECAM_TOLERANCE",
    "SET_TOOL_TABLE_ENTRY",
    "SET_TRAVERSE_RATE",
    "START_CHANGE",
    "STOP_CUTTER_RADIUS_COMPENSATION",
    "STOP_SPEED_FEED_SYNCH",
    "TURN_PROBE_OFF",
    "TURN_PROBE_ON",
    "UNCLAMP_AXIS",
};

static_assert(std::ranges::is_sorted(idle_names));

}  // namespace

bool is_idle_command(std::string_view name)
{
    // SPINDLE.0.WAIT_ORIENT_COMPLETE, and likewise for other spindles.
    const bool waits =
        name.starts_with("SPINDLE.") && name.ends_with(".WAIT_ORIENT_COMPLETE");
    return waits || std::ranges::binary_search(idle_names, name);
}

}  // namespace endmill
