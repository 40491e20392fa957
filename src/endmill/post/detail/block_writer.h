// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "endmill/core/vec.h"

namespace endmill {

/// A motion of RS-274 in a straight line.
enum class Motion { Rapid, Feed };

/// How blocks are spelled.
struct BlockFormat {
    int decimals = 4;           ///< of every number, 0 to 9
    bool line_numbers = false;  ///< N1 to N99999, then N1 again
};

/// Appends blocks to a program: G0, G1, X, Y, Z, F and S only where their number, once
/// rounded, is not the one in force. All of it throws DomainError for a number that is not
/// finite.
class BlockWriter {
public:
    /// Of a program without blocks so far.
    explicit BlockWriter(BlockFormat format) : format_{format} {}

    /// A line without a number that is no block: % or a comment.
    void add_line(std::string_view text);

    /// A block of `words`, as they stand.
    void add_block(std::string_view words);

    /// A move of the tip, in mm, to `tip`.
    /// \param feed in mm/min.
    /// \return false if no axis moves: then nothing is written.
    bool add_move(Motion motion, const Vec3& tip, std::optional<double> feed);

    /// A rapid of the height alone, in mm, wherever the tool stands.
    void add_rise(double height);

    /// From the next block on the spindle turns at `rpm`.
    void set_speed(double rpm) { wanted_speed_ = rpm; }

    /// The block that starts the spindle clockwise, at the speed set.
    void start_spindle();

    /// The next move says its motion and all axes.
    void forget_position();

    const Vec3& tip() const { return tip_; }  ///< in mm, rounded; NaN before the first
    double max_rounding_error_mm() const { return max_rounding_error_; }  ///< of an axis
    std::size_t lines() const { return lines_; }                          ///< so far
    std::string& text() { return text_; }  ///< of all lines, each with its line feed

private:
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    void begin_block();
    void end_block();
    void add_word(std::string_view word);
    void add_motion(Motion motion);
    double add_axis(char letter, double value, double in_force);
    void add_modal(char letter, double value, double& in_force);

    BlockFormat format_;
    std::string text_;
    std::size_t lines_ = 0;
    std::size_t blocks_ = 0;
    std::size_t block_begin_ = 0;  // in text_
    std::optional<Motion> motion_;
    Vec3 tip_ = Vec3::Constant(unknown);
    double feed_ = unknown;
    double speed_ = unknown;
    double wanted_speed_ = unknown;
    double max_rounding_error_ = 0;
};

}  // namespace endmill
