// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/gcode_writer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/post/detail/block_writer.h"
#include "endmill/post/detail/comment_text.h"
#include "endmill/post/detail/move_conditions.h"
#include "endmill/post/detail/plain_number.h"

// A program is written in three parts: start (%, comment, modes, path control), one block
// per move, and end (retract, M5, M30, %). BlockWriter omits words that repeat the value
// in force. A change of tool, including the first one, adds T and M6, the start of the
// spindle and the way over the next point.

namespace endmill {
namespace {

// Memory reserved per point. A block that moves all three axes has about this length.
constexpr std::size_t likely_bytes_per_point = 34;
// Largest relative change of half the tolerance by rounding it for P.
constexpr double negligible_share = 0.01;

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
    std::string spelled;
    const double height =
        append_fixed(spelled, options.safe_height.value_or(default_safe_height(path)),
                     options.decimals);
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
std::string path_control(const GcodeOptions& options)
{
    if (!options.tolerance)
        return "G64";
    const double half = *options.tolerance / 2;
    require(half >= 0, "gcode: need a tolerance from 0");
    if (half == 0)
        return "G61";  // a rounded corner would leave the path to the forbidden side
    std::string text;
    // A small tolerance needs more decimals than coordinates.
    for (int decimals = options.decimals; decimals <= most_decimals; ++decimals) {
        text = "G64 P";
        const double rounded = append_trimmed(text, half, decimals);
        if (std::abs(rounded - half) <= negligible_share * half)
            return text;
    }
    return "G61";  // too small for nine decimals: the control must not round corners
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

// Writes the blocks of a program.
class ProgramWriter {
public:
    ProgramWriter(const ToolPath& path, const GcodeOptions& options)
        : options_{options},
          conditions_{path,
                      {options.feed_mm_per_min, options.spindle_rpm, options.tool},
                      options.decimals},
          blocks_{{options.decimals, options.line_numbers}}
    {
        program_.safe_height_mm = safe_height(path, options);
        blocks_.text().reserve(path.points.size() * likely_bytes_per_point);
    }

    WrittenProgram write(const ToolPath& path)
    {
        start();
        for (std::size_t i = 0; i < path.points.size(); ++i)
            add_point(path.points[i], conditions_.at(i));
        retract();
        for (const char* last : {"M5", "M30"})
            blocks_.add_block(last);
        blocks_.add_line("%");
        program_.lines = blocks_.lines();
        program_.max_rounding_error_mm = blocks_.max_rounding_error_mm();
        program_.feed_mm_per_min = conditions_.feeds();
        program_.spindle_rpm = conditions_.speeds();
        program_.text = std::move(blocks_.text());
        return std::move(program_);
    }

private:
    void start()
    {
        blocks_.add_line("%");
        if (options_.comments)
            blocks_.add_line('(' + opening_comment(options_.name, options_.cutter) + ')');
        blocks_.add_block("G21 G90 G94 G17 G40 G49 G80 G54");
        blocks_.add_block(path_control(options_));
    }

    void add_point(const PathPoint& point, const CuttingConditions& conditions)
    {
        const Motion motion = point.move == Move::Rapid ? Motion::Rapid : Motion::Feed;
        const Vec3& tip = point.location.tip;
        if (conditions.tool != tool_)
            change_tool(conditions, motion, tip);
        if (conditions.spindle_rpm)
            blocks_.set_speed(*conditions.spindle_rpm);
        const Vec3 from = blocks_.tip();
        if (!blocks_.add_move(motion, tip, conditions.feed_mm_per_min))
            ++program_.repeated_points;
        else if (motion == Motion::Rapid && is_slanted(from, blocks_.tip()))
            ++program_.slanted_rapids;
    }

    static bool is_slanted(const Vec3& from, const Vec3& to)
    {
        return from.z() != to.z() && from.head<2>() != to.head<2>();
    }

    // The first tool goes over the first point. A later tool goes over the last point and
    // down to it, so that the next move at feed starts where the path has it.
    void change_tool(const CuttingConditions& conditions, Motion next, const Vec3& tip)
    {
        const std::optional<Vec3> back =
            tool_ ? std::optional{blocks_.tip()} : std::nullopt;
        if (back)
            retract();
        tool_ = conditions.tool;
        blocks_.add_block('T' + std::to_string(*conditions.tool) + " M6");
        if (conditions.spindle_rpm)
            blocks_.set_speed(*conditions.spindle_rpm);
        blocks_.start_spindle();
        go_over(back.value_or(tip));
        if (back && next == Motion::Feed)
            blocks_.add_move(next, *back, conditions.feed_mm_per_min);
    }

    // Rises vertically first, because the position of the tool is unknown, then moves
    // level.
    void go_over(const Vec3& place)
    {
        blocks_.forget_position();
        blocks_.add_rise(program_.safe_height_mm);
        blocks_.add_move(Motion::Rapid, {place.x(), place.y(), program_.safe_height_mm},
                         std::nullopt);
    }

    void retract()
    {
        const Vec3& tip = blocks_.tip();
        blocks_.add_move(Motion::Rapid, {tip.x(), tip.y(), program_.safe_height_mm},
                         std::nullopt);
    }

    const GcodeOptions& options_;
    MoveConditions conditions_;
    BlockWriter blocks_;
    WrittenProgram program_;
    std::optional<int> tool_;
};

}  // namespace

WrittenProgram gcode(const ToolPath& path, const GcodeOptions& options)
{
    require(!path.points.empty(), "gcode: need a path with points");
    require(0 <= options.decimals && options.decimals <= most_decimals,
            "gcode: need 0 to 9 decimals");
    require_upright(path);
    return ProgramWriter{path, options}.write(path);
}

}  // namespace endmill
