// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/gcode_interpreter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "endmill/core/text.h"
#include "endmill/post/detail/gcode_arc.h"
#include "endmill/post/detail/gcode_block.h"
#include "endmill/post/detail/gcode_modes.h"
#include "endmill/post/detail/program_builder.h"
#include "endmill/post/detail/text_lines.h"

// Interpreter of a subset of RS-274. Each line is handled in this order, which is that of
// the language:
// 1. `%` and block delete,
// 2. words and comments (`parse_block`),
// 3. G codes (`GcodeModes::apply`), M codes (`check_m_codes`) and unused words
//    (`check_words`),
// 4. feed F, then spindle S, M3 to M5 and tool T, M6,
// 5. motion, straight or along an arc (`ArcReader`), which goes to the ProgramBuilder,
// 6. end of the program.
// The position of each axis is unknown until a block states it absolutely. Moves before
// the position of all three axes is known are counted and left out.

namespace endmill {
namespace {

constexpr std::array axis_letters{'X', 'Y', 'Z'};

class GcodeInterpreter {
public:
    GcodeInterpreter(std::string_view text, const std::string& file,
                     const GcodeReadOptions& options)
        : lines_{text, {file, "E_GCODE"}},
          options_{options},
          builder_{lines_, options_}
    {
    }

    Program read()
    {
        while (!has_ended_ && lines_.next())
            read_line();
        remark_on_end();
        remark_on_units();
        remark_on_start();
        remark_on_modes();
        return builder_.take();
    }

    std::vector<GcodeMove> read_moves()
    {
        keeps_moves_ = true;
        read();
        return std::move(moves_);
    }

private:
    // A deleted block is not parsed, because it may contain machine-specific words.
    void read_line()
    {
        std::string_view text = without_indent(lines_.line());
        if (text.starts_with('%'))
            return read_percent(text);
        if (text.starts_with('/')) {
            if (options_.block_delete)
                return;
            text.remove_prefix(1);
        }
        const GcodeBlock block = parse_block(text, lines_);
        const std::size_t first = builder_.point_count();
        arc_.reset();
        if (!block.is_empty())
            execute(block);
        if (keeps_moves_ && builder_.point_count() > first)
            moves_.push_back(
                {lines_.number(), first, builder_.point_count(), modes_, arc_});
    }

    // Some controls ignore words before the first %, others execute them, so such words
    // are refused.
    void read_percent(std::string_view text)
    {
        if (!without_indent(text.substr(1)).empty())
            throw lines_.complaint(quoted(text), "a line with the % alone");
        if (has_words_ && !has_percent_)
            throw lines_.complaint(
                "a first % after blocks",
                "the first % before all blocks and the second at the end");
        has_ended_ = has_percent_;
        has_percent_ = true;
    }

    // Executes a block in the order of the language.
    // Source: [KramerProctorMessina, section 3.8].
    void execute(const GcodeBlock& block)
    {
        has_words_ = true;
        const GcodeModes before = modes_;
        modes_.apply(block, lines_);
        check_m_codes(block, lines_);
        check_words(block, modes_, lines_);
        note_modes(block, before);
        if (modes_.feed != before.feed)
            feed_.reset();
        set_feed(block);
        set_spindle_and_tool(block);
        if (is_motion(block))
            move(block);
        end_program(block);
    }

    bool is_motion(const GcodeBlock& block) const
    {
        if (!block.has_any("XYZ"))
            return is_arc(block, modes_);
        if (modes_.motion == GcodeMotion::None)
            throw lines_.complaint("axis word without a motion mode",
                                   "G0, G1, G2 or G3 in this block or before");
        return true;
    }

    // Makes the remarks on modes. Each is made once, at its first occurrence, so that the
    // number of remarks does not grow with the file.
    void note_modes(const GcodeBlock& block, const GcodeModes& before)
    {
        const bool has_length = block.has_any("XYZIJKRF");
        if (modes_.unit == GcodeUnit::Unsaid)
            has_unsaid_lengths_ = has_unsaid_lengths_ || has_length;
        else if (before.unit == GcodeUnit::Unsaid && has_unsaid_lengths_)
            first_unit_line_ = lines_.number();
        has_inches_ = has_inches_ || modes_.unit == GcodeUnit::Inch;
        if (modes_.coordinate_system != before.coordinate_system &&
            builder_.has_position())
            builder_.remark(
                "coordinate system first named in line " +
                std::to_string(lines_.number()) +
                ", after motion: taken as the system of the motion before it");
        if (modes_.used_tool_length && !before.used_tool_length)
            builder_.remark(
                (block.has('H') ? "G43 H" + brief(block.value('H'))
                                : std::string{"G43"}) +
                ": the tool length is assumed to be in the control's tool table already");
    }

    // F0 is accepted here, because many programs begin with it. `require_feed` checks F >
    // 0 where a move needs it.
    void set_feed(const GcodeBlock& block)
    {
        if (modes_.feed == FeedRateMode::InverseTime)
            feed_.reset();  // an inverse-time feed is valid for its block only
        if (!block.has('F'))
            return;
        const double value = block.value('F');
        if (value < 0)
            throw lines_.complaint("a feed F" + brief(value), "F > 0");
        const bool is_rate = modes_.feed == FeedRateMode::PerMinute;
        feed_ = MoveFeed{is_rate ? value * modes_.mm_per_unit() : value, modes_.feed};
    }

    void set_spindle_and_tool(const GcodeBlock& block)
    {
        if (block.has('S')) {
            if (block.value('S') < 0)
                throw lines_.complaint("a spindle speed S" + brief(block.value('S')),
                                       "S >= 0");
            builder_.set_spindle_speed(block.value('S'));
        }
        if (block.has('T'))
            builder_.select_tool(tool_number(block.value('T')));
        if (block.m.contains(6))
            builder_.change_tool();
        if (block.m.contains(3) || block.m.contains(4))
            builder_.start_spindle();
        if (block.m.contains(5))
            builder_.stop_spindle();
    }

    int tool_number(double value) const
    {
        if (!(value >= 0 && value <= std::numeric_limits<int>::max() &&
              value == std::floor(value)))
            throw lines_.complaint("a tool T" + brief(value), "a whole number from 0");
        return static_cast<int>(value);
    }

    void end_program(const GcodeBlock& block)
    {
        for (const int code : {2, 30})
            if (block.m.contains(code)) {
                has_ended_ = true;
                if (lines_.rest().find_first_not_of(" \t\r\n%") != std::string_view::npos)
                    builder_.remark("text after M" + std::to_string(code) + " in line " +
                                    std::to_string(lines_.number()) + " is ignored");
            }
    }

    void move(const GcodeBlock& block)
    {
        const bool is_rapid = modes_.motion == GcodeMotion::Rapid;
        if (!is_rapid)
            require_feed();
        const bool was_known = is_known();
        const Vec3 start = position_;
        for (int axis = 0; axis < 3; ++axis)
            move_axis(block, axis);
        const bool along_arc = is_arc(block, modes_);
        const ArcReader arcs{block, modes_, lines_, options_.max_extent_mm};
        if (along_arc)
            arcs.check_words();
        if (!is_known())
            ++moves_left_out_;
        else if (!was_known)
            start_path(is_rapid);
        else if (along_arc)
            builder_.go_along(arc_.emplace(arcs.arc(start, position_)), *feed_);
        else
            builder_.go_to(position_, is_rapid ? std::nullopt : feed_);
    }

    void require_feed() const
    {
        if (!feed_)
            throw lines_.complaint(modes_.feed == FeedRateMode::InverseTime
                                       ? "no F in a block under G93"
                                       : "a move at feed before any F",
                                   "F > 0");
        if (!(feed_->value > 0))
            throw lines_.complaint("a move at feed F0", "F > 0");
    }

    bool is_known() const { return known_axes_ == 3; }

    // An increment from an unknown position leaves the position unknown.
    void move_axis(const GcodeBlock& block, int axis)
    {
        const char letter = axis_letters[axis];
        if (!block.has(letter))
            return;
        const bool is_increment = modes_.distance == DistanceMode::Incremental;
        if (is_increment && !is_axis_known_[axis]) {
            check_extent(length(block, letter), options_.max_extent_mm, lines_);
            return;
        }
        position_[axis] = length(block, letter) + (is_increment ? position_[axis] : 0);
        check_extent(position_[axis], options_.max_extent_mm, lines_);
        known_axes_ += is_axis_known_[axis] ? 0 : 1;
        is_axis_known_[axis] = true;
    }

    double length(const GcodeBlock& block, char letter) const
    {
        return block.value(letter) * modes_.mm_per_unit();
    }

    // Begins the path at the current position. The move to it starts at an unknown
    // position, so a move at feed counts as left out.
    void start_path(bool is_rapid)
    {
        moves_left_out_ += is_rapid ? 0 : 1;
        start_line_ = lines_.number();
        builder_.go_to(position_, std::nullopt);
    }

    void remark_on_end()
    {
        if (!has_ended_)
            builder_.remark("no M2, M30 or closing %: the program may be cut short");
    }

    void remark_on_units()
    {
        if (has_inches_)
            builder_.remark("inches (G20) converted to mm");
        if (modes_.unit == GcodeUnit::Unsaid)
            builder_.remark("neither G20 nor G21: lengths are taken as mm");
        else if (first_unit_line_ != 0)
            builder_.remark("no G20 or G21 before line " +
                            std::to_string(first_unit_line_) +
                            ": lengths before it are taken as mm");
    }

    void remark_on_start()
    {
        if (moves_left_out_ == 0)
            return;
        if (start_line_ == 0)
            builder_.remark(
                "all motion is left out: the program does not give every axis a "
                "position");
        else
            builder_.remark(
                "the path begins in line " + std::to_string(start_line_) +
                ", where the position of every axis is known; left out before it: " +
                counted(moves_left_out_, "move"));
    }

    void remark_on_modes()
    {
        if (modes_.used_blending)
            builder_.remark(
                "G64: a control may round corners, which the path does not show");
    }

    TextLines lines_;
    GcodeReadOptions options_;
    ProgramBuilder builder_;
    GcodeModes modes_;
    std::optional<MoveFeed> feed_;
    Vec3 position_ = Vec3::Zero();  // of the programmed point, mm
    std::array<bool, 3> is_axis_known_ = {};
    int known_axes_ = 0;
    std::size_t moves_left_out_ = 0;  // including the move to the first point, if at feed
    std::size_t start_line_ = 0;      // line of the first point, 0 before it
    std::size_t first_unit_line_ =
        0;  // of the first G20 or G21 after a length, 0 if none
    bool has_unsaid_lengths_ = false;
    bool has_inches_ = false;
    bool has_percent_ = false;
    bool has_words_ = false;
    bool has_ended_ = false;
    bool keeps_moves_ = false;
    std::vector<GcodeMove> moves_;
    std::optional<Arc> arc_;  // of the current line
};

}  // namespace

Program interpreted_gcode(std::string_view text, const std::string& file,
                          const GcodeReadOptions& options)
{
    return GcodeInterpreter{text, file, options}.read();
}

std::vector<GcodeMove> gcode_moves(std::string_view text, const std::string& file,
                                   const GcodeReadOptions& options)
{
    return GcodeInterpreter{text, file, options}.read_moves();
}

}  // namespace endmill
