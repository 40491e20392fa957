// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "endmill/core/vec.h"

namespace endmill {

/// Kind of a straight motion in RS-274.
enum class Motion {
    Rapid,  ///< G0
    Feed    ///< G1
};

/// Format of blocks.
struct BlockFormat {
    int decimals = 4;  ///< digits after the point of every number, 0 to 9
    /// Whether blocks are numbered N1 to N99999, then N1 again.
    bool line_numbers = false;
};

/// Writes the blocks of a program. G0, G1, X, Y, Z, F and S are written only where the
/// rounded number differs from the one in force. All functions throw DomainError for a
/// number that is not finite.
class BlockWriter {
public:
    /// Begins a program without blocks.
    explicit BlockWriter(BlockFormat format) : format_{format} {}

    /// Adds an unnumbered line that is not a block: % or a comment.
    void add_line(std::string_view text);

    /// Adds a block with the given words.
    void add_block(std::string_view words);

    /// Adds a move of the tip.
    /// \param motion rapid or at feed.
    /// \param tip end of the move, mm.
    /// \param feed mm/min.
    /// \return false if no rounded coordinate changes; then nothing is written.
    bool add_move(Motion motion, const Vec3& tip, std::optional<double> feed);

    /// Adds a rapid to `height` (mm) along z, which is written even if the height is in
    /// force.
    void add_rise(double height);

    /// Sets the spindle speed in rpm, which is written with the next block that needs it.
    void set_speed(double rpm) { wanted_speed_ = rpm; }

    /// Adds the block that starts the spindle clockwise at the speed set.
    void start_spindle();

    /// Makes the next move write its motion and all its axes.
    void forget_position();

    const Vec3& tip() const { return tip_; }  ///< mm, rounded; NaN before the first move
    double max_rounding_error_mm() const { return max_rounding_error_; }  ///< mm
    std::size_t lines() const { return lines_; }  ///< number of lines so far
    std::string& text() { return text_; }         ///< all lines, each with its line feed

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
    std::size_t block_begin_ = 0;  // position in text_
    std::optional<Motion> motion_;
    Vec3 tip_ = Vec3::Constant(unknown);
    double feed_ = unknown;
    double speed_ = unknown;
    double wanted_speed_ = unknown;
    double max_rounding_error_ = 0;
};

}  // namespace endmill
