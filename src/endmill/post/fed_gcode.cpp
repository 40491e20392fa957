// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/fed_gcode.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/post/detail/gcode_line.h"
#include "endmill/post/detail/plain_number.h"
#include "endmill/post/detail/text_lines.h"
#include "endmill/post/gcode_reader.h"

namespace endmill {
namespace {

// Controls override feeds by steps of a percent, and no limit of a plan is known to a
// thousandth: chords that differ by less share an arc.
constexpr double same_share = 1e-3;

// Part of an arc, so that rounded ends never make a full circle or none of it.
constexpr double longest_part = 0.9 * 2 * std::numbers::pi;  // rad
constexpr double shortest_chord_mm = 1e-4;

constexpr int feed_decimals = 4;
constexpr int fine_feed_decimals = 6;  // inches a minute, and one over the minutes
constexpr int speed_decimals = 4;
constexpr int part_decimals = 6;
constexpr int end_decimals = 9;  // of the end that was in the program

// The points [first, end) of a move that share feed and speed.
struct Run {
    std::size_t first;
    std::size_t end;
};

std::string told_number(double value, int decimals)
{
    std::string text;
    const double written =
        std::isfinite(value) ? append_trimmed(text, value, decimals) : 0;
    require(
        written > 0,
        "fed_gcode: need feeds and speeds above 0 with the decimals that are written");
    return text;
}

class FedGcode {
public:
    FedGcode(const GcodeReadOptions& options, const ToolPath& path)
        : options_{options},
          path_{path}
    {
    }

    std::string rewritten(TextLines lines, const std::vector<GcodeMove>& moves)
    {
        auto move = moves.begin();
        while (lines.next()) {
            GcodeLine line{lines.line()};
            if (move != moves.end() && lines.number() == move->line)
                rewrite(line, *move++);
            else {
                // What follows the last move stays as it is.
                if (move != moves.end())
                    pass_by(line, *move);
                text_ += line.text();
            }
            text_ += '\n';
        }
        return std::move(text_);
    }

private:
    const CuttingConditions& told(std::size_t point) const
    {
        return path_.conditions[point];
    }

    // Of the programmed point.
    Vec3 place(std::size_t point) const
    {
        return path_.points[point].location.tip +
               options_.programmed_point_height_mm * Vec3::UnitZ();
    }

    // A line that moves nothing: its speed is that of the motion to come.
    void pass_by(GcodeLine& line, const GcodeMove& next)
    {
        const auto speed = told(next.first).spindle_rpm;
        if (line.has('S') && speed && line.number('S') > 0.0)
            line.set('S', speed_ = told_number(*speed, speed_decimals));
        if (line.has('F'))
            feed_.clear();
    }

    void rewrite(GcodeLine& line, const GcodeMove& move)
    {
        if (move.modes.unit != unit_ || move.modes.inverse_time != is_inverse_time_)
            feed_.clear();
        unit_ = move.modes.unit;
        is_inverse_time_ = move.modes.inverse_time;
        const std::vector<Run> runs = runs_of(line, move);
        if (runs.size() == 1)
            tell(line, move.modes, runs[0]);
        else
            line = split(line, move, runs);
        text_ += line.text();
    }

    // Writes all parts of an arc but the last. \return the last.
    GcodeLine split(const GcodeLine& line, const GcodeMove& move,
                    const std::vector<Run>& runs)
    {
        const bool has_return = line.text().ends_with('\r');
        const bool is_clockwise = move.arc->clockwise;
        GcodeLine part = line;
        part.remove("XYZIJKRPFS");
        Vec3 from = move.arc->start;
        for (const Run& run : runs) {
            from = add_ends(part, move, from, run);
            tell(part, move.modes, run);
            if (run.end == move.end)
                break;
            text_ += part.text() + '\n';
            part = GcodeLine{has_return ? "\r" : ""};
            part.set('G', is_clockwise ? "2" : "3");
        }
        return part;
    }

    // \return where the part ends as it is written.
    Vec3 add_ends(GcodeLine& part, const GcodeMove& move, const Vec3& from,
                  const Run& run) const
    {
        const double unit = move.modes.mm_per_unit();
        const PlaneAxes axes = plane_axes(move.modes.plane);
        const bool is_last = run.end == move.end;
        const Vec3 to = is_last ? move.arc->end : place(run.end - 1);
        const Vec3 origin = move.modes.incremental ? from : Vec3{Vec3::Zero()};
        Vec3 reached = from;
        for (int axis = 0; axis < 3; ++axis) {
            if (axis == axes.normal && move.arc->start[axis] == move.arc->end[axis])
                continue;
            std::string text;
            reached[axis] = origin[axis] +
                            unit * append_trimmed(text, (to[axis] - origin[axis]) / unit,
                                                  is_last ? end_decimals : part_decimals);
            part.set("XYZ"[axis], text);
        }
        for (const int axis : {axes.first, axes.second}) {
            const double before = move.modes.absolute_centres ? 0 : from[axis];
            std::string text;
            append_trimmed(text, (move.arc->centre[axis] - before) / unit, end_decimals);
            part.set("IJK"[axis], text);
        }
        return reached;
    }

    // M codes stay in one line with the whole of the motion: some stop the program behind it.
    std::vector<Run> runs_of(const GcodeLine& line, const GcodeMove& move) const
    {
        const Run whole{move.first, move.end};
        if (!move.arc || line.has('M') || is_same(whole))
            return {whole};
        const double chord =
            arc_angle(*move.arc) / static_cast<double>(move.end - move.first);
        const double radius =
            std::min(arc_radii(*move.arc).start, arc_radii(*move.arc).end);
        if (2 * radius * std::sin(chord / 2) < shortest_chord_mm)
            return {whole};
        std::vector<Run> runs;
        for (Run run{whole.first, whole.first}; run.end < whole.end;
             run.first = run.end) {
            ++run.end;
            while (run.end < whole.end && is_same({run.first, run.end + 1}) &&
                   static_cast<double>(run.end + 1 - run.first) * chord < longest_part)
                ++run.end;
            runs.push_back(run);
        }
        return runs;
    }

    // Whether feed and speed are known of all points or of none, and about the same.
    bool is_same(const Run& run) const
    {
        const auto is_about = [&](std::optional<double> CuttingConditions::*value) {
            double least = (told(run.first).*value).value_or(0);
            double most = least;
            for (std::size_t i = run.first; i < run.end; ++i) {
                least = std::min(least, (told(i).*value).value_or(0));
                most = std::max(most, (told(i).*value).value_or(0));
            }
            return most <= (1 + same_share) * least;
        };
        return is_about(&CuttingConditions::feed_mm_per_min) &&
               is_about(&CuttingConditions::spindle_rpm);
    }

    // The least speed and the least feed a turn, so that all limits hold on all of the run.
    CuttingConditions least_told(const Run& run) const
    {
        CuttingConditions least = told(run.first);
        for (std::size_t i = run.first; i < run.end; ++i) {
            if (!told(i).feed_mm_per_min)
                least.feed_mm_per_min.reset();
            if (least.spindle_rpm && told(i).spindle_rpm)
                least.spindle_rpm = std::min(*least.spindle_rpm, *told(i).spindle_rpm);
        }
        for (std::size_t i = run.first; i < run.end && least.feed_mm_per_min; ++i) {
            const double turns = least.spindle_rpm && told(i).spindle_rpm
                                     ? *least.spindle_rpm / *told(i).spindle_rpm
                                     : 1;
            least.feed_mm_per_min =
                std::min(*least.feed_mm_per_min, turns * *told(i).feed_mm_per_min);
        }
        return least;
    }

    double length(const Run& run) const
    {
        double sum = 0;
        for (std::size_t i = run.first; i < run.end; ++i)
            sum += (place(i) - place(i - 1)).norm();
        return sum;
    }

    void tell(GcodeLine& line, const GcodeModes& modes, const Run& run)
    {
        const CuttingConditions least = least_told(run);
        if (least.spindle_rpm) {
            const std::string speed = told_number(*least.spindle_rpm, speed_decimals);
            if (line.has('S') || speed != speed_)
                line.set('S', speed);
            speed_ = speed;
        }
        // What goes nowhere has its time under G93, and no feed.
        const bool has_feed =
            least.feed_mm_per_min && !(modes.inverse_time && length(run) == 0);
        if (has_feed)
            tell_feed(line, modes, *least.feed_mm_per_min, run);
        else if (line.has('F'))
            feed_.clear();
    }

    void tell_feed(GcodeLine& line, const GcodeModes& modes, double feed, const Run& run)
    {
        const bool is_fine = modes.inverse_time || modes.unit == GcodeUnit::Inch;
        const std::string text =
            told_number(feed / (modes.inverse_time ? length(run) : modes.mm_per_unit()),
                        is_fine ? fine_feed_decimals : feed_decimals);
        // A number that is right may stay as it is spelled.
        if (line.has('F') ? line.number('F') != plain_number(text)
                          : modes.inverse_time || text != feed_)
            line.set('F', text);
        feed_ = text;
    }

    const GcodeReadOptions& options_;
    const ToolPath& path_;
    std::string text_;
    std::string feed_;   // in force, as it is written; empty: not known
    std::string speed_;  // ditto
    GcodeUnit unit_ = GcodeUnit::Unsaid;
    bool is_inverse_time_ = false;
};

}  // namespace

std::string fed_gcode(std::string_view text, const std::string& file,
                      const GcodeReadOptions& options, const ToolPath& path)
{
    const std::vector<GcodeMove> moves = gcode_moves(text, file, options);
    const std::size_t points = moves.empty() ? 0 : moves.back().end;
    require(points == path.points.size() && points == path.conditions.size(),
            "fed_gcode: need the path of the program, with conditions");
    return FedGcode{options, path}.rewritten(TextLines{text, {file, "E_GCODE"}}, moves);
}

}  // namespace endmill
