// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/apt.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/post/detail/comment_text.h"
#include "endmill/post/detail/move_conditions.h"
#include "endmill/post/detail/plain_number.h"

namespace endmill {
namespace {

// Memory reserved per point. A typical long statement is
// GOTO/-100.1234,-100.1234,-10.1234 with a line feed.
constexpr std::size_t likely_bytes_per_point = 36;

// Appends statements. Stores the feed and speed statements in force, so that each is
// written only where it changes.
class StatementWriter {
public:
    StatementWriter(const AptOptions& options, std::size_t points) : options_{options}
    {
        program_.text.reserve(points * likely_bytes_per_point);
    }

    void add_heading()
    {
        add("PARTNO/" + comment_text(options_.name));
        add("UNITS/MM");
        if (options_.multax)
            add("MULTAX");
        if (!options_.cutter)
            return;
        std::string cutter = "CUTTER/";
        append_exact(cutter, 2 * options_.cutter->radius());
        cutter += ',';
        append_exact(cutter, options_.cutter->corner_radius());
        add(cutter);
    }

    void add_point(const PathPoint& point, const CuttingConditions& conditions)
    {
        if (conditions.tool && conditions.tool != tool_) {
            tool_ = conditions.tool;
            add("LOADTL/" + std::to_string(*tool_));
        }
        if (conditions.spindle_rpm)
            add_changed("SPINDL/", *conditions.spindle_rpm, ",RPM,CLW", speed_);
        if (conditions.feed_mm_per_min)
            add_changed("FEDRAT/", *conditions.feed_mm_per_min, ",MMPM", feed_);
        if (point.move == Move::Rapid)
            add("RAPID");
        const Vec3 tip = add_goto(point.location);
        if (tip_)
            totals_.add(point.move, tip, conditions, (tip - *tip_).norm());
        else
            totals_.start(tip, conditions.tool);
        tip_ = tip;
    }

    void add(std::string_view statement)
    {
        program_.text += statement;
        program_.text += '\n';
        ++program_.lines;
    }

    WrittenProgram take()
    {
        program_.totals = totals_.totals();
        return std::move(program_);
    }

private:
    // Adds a modal statement unless the same one is in force.
    void add_changed(std::string_view word, double value, std::string_view unit,
                     std::string& in_force)
    {
        std::string statement{word};
        append_trimmed(statement, value, options_.decimals);
        statement += unit;
        if (statement != in_force)
            add(statement);
        in_force = std::move(statement);
    }

    // The tip is rounded to the decimals. The axis is written exactly, because rounding
    // it would tilt the tool. Returns the rounded tip.
    Vec3 add_goto(const CutterLocation& location)
    {
        std::string& text = program_.text;
        text += "GOTO/";
        Vec3 tip;
        for (int c = 0; c < 3; ++c) {
            text += c == 0 ? "" : ",";
            tip[c] = append_fixed(text, location.tip[c], options_.decimals);
            program_.max_rounding_error_mm = std::max(program_.max_rounding_error_mm,
                                                      std::abs(tip[c] - location.tip[c]));
        }
        if (options_.multax || location.axis != Vec3::UnitZ())
            for (const double component : location.axis) {
                text += ',';
                append_exact(text, component);
            }
        text += '\n';
        ++program_.lines;
        return tip;
    }

    const AptOptions& options_;
    WrittenProgram program_;
    PathTotalsSum totals_;
    std::optional<Vec3> tip_;  // mm, of the point before
    std::optional<int> tool_;
    std::string speed_;  // the statements in force
    std::string feed_;
};

}  // namespace

WrittenProgram apt(const ToolPath& path, const AptOptions& options)
{
    require(!path.points.empty(), "apt: need a path with points");
    MoveConditions conditions{path,
                              {options.feed_mm_per_min, options.spindle_rpm, {}},
                              {options.decimals, options.decimals}};
    StatementWriter writer{options, path.points.size()};
    writer.add_heading();
    for (std::size_t i = 0; i < path.points.size(); ++i)
        writer.add_point(path.points[i], conditions.at(i));
    writer.add("FINI");
    WrittenProgram program = writer.take();
    program.decimals = options.decimals;
    program.feed_mm_per_min = conditions.feeds();
    program.plunge_feed_mm_per_min = conditions.plunge_feeds();
    program.spindle_rpm = conditions.speeds();
    return program;
}

}  // namespace endmill
