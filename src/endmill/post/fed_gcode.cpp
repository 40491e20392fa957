// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/fed_gcode.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/post/detail/gcode_interpreter.h"
#include "endmill/post/detail/gcode_line.h"
#include "endmill/post/detail/plain_number.h"
#include "endmill/post/detail/text_lines.h"

// The program is rewritten line by line, while an interpreter reports which lines move
// (`for_each_gcode_move`). Nothing is kept of a line that was passed on, since a program may
// have millions of them:
// 1. A line that does not move keeps its text. Only its S becomes the speed of the next
//    motion.
// 2. The points of a line that moves are divided into runs of about equal feed and speed.
//    A straight move has one point, so one run.
// 3. One run: F and S of the line are set, if they differ from those in force.
//    So is a canned cycle: the feeds of all its moves are those of one line.
// 4. Several runs, on an arc: the arc is written as one arc per run. The first keeps the
//    other words of the line, and all get new ends and centres.
// A run gets the smallest speed and the smallest feed per revolution of its points, so
// that no limit of the plan is exceeded anywhere on it.

namespace endmill {
namespace {

// Relative difference of feeds and speeds below which chords share an arc. Controls
// override feeds in steps of a percent, and no limit of a plan is known to a thousandth.
constexpr double same_share = 1e-3;

// Largest angle of a part of an arc in rad, and shortest chord in mm at which an arc is
// split. Both keep rounded ends apart, so that a part becomes neither a full circle nor
// empty.
constexpr double longest_part = 0.9 * 2 * std::numbers::pi;
constexpr double shortest_chord_mm = 1e-4;

// Bytes of text that are passed on together.
constexpr std::size_t bytes_a_piece = 1'000'000;

// Digits after the point.
constexpr int feed_decimals = 4;
constexpr int fine_feed_decimals = 6;  // feeds in inches per minute and under G93
constexpr int speed_decimals = 4;
constexpr int part_decimals = 6;  // new ends of parts of an arc
constexpr int end_decimals = 9;   // the end that the program states, and centres

// The points [first, end) of a move that have about the same feed and speed.
struct Run {
    std::size_t first;
    std::size_t end;
};

// The text of a feed or a speed.
std::string number_text(double value, int decimals)
{
    std::string text;
    const double written =
        std::isfinite(value) ? append_trimmed(text, value, decimals) : 0;
    require(
        written > 0,
        "fed_gcode: need feeds and speeds above 0 with the decimals that are written");
    return text;
}

using Sink = std::function<void(std::string_view piece)>;

class FedGcode {
public:
    FedGcode(TextLines lines, const GcodeReadOptions& options, const ToolPath& path,
             const Sink& sink)
        : lines_{std::move(lines)},
          options_{options},
          path_{path},
          sink_{sink}
    {
    }

    // Writes the lines up to that of the move, which is rewritten.
    void take(const GcodeMove& move)
    {
        require(move.end <= path_.points.size(),
                "fed_gcode: need the path of the program");
        while (lines_.next()) {
            line_.assign(lines_.line());
            const bool moves = lines_.number() == move.line;
            if (moves)
                rewrite(move);
            else {
                pass_by(line_, move);
                text_ += line_.text();
            }
            end_line();
            if (moves)
                return;
        }
    }

    // Writes the lines after the last move, which stay as they are.
    void finish()
    {
        while (lines_.next()) {
            text_ += lines_.line();
            end_line();
        }
        sink_(text_);
        text_.clear();
    }

private:
    void end_line()
    {
        text_ += '\n';
        if (text_.size() < bytes_a_piece)
            return;
        sink_(text_);
        text_.clear();
    }

    const CuttingConditions& conditions(std::size_t point) const
    {
        return path_.points[point].conditions;
    }

    // Position of the programmed point in mm.
    Vec3 place(std::size_t point) const
    {
        return path_.points[point].location.tip +
               options_.programmed_point_height_mm * Vec3::UnitZ();
    }

    // Rewrites a line that does not move: its S becomes the speed of the next motion. A
    // kept F makes the feed in force unknown.
    void pass_by(GcodeLine& line, const GcodeMove& next)
    {
        const auto speed = conditions(next.first).spindle_rpm;
        const bool is_rpm = !next.modes.has_surface_speed;
        if (line.has('S') && is_rpm && speed && line.number('S') > 0.0)
            line.set('S', speed_ = number_text(*speed, speed_decimals));
        if (line.has('F'))
            feed_.clear();
    }

    // Rewrites a line that moves, and adds it to the text.
    void rewrite(const GcodeMove& move)
    {
        if (move.modes.unit != unit_ || move.modes.feed != feed_mode_)
            feed_.clear();
        unit_ = move.modes.unit;
        feed_mode_ = move.modes.feed;
        const std::vector<Run> runs = runs_of(line_, move);
        if (runs.empty())
            set_conditions(line_, move.modes, {move.first, move.end});
        else
            line_ = split(line_, move, runs);
        text_ += line_.text();
    }

    // Writes all parts of an arc except the last one, which is returned.
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
            set_conditions(part, move.modes, run);
            if (run.end == move.end)
                break;
            text_ += part.text() + '\n';
            part = GcodeLine{has_return ? "\r" : ""};
            part.set('G', is_clockwise ? "2" : "3");
        }
        return part;
    }

    // Adds the end and the centre of a part of an arc that starts at `from`. Returns the
    // end as written, at which the next part starts.
    Vec3 add_ends(GcodeLine& part, const GcodeMove& move, const Vec3& from,
                  const Run& run) const
    {
        const double unit = move.modes.mm_per_unit();
        const PlaneAxes axes = plane_axes(move.modes.plane);
        const bool is_last = run.end == move.end;
        const Vec3 to = is_last ? move.arc->end : place(run.end - 1);
        const bool is_increment = move.modes.distance == DistanceMode::Incremental;
        const Vec3 origin = is_increment ? from : Vec3{Vec3::Zero()};
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
            const double before =
                move.modes.centres == DistanceMode::Absolute ? 0 : from[axis];
            std::string text;
            append_trimmed(text, (move.arc->centre[axis] - before) / unit, end_decimals);
            part.set("IJK"[axis], text);
        }
        return reached;
    }

    // The runs into which a move is divided; none if it is one run. An arc on a line with M
    // codes is not split, because some of them stop the program after the motion of their
    // line.
    std::vector<Run> runs_of(const GcodeLine& line, const GcodeMove& move) const
    {
        const Run whole{move.first, move.end};
        if (!move.arc || line.has('M') || is_same(whole))
            return {};
        const double chord =
            arc_angle(*move.arc) / static_cast<double>(move.end - move.first);
        const double radius =
            std::min(arc_radii(*move.arc).start, arc_radii(*move.arc).end);
        if (2 * radius * std::sin(chord / 2) < shortest_chord_mm)
            return {};
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

    // Whether the feeds of all points are about equal or all missing, and the speeds
    // likewise.
    bool is_same(const Run& run) const
    {
        const auto is_about = [&](std::optional<double> CuttingConditions::*value) {
            double least = (conditions(run.first).*value).value_or(0);
            double most = least;
            for (std::size_t i = run.first; i < run.end; ++i) {
                least = std::min(least, (conditions(i).*value).value_or(0));
                most = std::max(most, (conditions(i).*value).value_or(0));
            }
            return most <= (1 + same_share) * least;
        };
        return is_about(&CuttingConditions::feed_mm_per_min) &&
               is_about(&CuttingConditions::spindle_rpm);
    }

    bool is_rapid(std::size_t point) const
    {
        return path_.points[point].move == Move::Rapid;
    }

    // The smallest speed and the smallest feed per revolution, so that all limits hold on
    // the whole run. The rapids of a canned cycle have no feed and do not count.
    CuttingConditions least_conditions(const Run& run) const
    {
        std::size_t first = run.first;
        while (first + 1 < run.end && is_rapid(first))
            ++first;
        const auto counts = [&](std::size_t point) {
            return is_rapid(first) || !is_rapid(point);
        };
        CuttingConditions least = conditions(first);
        for (std::size_t i = first; i < run.end; ++i) {
            if (!counts(i))
                continue;
            if (!conditions(i).feed_mm_per_min)
                least.feed_mm_per_min.reset();
            if (least.spindle_rpm && conditions(i).spindle_rpm)
                least.spindle_rpm =
                    std::min(*least.spindle_rpm, *conditions(i).spindle_rpm);
        }
        for (std::size_t i = first; i < run.end && least.feed_mm_per_min; ++i) {
            if (!counts(i))
                continue;
            const double turns = least.spindle_rpm && conditions(i).spindle_rpm
                                     ? *least.spindle_rpm / *conditions(i).spindle_rpm
                                     : 1;
            least.feed_mm_per_min =
                std::min(*least.feed_mm_per_min, turns * *conditions(i).feed_mm_per_min);
        }
        return least;
    }

    // Length in mm of the moves to the points of a run.
    double length(const Run& run) const
    {
        double sum = 0;
        for (std::size_t i = run.first; i < run.end; ++i)
            sum += (place(i) - place(i - 1)).norm();
        return sum;
    }

    // Sets S and F of a line where they differ from those in force.
    void set_conditions(GcodeLine& line, const GcodeModes& modes, const Run& run)
    {
        const CuttingConditions least = least_conditions(run);
        if (least.spindle_rpm && !modes.has_surface_speed) {
            const std::string speed = number_text(*least.spindle_rpm, speed_decimals);
            if (line.has('S') || speed != speed_)
                line.set('S', speed);
            speed_ = speed;
        }
        // A move of length 0 has a time under G93, but no feed.
        const bool has_feed =
            least.feed_mm_per_min &&
            !(modes.feed == FeedRateMode::InverseTime && length(run) == 0);
        if (has_feed)
            set_feed(line, modes, *least.feed_mm_per_min, run);
        else if (line.has('F'))
            feed_.clear();
    }

    void set_feed(GcodeLine& line, const GcodeModes& modes, double feed, const Run& run)
    {
        const bool is_inverse = modes.feed == FeedRateMode::InverseTime;
        const bool is_fine = is_inverse || modes.unit == ProgramUnit::Inch;
        const std::string text =
            number_text(feed / (is_inverse ? length(run) : modes.mm_per_unit()),
                        is_fine ? fine_feed_decimals : feed_decimals);
        // A word with the right number keeps its spelling.
        if (line.has('F') ? line.number('F') != plain_number(text)
                          : is_inverse || text != feed_)
            line.set('F', text);
        feed_ = text;
    }

    TextLines lines_;
    const GcodeReadOptions& options_;
    const ToolPath& path_;
    const Sink& sink_;
    GcodeLine line_;     // the current line
    std::string text_;   // not yet passed on
    std::string feed_;   // F in force, as written; empty if unknown
    std::string speed_;  // S in force, as written; empty if unknown
    std::optional<ProgramUnit> unit_;
    FeedRateMode feed_mode_ = FeedRateMode::PerMinute;
};

}  // namespace

std::string fed_gcode(std::string_view text, const std::string& file,
                      const GcodeReadOptions& options, const ToolPath& path)
{
    std::string fed;
    write_fed_gcode(text, file, options, path,
                    [&](std::string_view piece) { fed += piece; });
    return fed;
}

void write_fed_gcode(std::string_view text, const std::string& file,
                     const GcodeReadOptions& options, const ToolPath& path,
                     const Sink& sink)
{
    FedGcode fed{TextLines{text, {file, "E_GCODE"}}, options, path, sink};
    const std::size_t points = for_each_gcode_move(
        text, file, options, [&](const GcodeMove& move) { fed.take(move); });
    require(points == path.points.size(), "fed_gcode: need the path of the program");
    fed.finish();
}

}  // namespace endmill
