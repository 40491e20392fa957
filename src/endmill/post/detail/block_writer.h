// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "endmill/core/vec.h"
#include "endmill/post/control.h"
#include "endmill/post/detail/arc.h"

namespace endmill {

/// Kind of a motion in RS-274.
enum class Motion {
    Rapid,            ///< G0
    Feed,             ///< G1
    Clockwise,        ///< G2
    Counterclockwise  ///< G3
};

/// Format of blocks.
struct BlockFormat {
    int decimals = 4;  ///< digits after the point of coordinates and feeds, 0 to 9
    /// Whether blocks are numbered N1 to the largest line number, then N1 again.
    bool line_numbers = false;
    double unit_mm = 1;                      ///< mm, length of one unit of the program
    std::optional<int> speed_decimals = {};  ///< of S; none: as `decimals`
    bool always_point = false;  ///< whether a number without fraction ends in a point
    std::string_view line_end = "\n";              ///< LF or CR LF
    int largest_line_number = 99999;               ///< at least 1
    std::optional<std::size_t> longest_line = {};  ///< characters without the line end
    int angle_decimals = 5;  ///< digits after the point of rotary words, 0 to 9
};

/// A word of a rotary axis.
struct RotaryWord {
    char letter;     ///< 'A', 'B' or 'C'
    double degrees;  ///< its number
};

/// Meaning of the feed of a block.
enum class BlockFeed {
    PerMinute,   ///< G94: mm/min
    InverseTime  ///< G93: 1/min, in every block
};

/// Writes the blocks of a program. G0 to G3, the plane, X, Y, Z, F and S are written only
/// where the rounded number differs from the one in force; an arc has both axes of its
/// plane. All functions throw DomainError for a number that is not finite and for a line
/// that is too long.
class BlockWriter {
public:
    /// Begins a program without blocks.
    explicit BlockWriter(BlockFormat format) : format_{format} {}

    /// Adds an unnumbered line that is not a block: % or a comment.
    void add_line(std::string_view text);

    /// Adds a block with the given words.
    void add_block(std::string_view words);

    /// Adds a straight move of the tip.
    /// \param motion rapid or at feed.
    /// \param tip end of the move, mm.
    /// \param feed mm/min.
    /// \return false if no rounded coordinate changes; then nothing is written.
    bool add_move(Motion motion, const Vec3& tip, std::optional<double> feed);

    /// Adds a straight move of X, Y, Z and rotary axes.
    /// \param xyz end of the move, mm.
    /// \param rotary words of the rotary axes at the end.
    /// \param feed mm/min, or 1/min in a block of inverse time, which is rounded down to
    ///        six significant digits.
    /// \return false if no rounded word changes; then nothing is written.
    bool add_machine_move(Motion motion, const Vec3& xyz,
                          std::span<const RotaryWord> rotary, std::optional<double> feed);

    /// Adds a rapid of the rotary axes alone, which are written even if they are in force.
    void add_rotary_rapid(std::span<const RotaryWord> rotary);

    /// Sets the meaning of the next feeds, by a block of its own where it changes. The first
    /// blocks of a program have feeds per minute.
    void set_feed_meaning(BlockFeed meaning);

    /// Adds an arc from the tip in force.
    /// \param arc end, centre, plane and sense; its start is the tip in force.
    /// \param radius mm; if given, the block has R instead of I, J, K.
    /// \param feed mm/min.
    void add_arc(const Arc& arc, std::optional<double> radius,
                 std::optional<double> feed);

    /// Adds a rapid of X and Y alone to those of `place` (mm), which are written even if
    /// they are in force.
    void add_level_rapid(const Vec3& place);

    /// Adds a rapid to `height` (mm) along z, which is written even if the height is in
    /// force.
    /// \param words put before the height, such as "G43 H1"; may be empty.
    void add_rise(double height, std::string_view words = {});

    /// Sets the spindle speed in rpm, which is written with the next block that needs it.
    void set_speed(double rpm) { wanted_speed_ = rpm; }

    /// Adds the block that starts the spindle clockwise at the speed set.
    void start_spindle();

    /// Makes the next move write its motion and all its axes.
    void forget_position();

    /// The tip in mm, rounded; NaN before the first move of an axis.
    Vec3 tip() const { return tip_ * format_.unit_mm; }
    double max_rounding_error_mm() const { return max_rounding_error_; }  ///< mm
    std::size_t lines() const { return lines_; }  ///< number of lines so far
    std::string& text() { return text_; }         ///< all lines, each with its line end

private:
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    void begin_block();
    void end_block();
    void end_line();
    void add_word(std::string_view word);
    void add_motion(Motion motion);
    double add_number(char letter, double mm);
    double add_axis(char letter, double mm, double in_force);
    void add_angle(const RotaryWord& word, bool is_needed);
    void add_feed(std::optional<double> feed);
    void add_inverse_time(double per_min);
    void add_speed();
    void add_point_sign();

    BlockFormat format_;
    std::string text_;
    std::size_t lines_ = 0;
    std::size_t blocks_ = 0;
    std::size_t line_begin_ = 0;  // position in text_
    std::optional<Motion> motion_;
    std::optional<ArcPlane> plane_;
    Vec3 tip_ = Vec3::Constant(unknown);                       // in units of the program
    std::array<double, 3> angles_{unknown, unknown, unknown};  // of A, B, C, degrees
    BlockFeed feed_meaning_ = BlockFeed::PerMinute;
    double feed_ = unknown;
    double speed_ = unknown;
    double wanted_speed_ = unknown;
    double max_rounding_error_ = 0;
};

}  // namespace endmill
