// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "endmill/machine/kinematics.h"
#include "endmill/post/detail/gcode_block.h"
#include "endmill/post/detail/gcode_modes.h"
#include "endmill/post/detail/text_lines.h"
#include "endmill/post/program.h"

namespace endmill {

/// The number of a rotary axis in a program after a word.
/// \param wrap how the word leads to a position. \param word degrees, as written.
/// \param is_negative whether the word has a minus sign, for -0. \param now degrees, the
///        number before.
/// \return degrees.
/// \pre Signed: |word| < 360.
double unwrapped_word(RotaryWrap wrap, double word, bool is_negative, double now);

/// The numbers of the rotary words of a program, from block to block. They begin at 0.
class RotaryWords {
public:
    /// \param reading the machine; without it every word must be 0. Must outlive this.
    explicit RotaryWords(const std::optional<RotaryReading>& reading);

    /// Whether rotary words move axes.
    bool is_read() const { return reading_.has_value(); }

    /// Whether the block moves a rotary axis of the machine.
    bool moves(const GcodeBlock& block) const;

    /// Checks the rotary words of a block.
    /// \throws FormatError at the current line of `lines` for a word other than 0 without a
    ///         machine, of an axis that the machine lacks, or out of its range.
    void check(const GcodeBlock& block, const TextLines& lines) const;

    /// Applies the rotary words of a block that moves.
    void apply(const GcodeBlock& block, DistanceMode mode);

    /// Sets the number of an axis, in degrees. \pre the machine has the axis
    void set(char letter, double degrees);

    /// Whether the machine has an axis with this capital letter.
    bool has_axis(char letter) const { return axis_of(letter).has_value(); }

    /// rad, positions of the axes.
    RotaryPositions positions() const;

    /// The letters of the axes of the machine, "A and C"; "no rotary axes".
    std::string letters() const;

    /// The letters of the axes that have had no word yet; empty if there are none.
    std::string unstated_letters() const;

private:
    std::optional<std::size_t> axis_of(char letter) const;

    const std::optional<RotaryReading>& reading_;
    std::array<double, 2> degrees_{0, 0};
    std::array<bool, 2> is_stated_{false, false};
};

}  // namespace endmill
