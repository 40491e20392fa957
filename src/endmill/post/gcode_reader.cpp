// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/gcode_reader.h"

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

namespace endmill {
namespace {

constexpr std::array axis_letters{'X', 'Y', 'Z'};

class GcodeReader {
public:
    GcodeReader(std::string_view text, const std::string& file,
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
    // A deleted block is not even looked at: it may hold what only a machine understands.
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

    // Words before a first % are a leader to some controls and the program to others.
    void read_percent(std::string_view text)
    {
        if (!without_indent(text.substr(1)).empty())
            throw lines_.complaint(quoted(text), "a % alone in its line");
        if (has_words_ && !has_percent_)
            throw lines_.complaint("a first % after blocks",
                                   "it before all blocks, and another at the end");
        has_ended_ = has_percent_;
        has_percent_ = true;
    }

    // Source of the order: [KramerProctorMessina, "Order of Execution"].
    void execute(const GcodeBlock& block)
    {
        has_words_ = true;
        const GcodeModes before = modes_;
        modes_.apply(block, lines_);
        check_m_codes(block, lines_);
        check_words(block, modes_, lines_);
        note_modes(block, before);
        if (modes_.inverse_time != before.inverse_time)
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

    // What is said once, at its first occurrence: remarks must not grow with the file.
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
            builder_.remark("coordinate system first named in line " +
                            std::to_string(lines_.number()) +
                            ", after motion: taken as the one before");
        if (modes_.used_tool_length && !before.used_tool_length)
            builder_.remark(
                (block.has('H') ? "G43 H" + brief(block.value('H'))
                                : std::string{"G43"}) +
                ": the tool length is taken as already in the control's tool table");
    }

    // F > 0 is asked for where a move needs it; many programs begin with F0.
    void set_feed(const GcodeBlock& block)
    {
        if (modes_.inverse_time)
            feed_.reset();  // it holds for its block only
        if (!block.has('F'))
            return;
        const double value = block.value('F');
        if (value < 0)
            throw lines_.complaint("a feed F" + brief(value), "F > 0");
        feed_ = modes_.inverse_time ? MoveFeed{value, true}
                                    : MoveFeed{value * modes_.mm_per_unit(), false};
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
                    builder_.remark("what follows M" + std::to_string(code) +
                                    " in line " + std::to_string(lines_.number()) +
                                    " is not read");
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
        const ArcReader arcs{block, modes_, lines_, options_};
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
            throw lines_.complaint(modes_.inverse_time
                                       ? "no F in a block under G93"
                                       : "a move at cutting feed before any F",
                                   "F > 0");
        if (!(feed_->value > 0))
            throw lines_.complaint("a move at feed F0", "F > 0");
    }

    bool is_known() const { return known_axes_ == 3; }

    // An increment from an unknown place leads to an unknown place.
    void move_axis(const GcodeBlock& block, int axis)
    {
        const char letter = axis_letters[axis];
        if (!block.has(letter))
            return;
        if (modes_.incremental && !is_axis_known_[axis]) {
            check_extent(length(block, letter), options_, lines_);
            return;
        }
        position_[axis] =
            length(block, letter) + (modes_.incremental ? position_[axis] : 0);
        check_extent(position_[axis], options_, lines_);
        known_axes_ += is_axis_known_[axis] ? 0 : 1;
        is_axis_known_[axis] = true;
    }

    double length(const GcodeBlock& block, char letter) const
    {
        return block.value(letter) * modes_.mm_per_unit();
    }

    // The first point says where the path begins; nothing is cut on the way to it.
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
            builder_.remark("all motion is left out: not every axis is given a position");
        else
            builder_.remark("the path begins in line " + std::to_string(start_line_) +
                            ", where every axis has been given; left out: " +
                            counted(moves_left_out_, "move"));
    }

    void remark_on_modes()
    {
        if (modes_.used_blending)
            builder_.remark("G64: a control may round corners, which is not followed");
    }

    TextLines lines_;
    GcodeReadOptions options_;
    ProgramBuilder builder_;
    GcodeModes modes_;
    std::optional<MoveFeed> feed_;
    Vec3 position_ = Vec3::Zero();  // of the programmed point, mm
    std::array<bool, 3> is_axis_known_ = {};
    int known_axes_ = 0;
    std::size_t moves_left_out_ =
        0;                        // with the one to the path's first point, if it cuts
    std::size_t start_line_ = 0;  // 0 before the path has begun
    std::size_t first_unit_line_ = 0;  // of the first G20 or G21 after lengths, 0 if none
    bool has_unsaid_lengths_ = false;
    bool has_inches_ = false;
    bool has_percent_ = false;
    bool has_words_ = false;
    bool has_ended_ = false;
    bool keeps_moves_ = false;
    std::vector<GcodeMove> moves_;
    std::optional<Arc> arc_;  // of the line
};

}  // namespace

Program parse_gcode(std::string_view text, const std::string& file,
                    const GcodeReadOptions& options)
{
    return GcodeReader{text, file, options}.read();
}

std::vector<GcodeMove> gcode_moves(std::string_view text, const std::string& file,
                                   const GcodeReadOptions& options)
{
    return GcodeReader{text, file, options}.read_moves();
}

}  // namespace endmill
