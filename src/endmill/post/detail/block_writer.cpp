// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/block_writer.h"

#include <algorithm>
#include <cmath>

#include "endmill/post/detail/plain_number.h"

namespace endmill {
namespace {

// Numbers start again at N1 after this one: controls read five digits, and the language
// does not require different numbers.
constexpr std::size_t line_numbers = 99999;

}  // namespace

void BlockWriter::add_line(std::string_view text)
{
    text_ += text;
    text_ += '\n';
    ++lines_;
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
        text_.resize(block_begin_);
        return false;
    }
    motion_ = motion;
    tip_ = rounded;
    if (feed)
        add_modal('F', *feed, feed_);
    add_modal('S', wanted_speed_, speed_);
    end_block();
    return true;
}

void BlockWriter::add_rise(double height)
{
    begin_block();
    add_motion(Motion::Rapid);
    motion_ = Motion::Rapid;
    tip_.z() = add_axis('Z', height, unknown);
    end_block();
}

void BlockWriter::start_spindle()
{
    begin_block();
    add_modal('S', wanted_speed_, speed_);
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
    block_begin_ = text_.size();
    if (format_.line_numbers)
        text_ += 'N' + std::to_string(blocks_ % line_numbers + 1);
}

void BlockWriter::end_block()
{
    text_ += '\n';
    ++lines_;
    ++blocks_;
}

// Separates words by a blank, for readability only.
void BlockWriter::add_word(std::string_view word)
{
    if (text_.size() > block_begin_)
        text_ += ' ';
    text_ += word;
}

void BlockWriter::add_motion(Motion motion)
{
    if (motion != motion_)
        add_word(motion == Motion::Rapid ? "G0" : "G1");
}

// Appends the word of an axis, unless its rounded number is in force. Returns that
// number.
double BlockWriter::add_axis(char letter, double value, double in_force)
{
    const std::size_t begin = text_.size();
    add_word({&letter, 1});
    const double rounded = append_fixed(text_, value, format_.decimals);
    max_rounding_error_ = std::max(max_rounding_error_, std::abs(rounded - value));
    if (rounded == in_force)
        text_.resize(begin);
    return rounded;
}

// Appends a modal word, unless its rounded number is in force. NaN stands for no number.
void BlockWriter::add_modal(char letter, double value, double& in_force)
{
    if (std::isnan(value))
        return;
    const std::size_t begin = text_.size();
    add_word({&letter, 1});
    const double rounded = append_trimmed(text_, value, format_.decimals);
    if (rounded == in_force)
        text_.resize(begin);
    in_force = rounded;
}

}  // namespace endmill
