// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/idle_commands.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(IsIdleCommand, HoldsForCommandsThatDoNotMove)
{
    for (const std::string_view name :
         {"COMMENT", "MESSAGE", "FLOOD_ON", "DWELL", "FINISH", "SET_TRAVERSE_RATE",
          "SET_NAIVECAM_TOLERANCE", "UNCLAMP_AXIS", "CLAMP_AXIS", "PROGRAM_STOP",
          "SPINDLE.0.WAIT_ORIENT_COMPLETE"})
        EXPECT_TRUE(is_idle_command(name)) << name;
}

TEST(IsIdleCommand, DoesNotHoldForMotionOffsetsAndUnits)
{
    for (const std::string_view name :
         {"STRAIGHT_FEED", "STRAIGHT_TRAVERSE", "ARC_FEED", "NURBS_FEED",
          "STRAIGHT_PROBE", "RIGID_TAP", "SPINDLE_RETRACT_TRAVERSE", "SET_G5X_OFFSET",
          "SET_G92_OFFSET", "SET_XY_ROTATION", "USE_LENGTH_UNITS", "SELECT_PLANE",
          "SET_FEED_RATE", "START_SPEED_FEED_SYNCH", "CANON_ERROR", "", "comment"})
        EXPECT_FALSE(is_idle_command(name)) << name;
}

}  // namespace
}  // namespace endmill
