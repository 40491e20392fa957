// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/gcode_interpreter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "endmill/core/parallel.h"
#include "endmill/core/text.h"
#include "endmill/post/detail/canned_cycle.h"
#include "endmill/post/detail/gcode_arc.h"
#include "endmill/post/detail/gcode_block.h"
#include "endmill/post/detail/gcode_modes.h"
#include "endmill/post/detail/gcode_remarks.h"
#include "endmill/post/detail/parsed_lines.h"
#include "endmill/post/detail/program_builder.h"
#include "endmill/post/detail/reference_moves.h"
#include "endmill/post/detail/rotary_words.h"
#include "endmill/post/detail/text_lines.h"

// Interpreter of a subset of RS-274. Several threads parse the lines ahead (ParsedLines), and
// one at a time executes them. Each line is handled in this order, which is that of
// the language:
// 1. `%`, the number of the program, and block delete,
// 2. words and comments (`parse_block`),
// 3. G codes (`GcodeModes::apply`), M codes (`check_m_codes`) and unused words
//    (`check_words`),
// 4. feed F, then spindle S, M3 to M5 and tool T, M6,
// 5. motion: straight, along an arc (`ArcReader`), a canned cycle (`CannedCycles`) or to a
//    reference position. It goes to the ProgramBuilder,
// 6. end of the program.
// The position of each axis is unknown until a block states it absolutely. Moves before
// the position of all three axes is known are counted and left out.
//
// Reference positions (G28, G30, G53) are known to the machine alone. The path rises
// straight to a safe height, and the position of the axes that move becomes unknown.
// Rapids that follow stay at the safe height until all positions are known again.

namespace endmill {
namespace {

constexpr std::array axis_letters{'X', 'Y', 'Z'};
constexpr int vertical = 2;  // index of the Z axis

// Lines are parsed in chunks of about this many bytes, and so many chunks at a time, which
// bounds the memory for words.
constexpr std::size_t chunk_bytes = std::size_t{1} << 15U;
constexpr std::size_t most_chunks = 64;

using MoveVisit = std::function<void(const GcodeMove&)>;

class GcodeInterpreter {
public:
    // Keeps the whole path, or with a `visit` the end of the path only.
    GcodeInterpreter(std::string_view text, const std::string& file,
                     const GcodeReadOptions& options, const MoveVisit& visit = {})
        : lines_{text, {file, "E_GCODE"}},
          options_{options},
          builder_{lines_, options_, visit ? KeptPoints::Last : KeptPoints::All},
          visit_{visit}
    {
    }

    Program read()
    {
        run();
        return builder_.take();
    }

    // Returns the number of points.
    std::size_t visit_moves()
    {
        run();
        return builder_.point_count();
    }

private:
    void run()
    {
        while (!has_ended_ && !lines_.rest().empty())
            read_chunks();
        require_path();
        references_.finish("line");
        remarks_.finish(modes_, has_ended_, builder_);
    }

    // Parses the next chunks, and executes each when those before it are executed.
    void read_chunks()
    {
        std::vector<std::string_view> chunks;
        for (std::string_view text = lines_.rest();
             !text.empty() && chunks.size() < most_chunks;
             text.remove_prefix(chunks.back().size()))
            chunks.push_back(text.substr(0, length_of_lines(text, chunk_bytes)));
        std::vector<std::optional<ParsedLines>> parsed(chunks.size());
        parallel_in_order(
            chunks.size(), [&](std::size_t i) { parsed[i].emplace(chunks[i]); },
            [&](std::size_t i) {
                for (std::size_t k = 0; k < parsed[i]->size() && !has_ended_; ++k)
                    read_next_line(*parsed[i], k);
                parsed[i].reset();
            });
    }

    void read_next_line(const ParsedLines& parsed, std::size_t k)
    {
        lines_.next();
        if (parsed.is_parsed(k))
            read_block(parsed.block(k));
        else
            read_line();
    }

    // A deleted block is not parsed, because it may contain machine-specific words.
    void read_line()
    {
        std::string_view text = without_indent(lines_.line());
        if (text.starts_with('%'))
            return read_percent(text);
        if (is_program_number(text))
            return read_program_number(text);
        if (text.starts_with('/')) {
            if (options_.block_delete)
                return;
            text.remove_prefix(1);
        }
        read_block(parse_block(text, lines_));
    }

    void read_block(const GcodeBlock& block)
    {
        const std::size_t first = builder_.point_count();
        arc_.reset();
        if (!block.is_empty())
            execute(block);
        if (visit_ && builder_.point_count() > first) {
            visit_({lines_.number(), first, builder_.point_count(), modes_, arc_});
            builder_.forget_points();
        }
    }

    // The first % may carry the number of the program. A program without a first % may end
    // with one. Some controls ignore words before the first %, others execute them, so
    // blocks on both sides of it are refused.
    void read_percent(std::string_view text)
    {
        const std::string_view rest = without_indent(text.substr(1));
        const bool is_first = !has_words_ && !has_percent_;
        if (!rest.empty() &&
            !(is_first && (is_comment(rest) || is_number_of_program(rest))))
            throw lines_.complaint(quoted(text), "a line with the % alone");
        if (has_words_ && !has_percent_ && !is_blank_tape(lines_.rest()))
            throw lines_.complaint(
                "a first % after blocks",
                "the first % before all blocks and the second at the end");
        has_ended_ = has_words_ || has_percent_;
        has_percent_ = true;
    }

    static bool is_blank_tape(std::string_view text)
    {
        return text.find_first_not_of(" \t\r\n%") == std::string_view::npos;
    }

    // Whether the line is "O1001" or ":1001", perhaps with a comment.
    static bool is_program_number(std::string_view text)
    {
        return (text.starts_with('O') || text.starts_with('o') ||
                text.starts_with(':')) &&
               is_number_of_program(text.substr(1));
    }

    // Whether the text is a whole number, perhaps with an O before and a comment after it.
    static bool is_number_of_program(std::string_view text)
    {
        if (text.starts_with('O') || text.starts_with('o'))
            text.remove_prefix(1);
        const std::size_t digits =
            std::min(text.find_first_not_of("0123456789"), text.size());
        const std::string_view rest = without_indent(text.substr(digits));
        return digits > 0 && (rest.empty() || is_comment(rest));
    }

    static bool is_comment(std::string_view text)
    {
        return text.starts_with('(') || text.starts_with(';');
    }

    // A number after blocks begins another program or a subprogram.
    void read_program_number(std::string_view text)
    {
        if (has_words_ || has_number_)
            throw lines_.complaint("a second program " + quoted(text),
                                   "one program in a file");
        const std::size_t comment = std::min(text.find_first_of("(;"), text.size());
        if (!parse_block(text.substr(comment), lines_).is_empty())
            throw lines_.complaint("words behind the program number " + quoted(text),
                                   "the number in a line of its own");
        has_number_ = true;
    }

    // Executes a block in the order of the language.
    // Source: [KramerProctorMessina, section 3.8].
    void execute(const GcodeBlock& block)
    {
        has_words_ = true;
        if (block.has('G'))
            change_modes(block);
        if (block.has('M')) {
            check_m_codes(block, lines_);
            remarks_.note_m_codes(block, lines_);
        }
        check_words(block, modes_, lines_);
        rotary_.check(block, lines_);
        if (!modes_.unit)
            remarks_.note_unstated_lengths(block);
        set_feed(block);
        set_spindle_and_tool(block);
        run_motion(block);
        if (known_axes_ > 0)
            modes_.use_coordinate_system();
        if (block.has('M'))
            end_program(block);
    }

    void change_modes(const GcodeBlock& block)
    {
        const GcodeModes before = modes_;
        modes_.apply(block, lines_);
        remarks_.note_modes(block, before, modes_, lines_, builder_);
        if (modes_.feed != before.feed)
            feed_.reset();
    }

    void run_motion(const GcodeBlock& block)
    {
        if (modes_.motion != GcodeMotion::Cycle)
            cycles_.end();
        if (const ReferenceMove reference = reference_move(block);
            reference != ReferenceMove::None)
            go_to_reference(block, reference);
        else if (is_cycle(block, modes_))
            run_cycle(block);
        else if (is_motion(block))
            move(block);
    }

    bool is_motion(const GcodeBlock& block) const
    {
        if (!block.has_any("XYZ") && !rotary_.moves(block))
            return is_arc(block, modes_);
        if (modes_.motion == GcodeMotion::None)
            throw lines_.complaint("axis word without a motion mode",
                                   "G0, G1, G2 or G3 in this block or before");
        return true;
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
        feed_ = MoveFeed{is_rate ? value * modes_.mm_per_unit() : value, modes_.feed,
                         modes_.mm_per_unit()};
    }

    void set_spindle_and_tool(const GcodeBlock& block)
    {
        set_spindle_speed(block);
        if (block.has('T'))
            builder_.select_tool(tool_number(block.value('T')));
        if (!block.has('M'))
            return;
        if (block.m.contains(6))
            builder_.change_tool();
        if (block.m.contains(3))
            builder_.start_spindle(SpindleSense::Clockwise);
        if (block.m.contains(4))
            builder_.start_spindle(SpindleSense::Counterclockwise);
        if (block.m.contains(5))
            builder_.stop_spindle();
    }

    // Under G96 the speed of the spindle is unknown, and beside G50 the word S is a limit.
    void set_spindle_speed(const GcodeBlock& block)
    {
        constexpr int limit_of_speed = 500;
        if (block.has('S') && block.value('S') < 0)
            throw lines_.complaint("a spindle speed S" + brief(block.value('S')),
                                   "S >= 0");
        if (modes_.has_surface_speed)
            builder_.set_spindle_speed(0);
        else if (block.has('S') && !block.g.contains(limit_of_speed))
            builder_.set_spindle_speed(block.value('S'));
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
                if (!is_blank_tape(lines_.rest()))
                    builder_.remark("text after M" + std::to_string(code) + " in line " +
                                    std::to_string(lines_.number()) + " is ignored");
            }
    }

    void move(const GcodeBlock& block)
    {
        const bool is_rapid = modes_.motion == GcodeMotion::Rapid;
        if (!is_rapid) {
            require_feed();
            require_start();
        }
        const Vec3 start = position_;
        for (int axis = 0; axis < 3; ++axis)
            move_axis(block, axis);
        turn_axes(block);
        if (is_known() && !builder_.has_position())
            note_unstated_axes();
        const bool along_arc = is_arc(block, modes_);
        const ArcReader arcs{block, modes_, lines_, options_.max_extent_mm};
        if (along_arc)
            arcs.check_words();
        if (!is_known())
            go_on_unknown(is_rapid);
        else if (!builder_.has_position())
            start_path(is_rapid);
        else if (references_.is_away())
            go_rapidly(position_);
        else if (along_arc)
            builder_.go_along(arc_.emplace(arcs.arc(start, position_)), *feed_);
        else
            builder_.go_to(position_, is_rapid ? std::nullopt : feed_);
    }

    void turn_axes(const GcodeBlock& block)
    {
        if (!rotary_.moves(block))
            return;
        if (references_.is_away())
            throw lines_.complaint(
                "a turn of a rotary axis after the reference move of line " +
                    std::to_string(references_.line()),
                "a rapid to X, Y and Z before it");
        rotary_.apply(block, modes_.distance);
        builder_.turn_to(rotary_.positions());
    }

    // Rotary words have no use beside codes that do not turn the axes to them.
    void refuse_turn(const GcodeBlock& block, const std::string& what) const
    {
        if (rotary_.moves(block))
            throw lines_.complaint("a rotary word beside " + what,
                                   "the word in a block with G0 to G3");
    }

    // The position of a rotary axis before its first word is a matter of the machine.
    void note_unstated_axes()
    {
        if (const std::string letters = rotary_.unstated_letters(); !letters.empty())
            builder_.remark("no position of " + letters +
                            " before the path begins: it is taken as 0");
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

    // After a move to a reference position, the start of a move at feed must be known.
    void require_start() const
    {
        if (references_.is_away())
            throw lines_.complaint(
                "a cut from an unknown position after the reference move of line " +
                    std::to_string(references_.line()),
                "a rapid to an absolute " + unknown_axes() + " before it");
        references_.check_cut();
    }

    bool is_known() const { return known_axes_ == 3; }

    // "X", "Y Z": axes whose position is unknown.
    std::string unknown_axes() const
    {
        std::string letters;
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (!is_axis_known_[axis])
                letters +=
                    (letters.empty() ? "" : " ") + std::string(1, axis_letters[axis]);
        return letters;
    }

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
        if (!is_rapid)
            remarks_.note_left_out(is_rapid);
        remarks_.note_start(lines_.number(), position_.z());
        builder_.go_to(position_, std::nullopt);
    }

    // A move to a position that is not known in all axes: left out before the path begins,
    // afterwards at the safe height.
    void go_on_unknown(bool is_rapid)
    {
        if (!builder_.has_position())
            return remarks_.note_left_out(is_rapid);
        Vec3 over = builder_.position();
        for (const int axis : {0, 1})
            if (is_axis_known_[static_cast<std::size_t>(axis)])
                over[axis] = position_[axis];
        references_.rise_over(over);
    }

    void go_rapidly(const Vec3& target)
    {
        if (!builder_.has_position())
            remarks_.note_start(lines_.number(), target.z());
        references_.go_rapidly(target);
    }

    // A program without a point of the path has no motion or no position.
    void require_path() const
    {
        if (builder_.has_position())
            return;
        const std::string lines = " in " + counted(lines_.number(), "line");
        if (remarks_.has_motion())
            throw FormatError{"E_GCODE",
                              {lines_.file(), "", "no absolute " + unknown_axes() + lines,
                               "a position of X, Y and Z before the first cut"}};
        throw FormatError{"E_GCODE",
                          {lines_.file(), "", "no motion" + lines,
                           "at least one G0, G1, G2 or G3 with coordinates"}};
    }

    // Words of G28 and G30 name a point to pass on the way, and the axes that move; without
    // words all axes move.
    void go_to_reference(const GcodeBlock& block, ReferenceMove reference)
    {
        refuse_turn(block, "G28, G30 or G53");
        const bool has_axes = block.has_any("XYZABC");
        if (reference == ReferenceMove::MachineCoordinates)
            check_machine_coordinates(has_axes);
        const bool moves_up = !has_axes || block.has('Z');
        const bool moves_across = !has_axes || block.has_any("XY");
        if (!moves_up)
            depart(moves_across, moves_up);
        if (reference == ReferenceMove::ReferencePoint && has_axes)
            pass_point(block);
        if (moves_up)
            depart(moves_across, moves_up);
        remarks_.note_reference(block, lines_);
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (!has_axes || block.has(axis_letters[axis]))
                forget(axis);
        if (!builder_.has_position() || is_known())
            return;
        references_.stay_away();
    }

    void depart(bool moves_across, bool moves_up)
    {
        const bool is_height_known = is_axis_known_[vertical];
        references_.depart(
            {.height_mm = is_height_known ? std::optional{position_.z()} : std::nullopt,
             .moves_across = moves_across,
             .moves_up = moves_up});
    }

    void check_machine_coordinates(bool has_axes) const
    {
        if (!has_axes)
            throw lines_.complaint("G53 without X, Y and Z", "an axis word");
        if (modes_.motion != GcodeMotion::Rapid)
            throw lines_.complaint("a move in machine coordinates (G53) without G0",
                                   "G0, a rapid");
        if (modes_.distance == DistanceMode::Incremental)
            throw lines_.complaint("G53 under G91", "G90");
    }

    // The point of G28 or G30, which is a rapid in coordinates of the program.
    void pass_point(const GcodeBlock& block)
    {
        for (int axis = 0; axis < 3; ++axis)
            move_axis(block, axis);
        if (is_known())
            go_rapidly(position_);
        else if (builder_.has_position())
            go_on_unknown(true);
    }

    void forget(std::size_t axis)
    {
        known_axes_ -= is_axis_known_[axis] ? 1 : 0;
        is_axis_known_[axis] = false;
    }

    void run_cycle(const GcodeBlock& block)
    {
        refuse_turn(block, "a canned cycle");
        require_feed();
        if (feed_->mode == FeedRateMode::InverseTime)
            throw lines_.complaint("a canned cycle under G93", "G94");
        require_hole(block);
        const CannedCycle cycle =
            cycles_.next(block, modes_, position_, builder_.room(), lines_);
        references_.check_cut();
        remarks_.note_cycle(modes_, builder_);
        const int normal = cycle.axes.normal;
        if (cycle.begins_at_r && builder_.has_position() && !references_.is_away()) {
            position_[normal] = cycle.r;
            go_rapidly(position_);
        }
        position_ = cycle.first_hole;
        for (std::size_t hole = 0; hole < cycle.holes; ++hole) {
            if (hole > 0)
                position_ += cycle.step;
            position_[normal] = hole == 0 ? cycle.approach : cycle.clear;
            drill(cycle);
        }
        is_axis_known_ = {true, true, true};
        known_axes_ = 3;
    }

    // The moves of one hole. Moves without length make no points.
    void drill(const CannedCycle& cycle)
    {
        double& level = position_[cycle.axes.normal];
        go_rapidly(position_);
        level = cycle.r;
        go_rapidly(position_);
        for (const HoleMove& move : cycle.hole) {
            level = move.level;
            if (move.is_reversed)
                builder_.note_tapping();
            if (!move.is_feed)
                go_rapidly(position_);
            else if (position_ != builder_.position())
                builder_.go_to(position_, feed_);
        }
    }

    // The level before a cycle must be known, and the position of the hole in the plane.
    void require_hole(const GcodeBlock& block) const
    {
        const int normal = plane_axes(modes_.plane).normal;
        const bool is_increment = modes_.distance == DistanceMode::Incremental;
        for (const int axis : {0, 1, 2}) {
            const auto index = static_cast<std::size_t>(axis);
            const bool is_stated =
                axis != normal && !is_increment && block.has(axis_letters[index]);
            if (is_axis_known_[index] || is_stated)
                continue;
            if (references_.is_away())
                require_start();
            throw lines_.complaint(
                std::string{"a canned cycle from an unknown position"},
                std::string{"an absolute "} + axis_letters[index] + " before it");
        }
    }

    TextLines lines_;
    GcodeReadOptions options_;
    ProgramBuilder builder_;
    GcodeModes modes_;
    CannedCycles cycles_;
    ReferenceMoves references_{builder_, lines_};
    RotaryWords rotary_{options_.rotary};
    GcodeRemarks remarks_;
    std::optional<MoveFeed> feed_;
    Vec3 position_ = Vec3::Zero();  // of the programmed point, mm
    std::array<bool, 3> is_axis_known_ = {};
    int known_axes_ = 0;
    bool has_percent_ = false;
    bool has_number_ = false;
    bool has_words_ = false;
    bool has_ended_ = false;
    MoveVisit visit_;         // empty: none
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
    std::vector<GcodeMove> moves;
    for_each_gcode_move(text, file, options,
                        [&](const GcodeMove& move) { moves.push_back(move); });
    return moves;
}

std::size_t for_each_gcode_move(std::string_view text, const std::string& file,
                                const GcodeReadOptions& options, const MoveVisit& visit)
{
    return GcodeInterpreter{text, file, options, visit}.visit_moves();
}

}  // namespace endmill
