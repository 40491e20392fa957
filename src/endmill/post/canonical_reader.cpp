// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/gcode_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "endmill/core/angle.h"
#include "endmill/core/detail/units.h"
#include "endmill/core/text.h"
#include "endmill/post/detail/arc.h"
#include "endmill/post/detail/canonical_line.h"
#include "endmill/post/detail/canonical_tapping.h"
#include "endmill/post/detail/gcode_arc.h"
#include "endmill/post/detail/idle_commands.h"
#include "endmill/post/detail/plain_number.h"
#include "endmill/post/detail/program_builder.h"
#include "endmill/post/detail/program_frame.h"
#include "endmill/post/detail/reference_moves.h"
#include "endmill/post/detail/rotary_words.h"
#include "endmill/post/detail/text_lines.h"

// Every line of canonical output is one command with arguments, already resolved by the
// interpreter. The reader
// 1. splits the line into the name and the arguments,
// 2. calls the handler of the name: motions go to the ProgramBuilder, settings change the
//    state,
// 3. passes over commands that cannot move the tool, and refuses unknown ones.
// Coordinates do not include the offsets of the interpreter. The path is in the coordinates
// of its first move; later moves are converted where the offsets have changed since.
// Coordinates far outside of every machine stand for positions that only the machine knows.

namespace endmill {
namespace {

constexpr double half_last_decimal =
    5e-5;  // of four decimals, in the unit of the program

class CanonicalReader {
public:
    CanonicalReader(std::string_view text, const std::string& file,
                    const GcodeReadOptions& options)
        : lines_{text, {file, "E_CANONICAL"}},
          options_{options},
          builder_{lines_, options_}
    {
    }

    Program read()
    {
        while (!has_ended_ && lines_.next())
            read_line();
        if (!has_ended_)
            builder_.remark("no PROGRAM_END: the program may be cut short");
        begin_path();
        if (!builder_.has_position())
            throw FormatError{
                "E_CANONICAL",
                {lines_.file(), "", "no motion in " + counted(lines_.number(), "line"),
                 "at least one STRAIGHT_TRAVERSE, STRAIGHT_FEED or "
                 "ARC_FEED"}};
        references_.finish("output of rs274, line");
        if (references_.count() > 0)
            builder_.remark("moves to positions of the machine (G28, G30, G53): " +
                            std::to_string(references_.count()) +
                            "; each is taken as a rapid straight up, to 5 mm above all "
                            "points before it");
        Program program = builder_.take();
        program.position_error_mm = error_mm_;
        return program;
    }

private:
    using Handler = void (CanonicalReader::*)();
    using FarAxes = std::array<bool, 3>;

    void read_line()
    {
        if (without_indent(lines_.line()).empty())
            return;
        const auto line = canonical_line(lines_.line());
        if (!line)
            throw lines_.complaint(quoted(lines_.line()),
                                   "a line of rs274 -g, as \"12 N..... NAME(...)\"");
        name_ = line->name;
        arguments_ = line->arguments;
        if (const Handler handler = handler_of(name_))
            (this->*handler)();
        else if (!is_idle_command(name_))
            throw lines_.complaint("canonical command " + quoted(name_),
                                   "a straight move, an arc or a command without motion");
        hole_.note(name_);
    }

    // The handler of a command, or null.
    static Handler handler_of(std::string_view name)
    {
        static constexpr std::array<std::pair<std::string_view, Handler>, 20> handlers{{
            {"STRAIGHT_FEED", &CanonicalReader::straight_feed},
            {"ARC_FEED", &CanonicalReader::arc_feed},
            {"STRAIGHT_TRAVERSE", &CanonicalReader::straight_traverse},
            {"SET_FEED_RATE", &CanonicalReader::set_feed_rate},
            {"SET_FEED_MODE", &CanonicalReader::set_feed_mode},
            {"SELECT_PLANE", &CanonicalReader::select_plane},
            {"USE_LENGTH_UNITS", &CanonicalReader::use_length_units},
            {"SET_G5X_OFFSET", &CanonicalReader::set_g5x_offset},
            {"SET_G92_OFFSET", &CanonicalReader::set_g92_offset},
            {"SET_XY_ROTATION", &CanonicalReader::set_xy_rotation},
            {"USE_TOOL_LENGTH_OFFSET", &CanonicalReader::use_tool_length_offset},
            {"SET_SPINDLE_SPEED", &CanonicalReader::set_spindle_speed},
            {"START_SPINDLE_CLOCKWISE", &CanonicalReader::start_clockwise},
            {"START_SPINDLE_COUNTERCLOCKWISE", &CanonicalReader::start_counterclockwise},
            {"STOP_SPINDLE_TURNING", &CanonicalReader::stop_spindle},
            {"SET_SPINDLE_MODE", &CanonicalReader::set_spindle_mode},
            {"SELECT_TOOL", &CanonicalReader::select_tool},
            {"CHANGE_TOOL", &CanonicalReader::change_tool},
            {"CHANGE_TOOL_NUMBER", &CanonicalReader::change_tool_number},
            {"PROGRAM_END", &CanonicalReader::end_program},
        }};
        for (const auto& [known, handler] : handlers)
            if (known == name)
                return handler;
        return nullptr;
    }

    // The next argument as a number.
    double number()
    {
        const auto argument = take_argument(arguments_);
        const auto value = argument ? plain_number(*argument) : std::nullopt;
        if (!value)
            throw lines_.complaint(argument ? quoted(*argument) : "too few arguments",
                                   "a plain decimal number");
        return *value;
    }

    // The next argument as a length in mm.
    double length() { return number() * mm_per_unit_; }

    // The next argument as a word; empty if there is none.
    std::string_view word()
    {
        const auto argument = take_argument(arguments_);
        return argument ? *argument : std::string_view{};
    }

    // The remaining arguments of an offset are those of rotary axes, which must be 0.
    void expect_no_rotation()
    {
        while (!without_indent(arguments_).empty())
            if (number() != 0)
                throw lines_.complaint("an offset of a rotary axis",
                                       "rotary words without offsets");
    }

    // The remaining arguments of a move are A, B and C in degrees, then U, V and W, which
    // must be 0.
    void take_rotation()
    {
        for (const char letter : std::string_view{"ABCUVW"}) {
            if (without_indent(arguments_).empty())
                break;
            const double degrees = number();
            if (rotary_.has_axis(letter))
                rotary_.set(letter, degrees);
            else if (degrees != 0)
                refuse_rotation(letter);
        }
        if (rotary_.is_read())
            builder_.turn_to(rotary_.positions());
    }

    [[noreturn]] void refuse_rotation(char letter) const
    {
        if (!rotary_.is_read())
            throw lines_.complaint(
                "a turned rotary axis",
                "the machine of the program (--machine and --frame), or "
                "no turns");
        throw lines_.complaint(std::string{"a turned axis "} + letter,
                               "turns of " + rotary_.letters());
    }

    void straight_traverse() { go_straight(std::nullopt); }

    void straight_feed() { go_straight(feed()); }

    void go_straight(const std::optional<MoveFeed>& feed)
    {
        const double x = length();
        const double y = length();
        const double z = length();
        take_rotation();
        const FarAxes far = far_axes({x, y, z});
        if (feed) {
            check_cut(far);
            begin_path();
        }
        if (far != FarAxes{})
            return go_away({x, y, z}, far);
        far_ = far;
        position_ = in_path({x, y, z});
        if (feed || !shows_machine_positions())
            builder_.go_to(position_, feed);
        else
            go_rapidly();
        note_precision();
    }

    bool shows_machine_positions() const
    {
        return std::isfinite(options_.machine_position_mm);
    }

    // The axes whose coordinate is a position of the machine.
    FarAxes far_axes(const Vec3& point) const
    {
        FarAxes far = {};
        for (std::size_t axis = 0; axis < far.size(); ++axis)
            far[axis] =
                std::abs(point[static_cast<int>(axis)]) > options_.machine_position_mm;
        return far;
    }

    void check_cut(const FarAxes& far) const
    {
        if (far != FarAxes{} || far_ != FarAxes{} || references_.is_away())
            throw lines_.complaint(
                "a cut from or to a position of the machine (G28, G30, G53)",
                "a rapid to X, Y and Z of the part before it");
        references_.check_cut();
    }

    // The interpreter passes a point before each G28 and G30. As the first motion that is
    // where the interpreter begins, at 0, 0, 0, so the first rapid waits for the next
    // move.
    void go_rapidly()
    {
        if (!builder_.has_position() && !start_) {
            start_ = position_;
            return;
        }
        begin_path();
        references_.go_rapidly(position_);
    }

    // Adds the first rapid.
    void begin_path()
    {
        if (start_)
            builder_.go_to(*std::exchange(start_, std::nullopt), std::nullopt);
    }

    // A rapid to a place of which some axes are positions of the machine.
    void go_away(const Vec3& point, const FarAxes& far)
    {
        if (frame_.rotation_degrees != 0)
            throw lines_.complaint("a position of the machine in a turned system",
                                   "G28, G30 and G53 without a rotation");
        start_.reset();
        const auto leaves = [&](std::size_t axis) { return far[axis] && !far_[axis]; };
        const bool has_left = leaves(0) || leaves(1) || leaves(2);
        if (has_left)
            references_.depart(
                {.height_mm = far_[2] ? std::nullopt : std::optional{position_.z()},
                 .moves_across = leaves(0) || leaves(1),
                 .moves_up = leaves(2)});
        far_ = far;
        position_ = in_path(point);
        if (!builder_.has_position())
            return;
        if (has_left)
            references_.stay_away();
        Vec3 over = builder_.position();
        for (const int axis : {0, 1})
            if (!far[static_cast<std::size_t>(axis)])
                over[axis] = position_[axis];
        references_.rise_over(over);
    }

    void arc_feed()
    {
        check_cut({});
        begin_path();
        const PlaneAxes axes = plane_axes(plane_);
        Arc arc{.start = position_, .end = {}, .centre = {}, .plane = plane_};
        arc.end[axes.first] = length();
        arc.end[axes.second] = length();
        arc.centre[axes.first] = length();
        arc.centre[axes.second] = length();
        const double rotation = number();
        arc.end[axes.normal] = length();
        arc.centre[axes.normal] = arc.end[axes.normal];
        take_rotation();
        arc.end = in_path(arc.end);
        arc.centre = in_path(arc.centre);
        if (plane_ != ArcPlane::Xy && frame_.rotation_degrees != first_.rotation_degrees)
            throw lines_.complaint("an arc across a turned coordinate system",
                                   "an arc in the XY plane (G17)");
        if (rotation == 0 || rotation != std::floor(rotation))
            throw lines_.complaint("an arc of " + brief(rotation) + " turns",
                                   "a whole number, negative if clockwise");
        arc.clockwise = rotation < 0;
        arc.turns = std::abs(rotation);
        go_along(arc);
        note_precision();
    }

    // The output states positions only by moves, so the start of an arc before the first
    // move is unknown. That arc is left out; its end begins the path.
    void go_along(const Arc& arc)
    {
        const MoveFeed pace = feed();
        position_ = arc.end;
        if (!builder_.has_position()) {
            builder_.remark(
                "the first motion is an arc: its start is unknown, and it is left out");
            builder_.go_to(position_, std::nullopt);
            return;
        }
        for (const double coordinate : arc.centre)
            check_extent(coordinate, options_.max_extent_mm, lines_);
        for (const double coordinate : arc.end)
            check_extent(coordinate, options_.max_extent_mm, lines_);
        check_radii(arc, lines_);
        builder_.go_along(arc, pace);
    }

    MoveFeed feed() const
    {
        if (!(feed_mm_per_min_ > 0))
            throw lines_.complaint("a move at feed before any feed rate",
                                   "SET_FEED_RATE above 0");
        return {feed_mm_per_min_, FeedRateMode::PerMinute, mm_per_unit_};
    }

    void note_precision()
    {
        if (!is_unit_said_)
            builder_.remark("no USE_LENGTH_UNITS before motion: lengths are taken as mm");
        error_mm_ =
            std::max(error_mm_, half_last_decimal * mm_per_unit_ + turning_error());
    }

    // mm, by which the rounding of the angles may move the tip: that of each angle times the
    // distance of the tip from the axes.
    double turning_error() const
    {
        if (!options_.rotary)
            return 0;
        const PartOnMachine& setup = options_.rotary->setup;
        const Machine& machine = setup.machine;
        const double reach = (position_ - machine.table_offset).norm() +
                             std::abs(machine.pivot + setup.tool_length) +
                             2 * machine.axis_offset.norm();
        return static_cast<double>(machine.configuration.rotary.size()) * reach *
               Angle::degrees(half_last_decimal).radians();
    }

    // The rate is in the unit in force. Under G93 the interpreter prints one rate per
    // move.
    void set_feed_rate()
    {
        const double rate = length();
        if (!(rate >= 0 && std::isfinite(rate)))
            throw lines_.complaint("feed rate " + brief(rate),
                                   "a feed rate of at least 0");
        feed_mm_per_min_ = rate;
    }

    // Arguments: spindle and mode. Earlier releases print the mode alone.
    void set_feed_mode()
    {
        double mode = number();
        if (!without_indent(arguments_).empty())
            mode = number();
        if (mode != 0)
            throw lines_.complaint("feed per revolution", "feed per minute");
    }

    void select_plane()
    {
        const std::string_view name = word();
        if (name == "CANON_PLANE_XY")
            plane_ = ArcPlane::Xy;
        else if (name == "CANON_PLANE_XZ")
            plane_ = ArcPlane::Zx;
        else if (name == "CANON_PLANE_YZ")
            plane_ = ArcPlane::Yz;
        else
            throw lines_.complaint("plane " + quoted(name), "CANON_PLANE_XY, _XZ or _YZ");
    }

    void use_length_units()
    {
        const std::string_view name = word();
        if (name != "CANON_UNITS_MM" && name != "CANON_UNITS_INCHES")
            throw lines_.complaint("unit " + quoted(name),
                                   "CANON_UNITS_MM or CANON_UNITS_INCHES");
        is_unit_said_ = true;
        mm_per_unit_ = name == "CANON_UNITS_MM" ? 1 : mm_per_inch;
    }

    void set_g5x_offset()
    {
        number();  // number of the coordinate system
        frame_.system_offset = offset();
    }

    void set_g92_offset() { frame_.axis_offset = offset(); }

    void set_xy_rotation() { frame_.rotation_degrees = number(); }

    // The remaining arguments as an offset of X, Y and Z. Those of rotary axes must be 0.
    Vec3 offset()
    {
        const double x = length();
        const double y = length();
        const double z = length();
        expect_no_rotation();
        for (const double coordinate : {x, y, z})
            check_extent(coordinate, options_.max_extent_mm, lines_);
        return {x, y, z};
    }

    // The point in the coordinates of the path, which are those of its first move.
    Vec3 in_path(const Vec3& point)
    {
        if (!builder_.has_position() && !start_)
            first_ = frame_;
        if (frame_ != first_)
            builder_.remark(
                "offsets change after the first move: the path is in the coordinates of "
                "its first move");
        return moved_to_frame(point, frame_, first_);
    }

    // The numbers are separated by blanks and commas. The handler only checks whether all
    // are 0.
    void use_tool_length_offset()
    {
        if (arguments_.find_first_of("123456789") != std::string_view::npos)
            builder_.remark(
                "the tool length is assumed to be in the control's tool table already");
    }

    // Arguments: spindle and speed. Earlier releases print the speed alone.
    void set_spindle_speed()
    {
        double speed = number();
        if (!without_indent(arguments_).empty())
            speed = number();
        builder_.set_spindle_speed(has_surface_speed_ ? 0 : std::abs(speed));
    }

    void start_clockwise()
    {
        start_spindle(SpindleSense::Clockwise, SpindleSense::Counterclockwise);
    }
    void start_counterclockwise()
    {
        start_spindle(SpindleSense::Counterclockwise, SpindleSense::Clockwise);
    }

    // A tapping cycle reverses the spindle for one move, which is no M3 or M4 of the
    // program. Until its end the spindle counts as turning in the sense of the program.
    void start_spindle(SpindleSense sense, SpindleSense opposite)
    {
        const bool is_tapping = reverses_for_tapping(hole_, name_, lines_.rest());
        if (is_tapping)
            builder_.note_tapping();
        builder_.start_spindle(is_tapping ? opposite : sense);
    }
    void stop_spindle() { builder_.stop_spindle(); }

    // Arguments: spindle and highest speed, without a comma. 0 means constant spindle
    // speed (G97), another number constant surface speed (G96).
    void set_spindle_mode()
    {
        const std::size_t blank = arguments_.find(' ');
        has_surface_speed_ =
            arguments_.find_first_of("123456789", blank) != std::string_view::npos;
        if (!has_surface_speed_)
            return;
        builder_.set_spindle_speed(0);
        builder_.remark("constant surface speed: the path has no spindle speed under it");
    }

    int tool_number()
    {
        const double tool = number();
        if (!(tool >= 0 && tool <= std::numeric_limits<int>::max() &&
              tool == std::floor(tool)))
            throw lines_.complaint("tool " + brief(tool), "a whole number from 0");
        return static_cast<int>(tool);
    }

    void select_tool() { builder_.select_tool(tool_number()); }

    // M61 states the tool in the spindle.
    void change_tool_number() { builder_.change_tool(tool_number()); }

    // The argument is the tool's pocket in the changer, not its number.
    void change_tool() { builder_.change_tool(); }

    void end_program() { has_ended_ = true; }

    TextLines lines_;
    GcodeReadOptions options_;
    ProgramBuilder builder_;
    ReferenceMoves references_{builder_, lines_};
    RotaryWords rotary_{options_.rotary};
    TappedHole hole_;
    std::string_view name_;         // of the command in the current line
    std::string_view arguments_;    // of the current line, not yet read
    Vec3 position_ = Vec3::Zero();  // of the programmed point, mm
    std::optional<Vec3> start_;     // the first rapid, until the next move
    FarAxes far_ = {};              // of the last position
    ArcPlane plane_ = ArcPlane::Xy;
    double feed_mm_per_min_ = 0;
    double mm_per_unit_ = 1;
    double error_mm_ = half_last_decimal;
    ProgramFrame frame_;  // in force
    ProgramFrame first_;  // at the first move
    bool has_surface_speed_ = false;
    bool is_unit_said_ = false;
    bool has_ended_ = false;
};

}  // namespace

bool is_canonical(std::string_view text)
{
    constexpr std::size_t longest = 4096;  // bytes of the first line that are examined
    text = without_indent(text).substr(0, longest);
    return canonical_line(text.substr(0, text.find('\n'))).has_value();
}

Program parse_canonical(std::string_view text, const std::string& file,
                        const GcodeReadOptions& options)
{
    return CanonicalReader{text, file, options}.read();
}

}  // namespace endmill
