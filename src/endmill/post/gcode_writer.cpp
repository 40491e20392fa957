// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/gcode_writer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/post/detail/arc_fitting.h"
#include "endmill/post/detail/block_writer.h"
#include "endmill/post/detail/move_conditions.h"
#include "endmill/post/detail/plain_number.h"
#include "endmill/post/detail/program_heading.h"
#include "endmill/post/detail/ramp_entry.h"
#include "endmill/post/detail/rapid_approach.h"

// A program is written in three parts: start (%, comment, modes, path control), one block
// per move or arc, and end (retract, M5, M30, %). BlockWriter omits words that repeat the
// value in force. A change of tool, including the first one, adds T and M6, the start of
// the spindle and the way over the next point. The ends of rapid descents and the points
// of slopes are points of the path before the writer sees it.

namespace endmill {
namespace {

// Memory reserved per point. A block that moves all three axes has about this length.
constexpr std::size_t likely_bytes_per_point = 34;

// The lowest height with the default clearance above all moves at feed and not below a
// rapid of the path. Rapids need no clearance, because the path already uses their
// height. A program that is read and written again therefore starts no higher than
// before.
double default_safe_height(const ToolPath& path)
{
    double height = path.points.front().location.tip.z();
    for (const PathPoint& point : path.points)
        height =
            std::max(height, point.location.tip.z() +
                                 (point.move == Move::Rapid ? 0 : default_clearance_mm));
    return height;
}

// The safe height as it will be written, so that its rounding does not count as an error
// of the path.
double safe_height(const ToolPath& path, const GcodeOptions& options)
{
    const double unit = millimetres_per(options.unit);
    const double wanted = options.safe_height.value_or(default_safe_height(path));
    std::string spelled;
    const double height =
        append_fixed(spelled, wanted / unit, decimals_of(options)) * unit;
    if (!options.safe_height)
        return height;
    double top = path.points.front().location.tip.z();
    for (const PathPoint& point : path.points)
        top = std::max(top, point.location.tip.z());
    if (*options.safe_height < top)
        throw DomainError{"gcode: the safe height " + to_text(*options.safe_height) +
                          " mm lies below the path, which reaches " + to_text(top) +
                          " mm"};
    return height;
}

// "G64 P" with half the tolerance: the control may round corners by that much.
std::string path_control_of_tolerance(const GcodeOptions& options)
{
    if (!options.tolerance)
        return "G64";
    require(*options.tolerance >= 0, "gcode: need a tolerance from 0");
    return blending_block(options, *options.tolerance / 2);
}

// The block of the path control; empty if the control has none.
std::string path_control(const GcodeOptions& options)
{
    switch (options.control.path_control) {
        case PathControl::Exact:
            return "G61";
        case PathControl::None:
            return "";
        case PathControl::Tolerance:
            break;
    }
    return path_control_of_tolerance(options);
}

std::string shown(const Vec3& vector)
{
    return to_text(vector.x()) + ", " + to_text(vector.y()) + ", " + to_text(vector.z());
}

void require_upright(const ToolPath& path)
{
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        const Vec3& axis = path.points[i].location.axis;
        require(axis.allFinite(), "gcode: an axis must be finite");
        if (axis != Vec3::UnitZ())
            throw GeometryError{"the axis at point " + std::to_string(i) +
                                " of the path is " + shown(axis) +
                                ", and a 3-axis machine cannot turn the tool; expected "
                                "0, 0, 1 throughout"};
    }
}

void require_possible(const GcodeOptions& options)
{
    require_sound(options.control);
    require(0 <= decimals_of(options) && decimals_of(options) <= most_decimals,
            "gcode: need 0 to 9 decimals");
    require(std::isfinite(options.dwell_s) && options.dwell_s >= 0,
            "gcode: need a dwell from 0");
    const auto require_word = [&](bool has_it, const std::string& what) {
        if (!has_it)
            throw DomainError{"gcode: the control " + options.control.name + " has no " +
                              what + "; expected a control that has it, or none of it"};
    };
    require_word(options.dwell_s == 0 || options.control.dwell, "dwell");
    require_word(!options.arc_tolerance || options.control.arcs != ArcForm::None, "arcs");
    require(!options.arc_tolerance ||
                (std::isfinite(*options.arc_tolerance) && *options.arc_tolerance > 0),
            "gcode: need an arc tolerance above 0");
}

MoveConditions conditions_of(const ToolPath& path, const GcodeOptions& options)
{
    const int decimals = decimals_of(options);
    return {path,
            {options.feed_mm_per_min, options.spindle_rpm, options.tool},
            {decimals, options.control.speed_decimals.value_or(decimals),
             millimetres_per(options.unit)}};
}

// Checks what only the points of the path as it is given can name.
void require_possible_moves(const ToolPath& path, const GcodeOptions& options)
{
    const Control& control = options.control;
    const bool names_tool = control.tool_change || control.tool_length;
    MoveConditions conditions = conditions_of(path, options);
    std::optional<int> tool;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        const std::optional<int> before = std::exchange(tool, conditions.at(i).tool);
        if (names_tool && tool == 0)
            throw DomainError{"point " + std::to_string(i) +
                              " of the path has tool 0, which is no tool in a program; "
                              "expected a number from 1 (--tool-number)"};
        if (!control.tool_change && before && before != tool)
            throw DomainError{"the path changes from tool " + std::to_string(*before) +
                              " to tool " + std::to_string(*tool) + " at point " +
                              std::to_string(i) + ", and the control " + control.name +
                              " has no tool change; expected one tool"};
    }
}

// Length of an arc in mm. Its plane holds the whole arc.
double arc_length(const Arc& arc)
{
    const ArcRadii radii = arc_radii(arc);
    return arc_angle(arc) * (radii.start + radii.end) / 2;
}

// Writes the blocks of a program.
class ProgramWriter {
public:
    ProgramWriter(const ToolPath& path, const GcodeOptions& options, double height)
        : path_{path},
          options_{options},
          coolant_{coolant_word(options)},
          conditions_{conditions_of(path, options)},
          blocks_{block_format(options)}
    {
        program_.safe_height_mm = height;
        blocks_.text().reserve(path.points.size() * likely_bytes_per_point);
    }

    // \param first the place over which the tool starts.
    WrittenProgram write(const Vec3& first)
    {
        write_start(blocks_, options_, path_control(options_));
        add_moves(first);
        retract();
        write_end(blocks_, options_);
        program_.decimals = decimals_of(options_);
        program_.lines = blocks_.lines();
        program_.max_rounding_error_mm = blocks_.max_rounding_error_mm();
        program_.feed_mm_per_min = conditions_.feeds();
        program_.plunge_feed_mm_per_min = conditions_.plunge_feeds();
        program_.spindle_rpm = conditions_.speeds();
        program_.totals = totals_.totals();
        if (options_.ramp)
            program_.straight_descents = returns_;
        program_.text = std::move(blocks_.text());
        return std::move(program_);
    }

private:
    void add_moves(const Vec3& first)
    {
        for (std::size_t i = 0; i < path_.points.size(); ++i) {
            const CuttingConditions conditions = conditions_.at(i);
            if (conditions.tool != tool_)
                change_tool(i, conditions, first);
            else if (const auto arc = arc_to(i, conditions)) {
                add_arc(*arc, i, conditions);
                i = arc->last;
                continue;
            }
            add_point(i, conditions);
        }
    }

    // \param point index of the first point that the arc replaces.
    void add_arc(const FittedArc& arc, std::size_t point,
                 const CuttingConditions& conditions)
    {
        blocks_.add_arc(arc.arc, arc.radius, conditions.feed_mm_per_min);
        ++program_.arcs;
        program_.max_arc_error_mm = std::max(program_.max_arc_error_mm, arc.error_mm);
        for (; point < arc.last; ++point)
            totals_.add(Move::Cut, path_.points[point].location.tip, {}, 0);
        count(Move::Cut, conditions, arc_length(arc.arc));
    }

    // Adds the block before to the totals. Before all axes have a position, the length
    // of a move is unknown.
    // \param length mm; none: a straight move.
    void count(Move move, const CuttingConditions& conditions,
               std::optional<double> length = {})
    {
        const Vec3 tip = blocks_.tip();
        CuttingConditions named = conditions;
        if (!options_.control.tool_change)
            named.tool.reset();
        if (position_)
            totals_.add(move, tip, named, length.value_or((tip - *position_).norm()));
        else
            totals_.start(tip, named.tool);
        position_ = tip;
    }

    // The arc from the point before `point`, if one is wanted and possible.
    std::optional<FittedArc> arc_to(std::size_t point,
                                    const CuttingConditions& conditions)
    {
        if (!options_.arc_tolerance || path_.points[point].move != Move::Cut)
            return std::nullopt;
        if (conditions.spindle_rpm)
            blocks_.set_speed(*conditions.spindle_rpm);
        for (run_end_ = std::max(run_end_, point + 1);
             run_end_ < path_.points.size() && continues_run(run_end_, conditions);)
            ++run_end_;
        return longest_arc(path_, point - 1, run_end_,
                           {*options_.arc_tolerance, options_.control.arcs,
                            decimals_of(options_), millimetres_per(options_.unit)});
    }

    bool continues_run(std::size_t point, const CuttingConditions& conditions)
    {
        return path_.points[point].move == Move::Cut &&
               conditions_.at(point) == conditions;
    }

    void add_point(std::size_t index, const CuttingConditions& conditions)
    {
        const PathPoint& point = path_.points[index];
        const Motion motion = point.move == Move::Rapid ? Motion::Rapid : Motion::Feed;
        if (conditions.spindle_rpm)
            blocks_.set_speed(*conditions.spindle_rpm);
        const Vec3 from = blocks_.tip();
        if (!blocks_.add_move(motion, point.location.tip, conditions.feed_mm_per_min))
            ++program_.repeated_points;
        else if (motion == Motion::Rapid && is_slanted(from, blocks_.tip()))
            ++program_.slanted_rapids;
        count(is_descent(path_, index) ? Move::Plunge : point.move, conditions);
    }

    static bool is_slanted(const Vec3& from, const Vec3& to)
    {
        return from.z() != to.z() && from.head<2>() != to.head<2>();
    }

    // The first tool goes over the first point. A later tool goes over the last point and
    // down to it, so that the next move at feed starts where the path has it.
    void change_tool(std::size_t point, const CuttingConditions& conditions,
                     const Vec3& first)
    {
        const std::optional<Vec3> back =
            tool_ ? std::optional{blocks_.tip()} : std::nullopt;
        if (back)
            leave_tool();
        tool_ = conditions.tool;
        if (options_.control.tool_change)
            blocks_.add_block('T' + std::to_string(*tool_) + ' ' +
                              *options_.control.tool_change);
        if (conditions.spindle_rpm)
            blocks_.set_speed(*conditions.spindle_rpm);
        blocks_.start_spindle();
        if (options_.dwell_s > 0)
            blocks_.add_block(dwell(options_));
        if (coolant_)
            blocks_.add_block(*coolant_);
        go_over(back.value_or(first));
        count(Move::Rapid, conditions);
        if (back && path_.points[point].move != Move::Rapid)
            return_to(*back, point, conditions);
    }

    // Descends to the point `back`, from which the path goes on with the next tool.
    void return_to(const Vec3& back, std::size_t point, CuttingConditions conditions)
    {
        if (options_.approach_distance && path_.points[point].move == Move::Cut) {
            const double height = back.z() + *options_.approach_distance;
            if (height < program_.safe_height_mm &&
                blocks_.add_move(Motion::Rapid, {back.x(), back.y(), height},
                                 std::nullopt))
                count(Move::Rapid, conditions);
        }
        conditions.feed_mm_per_min = descent_feed(point, conditions);
        if (!blocks_.add_move(Motion::Feed, back, conditions.feed_mm_per_min))
            return;
        ++returns_;
        count(Move::Plunge, conditions);
    }

    // Feed of the descent before the move to `point`.
    std::optional<double> descent_feed(std::size_t point,
                                       const CuttingConditions& conditions) const
    {
        if (is_descent(path_, point) || !conditions.feed_mm_per_min)
            return conditions.feed_mm_per_min;
        return options_.feeds.plunge(*conditions.feed_mm_per_min);
    }

    void leave_tool()
    {
        retract();
        if (coolant_)
            blocks_.add_block(options_.control.coolant_off);
    }

    // Moves one axis after the other, because the position of the tool is unknown. The
    // tool length is set in the block of Z: some controls move at once where it stands
    // alone.
    void go_over(const Vec3& place)
    {
        const auto& length = options_.control.tool_length;
        const bool is_level_first = options_.control.first_axes == FirstAxes::Xy;
        blocks_.forget_position();
        if (is_level_first)
            blocks_.add_level_rapid(place);
        blocks_.add_rise(program_.safe_height_mm,
                         length ? *length + " H" + std::to_string(*tool_) : "");
        if (!is_level_first)
            blocks_.add_level_rapid(place);
    }

    void retract()
    {
        const Vec3 tip = blocks_.tip();
        blocks_.add_move(Motion::Rapid, {tip.x(), tip.y(), program_.safe_height_mm},
                         std::nullopt);
        count(Move::Rapid, {{}, {}, tool_});
    }

    const ToolPath& path_;
    const GcodeOptions& options_;
    std::optional<std::string> coolant_;
    MoveConditions conditions_;
    BlockWriter blocks_;
    WrittenProgram program_;
    PathTotalsSum totals_;
    std::optional<Vec3> position_;  // mm, of the tip; none before all axes have one
    std::optional<int> tool_;
    std::size_t returns_ = 0;  // vertical descents after changes of the tool
    std::size_t run_end_ = 0;  // one past the cuts with the conditions of the last one
};

}  // namespace

WrittenProgram gcode(const ToolPath& path, const GcodeOptions& options)
{
    require(!path.points.empty(), "gcode: need a path with points");
    require_possible(options);
    require_upright(path);
    const double height = safe_height(path, options);
    require_possible_moves(path, options);
    const Vec3& first = path.points.front().location.tip;
    const auto written = [&](const ToolPath& moves) {
        return ProgramWriter{moves, options, height}.write(first);
    };
    ToolPath approached;
    if (options.approach_distance)
        approached = with_rapid_approach(path, height, *options.approach_distance);
    const ToolPath& moves = options.approach_distance ? approached : path;
    if (!options.ramp)
        return written(moves);
    const RampedPath ramped =
        with_ramps(moves, height, std::tan(options.ramp->radians()));
    WrittenProgram program = written(ramped.path);
    program.ramps = ramped.ramps;
    program.straight_descents += ramped.straight;
    return program;
}

}  // namespace endmill
