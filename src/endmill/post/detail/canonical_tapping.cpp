// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/canonical_tapping.h"

#include <algorithm>
#include <array>

#include "endmill/post/detail/canonical_line.h"

namespace endmill {
namespace {

constexpr std::string_view clockwise = "START_SPINDLE_CLOCKWISE";
constexpr std::string_view counterclockwise = "START_SPINDLE_COUNTERCLOCKWISE";

// Removes the first line of `text`. \return the name of its command; empty if it has none.
std::string_view take_command(std::string_view& text)
{
    const std::size_t end = std::min(text.find('\n'), text.size());
    const auto line = canonical_line(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    return line ? line->name : std::string_view{};
}

}  // namespace

bool reverses_for_tapping(const TappedHole& hole, std::string_view name,
                          std::string_view rest)
{
    if (!hole.is_reached())
        return false;
    const std::array<std::string_view, 4> out_of_the_hole{
        "DWELL", "STRAIGHT_FEED", "STOP_SPINDLE_TURNING",
        name == clockwise ? counterclockwise : clockwise};
    return std::ranges::all_of(out_of_the_hole, [&](std::string_view expected) {
        return take_command(rest) == expected;
    });
}

}  // namespace endmill
