// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace endmill {

/// Follows the commands of canonical output, and recognises those with which a tapping
/// cycle goes into its hole and stops the spindle there.
class TappedHole {
public:
    /// Notes the next command.
    void note(std::string_view name)
    {
        // The names differ, so that a sequence can only begin again with the first one.
        if (noted_ < into_the_hole.size() && name == into_the_hole[noted_])
            ++noted_;
        else
            noted_ = name == into_the_hole.front() ? 1 : 0;
    }

    /// Whether the last commands are this sequence.
    bool is_reached() const { return noted_ == into_the_hole.size(); }

private:
    static constexpr std::array<std::string_view, 4> into_the_hole{
        "DISABLE_FEED_OVERRIDE", "DISABLE_SPEED_OVERRIDE", "STRAIGHT_FEED",
        "STOP_SPINDLE_TURNING"};

    std::size_t noted_ = 0;  // of the sequence
};

/// Whether a command that starts the spindle is the reversal with which a tapping cycle
/// (G74, G84) leaves its hole. LinuxCNC's interpreter writes such a hole as
///
///     DISABLE_FEED_OVERRIDE, DISABLE_SPEED_OVERRIDE,
///     STRAIGHT_FEED to the depth, STOP_SPINDLE_TURNING, START_SPINDLE_... reversed, DWELL,
///     STRAIGHT_FEED out of the hole, STOP_SPINDLE_TURNING, START_SPINDLE_... as before.
///
/// Anything else in between makes it an ordinary reversal.
/// \param hole has followed the commands before it.
/// \param name the command: START_SPINDLE_CLOCKWISE or START_SPINDLE_COUNTERCLOCKWISE.
/// \param rest the text after its line.
bool reverses_for_tapping(const TappedHole& hole, std::string_view name,
                          std::string_view rest);

}  // namespace endmill
