// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/block_writer.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/post/detail/plain_number.h"

namespace endmill {
namespace {

constexpr std::array<std::string_view, 4> motion_words{"G0", "G1", "G2", "G3"};

std::string_view plane_word(ArcPlane plane)
{
    switch (plane) {
        case ArcPlane::Zx:
            return "G18";
        case ArcPlane::Yz:
            return "G19";
        case ArcPlane::Xy:
            break;
    }
    return "G17";
}

}  // namespace

void BlockWriter::add_line(std::string_view text)
{
    line_begin_ = text_.size();
    text_ += text;
    end_line();
}

void BlockWriter::add_block(std::string_view words)
{
    begin_block();
    add_word(words);
    end_block();
}

bool BlockWriter::add_move(Motion motion, const Vec3& tip, std::optional<double> feed)
{
    begin_block();
    add_motion(motion);
    const std::size_t axes_begin = text_.size();
    Vec3 rounded;
    for (int c = 0; c < 3; ++c)
        rounded[c] = add_axis("XYZ"[c], tip[c], tip_[c]);
    if (text_.size() == axes_begin) {
        text_.resize(line_begin_);
        return false;
    }
    motion_ = motion;
    tip_ = rounded;
    add_feed(feed);
    add_speed();
    end_block();
    return true;
}

bool BlockWriter::add_machine_move(Motion motion, const Vec3& xyz,
                                   std::span<const RotaryWord> rotary,
                                   std::optional<double> feed)
{
    begin_block();
    add_motion(motion);
    const std::size_t axes_begin = text_.size();
    Vec3 rounded;
    for (int c = 0; c < 3; ++c)
        rounded[c] = add_axis("XYZ"[c], xyz[c], tip_[c]);
    for (const RotaryWord& word : rotary)
        add_angle(word, false);
    if (text_.size() == axes_begin) {
        text_.resize(line_begin_);
        return false;
    }
    motion_ = motion;
    tip_ = rounded;
    if (feed && feed_meaning_ == BlockFeed::InverseTime)
        add_inverse_time(*feed);
    else
        add_feed(feed);
    add_speed();
    end_block();
    return true;
}

void BlockWriter::add_rotary_rapid(std::span<const RotaryWord> rotary)
{
    if (rotary.empty())
        return;
    begin_block();
    add_motion(Motion::Rapid);
    motion_ = Motion::Rapid;
    for (const RotaryWord& word : rotary)
        add_angle(word, true);
    end_block();
}

void BlockWriter::set_feed_meaning(BlockFeed meaning)
{
    if (meaning == feed_meaning_)
        return;
    feed_meaning_ = meaning;
    feed_ = unknown;
    add_block(meaning == BlockFeed::InverseTime ? "G93" : "G94");
}

void BlockWriter::add_arc(const Arc& arc, std::optional<double> radius,
                          std::optional<double> feed)
{
    begin_block();
    if (plane_ != arc.plane)
        add_word(plane_word(arc.plane));
    plane_ = arc.plane;
    const Motion motion = arc.clockwise ? Motion::Clockwise : Motion::Counterclockwise;
    add_motion(motion);
    motion_ = motion;
    const Vec3 from = tip();
    const int normal = plane_axes(arc.plane).normal;
    for (int c = 0; c < 3; ++c)
        if (c != normal)
            tip_[c] = add_axis("XYZ"[c], arc.end[c], unknown);
    if (radius)
        add_number('R', *radius);
    else
        for (int c = 0; c < 3; ++c)
            if (c != normal)
                add_number("IJK"[c], arc.centre[c] - from[c]);
    add_feed(feed);
    add_speed();
    end_block();
}

void BlockWriter::add_level_rapid(const Vec3& place)
{
    begin_block();
    add_motion(Motion::Rapid);
    motion_ = Motion::Rapid;
    for (int c = 0; c < 2; ++c)
        tip_[c] = add_axis("XY"[c], place[c], unknown);
    end_block();
}

void BlockWriter::add_rise(double height, std::string_view words)
{
    begin_block();
    add_motion(Motion::Rapid);
    if (!words.empty())
        add_word(words);
    motion_ = Motion::Rapid;
    tip_.z() = add_axis('Z', height, unknown);
    end_block();
}

void BlockWriter::start_spindle()
{
    begin_block();
    add_speed();
    add_word("M3");
    end_block();
}

void BlockWriter::forget_position()
{
    motion_.reset();
    tip_ = Vec3::Constant(unknown);
}

// Writes the block number. If the block remains empty, add_move removes this text again;
// the number is counted only in end_block.
void BlockWriter::begin_block()
{
    line_begin_ = text_.size();
    if (format_.line_numbers)
        text_ += 'N' +
                 std::to_string(
                     blocks_ % static_cast<std::size_t>(format_.largest_line_number) + 1);
}

void BlockWriter::end_block()
{
    end_line();
    ++blocks_;
}

void BlockWriter::end_line()
{
    const std::size_t length = text_.size() - line_begin_;
    if (format_.longest_line && length > *format_.longest_line)
        throw DomainError{"line " + std::to_string(lines_ + 1) + " of the program has " +
                          counted(length, "character") + "; expected at most " +
                          std::to_string(*format_.longest_line) +
                          " for this control (use fewer --decimals)"};
    text_ += format_.line_end;
    ++lines_;
}

// Separates words by a blank, for readability only.
void BlockWriter::add_word(std::string_view word)
{
    if (text_.size() > line_begin_)
        text_ += ' ';
    text_ += word;
}

void BlockWriter::add_motion(Motion motion)
{
    if (motion != motion_)
        add_word(motion_words[static_cast<std::size_t>(motion)]);
}

// Appends a word with a length, and returns its rounded number in units of the program.
double BlockWriter::add_number(char letter, double mm)
{
    add_word({&letter, 1});
    const double rounded = append_fixed(text_, mm / format_.unit_mm, format_.decimals);
    if (format_.decimals == 0)
        add_point_sign();
    return rounded;
}

// Appends the word of an axis, unless its rounded number is in force. Returns that
// number, in units of the program.
double BlockWriter::add_axis(char letter, double mm, double in_force)
{
    const std::size_t begin = text_.size();
    const double rounded = add_number(letter, mm);
    max_rounding_error_ =
        std::max(max_rounding_error_, std::abs(rounded * format_.unit_mm - mm));
    if (rounded == in_force)
        text_.resize(begin);
    return rounded;
}

// Appends the word of a rotary axis, unless its rounded number is in force.
void BlockWriter::add_angle(const RotaryWord& word, bool is_needed)
{
    double& in_force = angles_[static_cast<std::size_t>(word.letter - 'A')];
    const std::size_t begin = text_.size();
    add_word({&word.letter, 1});
    const double rounded = append_fixed(text_, word.degrees, format_.angle_decimals);
    if (format_.angle_decimals == 0)
        add_point_sign();
    if (!is_needed && rounded == in_force)
        text_.resize(begin);
    in_force = rounded;
}

void BlockWriter::add_inverse_time(double per_min)
{
    constexpr int significant_digits = 6;
    add_word("F");
    const std::size_t begin = text_.size();
    if (!(append_rounded_down(text_, per_min, significant_digits) > 0))
        throw DomainError{"a move takes too long: its inverse time F rounds to 0"};
    if (text_.find('.', begin) == std::string::npos)
        add_point_sign();
}

// Appends F, unless its rounded number is in force.
void BlockWriter::add_feed(std::optional<double> feed)
{
    if (!feed)
        return;
    const std::size_t begin = text_.size();
    add_word("F");
    const std::size_t number_begin = text_.size();
    const double rounded =
        append_trimmed(text_, *feed / format_.unit_mm, format_.decimals);
    if (text_.find('.', number_begin) == std::string::npos)
        add_point_sign();
    if (rounded == feed_)
        text_.resize(begin);
    feed_ = rounded;
}

// Appends S, unless there is no speed or its rounded number is in force.
void BlockWriter::add_speed()
{
    if (std::isnan(wanted_speed_))
        return;
    const std::size_t begin = text_.size();
    add_word("S");
    const double rounded = append_trimmed(
        text_, wanted_speed_, format_.speed_decimals.value_or(format_.decimals));
    if (rounded == speed_)
        text_.resize(begin);
    speed_ = rounded;
}

void BlockWriter::add_point_sign()
{
    if (format_.always_point)
        text_ += '.';
}

}  // namespace endmill
