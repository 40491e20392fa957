// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/reference_moves.h"

#include <utility>

namespace endmill {

// The place to which the tool goes is unknown, so whether a move across cuts cannot be
// simulated. A machine that moves all axes at once goes along a slope. At the end of a
// program the slope is a remark, because many programs end so; before another cut it is
// an error.
void ReferenceMoves::depart(const Departure& departure)
{
    line_ = lines_.number();
    ++count_;
    if (!builder_.has_position() || !departure.moves_across || !departure.height_mm)
        return;
    const double height = *departure.height_mm;
    const double highest = builder_.highest_cut_mm();
    if (height > highest || (height == highest && !builder_.ends_with_cut()))
        return;
    const std::string place = " to a position of the machine at z " + brief(height) +
                              " mm, not above the cuts (up to z " + brief(highest) +
                              " mm)";
    if (!departure.moves_up)
        throw lines_.complaint("a sideways move" + place, "a move up before it");
    if (slanted_)
        return;
    slanted_text_ = "a move of all axes at once" + place;
    slanted_.emplace(lines_.complaint(slanted_text_ + ", and a cut after it",
                                      "a move up before it, such as G91 G28 Z0"));
}

void ReferenceMoves::stay_away()
{
    is_away_ = true;
    rise_over(builder_.position());
}

void ReferenceMoves::go_rapidly(const Vec3& target)
{
    if (std::exchange(is_away_, false))
        rise_over(target);
    if (!builder_.has_position() || target != builder_.position())
        builder_.go_to(target, std::nullopt);
}

void ReferenceMoves::rise_over(const Vec3& place)
{
    const Vec3 over{place.x(), place.y(), builder_.safe_height_mm()};
    if (over != builder_.position())
        builder_.go_at_safe_height(over);
}

void ReferenceMoves::check_cut() const
{
    if (slanted_)
        throw FormatError{*slanted_};
}

void ReferenceMoves::finish(std::string_view line) const
{
    if (slanted_)
        builder_.remark(slanted_text_ + " (" + std::string{line} + " " +
                        slanted_->place() + ")");
}

}  // namespace endmill
