// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/machine_gcode.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/post/detail/block_writer.h"
#include "endmill/post/detail/move_conditions.h"
#include "endmill/post/detail/path_nodes.h"
#include "endmill/post/detail/plain_number.h"
#include "endmill/post/detail/program_heading.h"

// The words of all points are computed first, because runs of moves between rapids share the
// meaning of F, and the safe height is above all of them. Then the blocks are written in
// order.

namespace endmill {
namespace {

// A block with rotary words has about this length.
constexpr std::size_t likely_bytes_per_point = 64;
// 1/min, inverse time that is not 0 with nine decimals.
constexpr double least_inverse_time = 1e-9;
// Share of the height in the direction along the tool axis below which the tool does not
// leave the path along its axis.
constexpr double least_rise = 0.05;

// A point of the program: positions with rounded rotary axes.
struct ProgramPoint {
    std::array<double, 2> words{0, 0};  // degrees, rounded
    RotaryPositions rotary{0, 0};       // rad, of these words
    Vec3 xyz{0, 0, 0};                  // mm, not rounded
};

class MachineProgramWriter {
public:
    MachineProgramWriter(const MachinePath& made, const GcodeOptions& options,
                         const MachineGcodeFormat& format)
        : made_{made},
          options_{options},
          format_{format},
          motion_{*made.path.machine},
          rotary_{motion_.setup.machine.configuration.rotary},
          conditions_{made.path,
                      {options.feed_mm_per_min, options.spindle_rpm, options.tool},
                      {decimals_of(options),
                       options.control.speed_decimals.value_or(decimals_of(options)),
                       millimetres_per(options.unit)}},
          blocks_{blocks_format(options, format)}
    {
        blocks_.text().reserve(made.path.points.size() * likely_bytes_per_point);
    }

    WrittenMachineProgram write()
    {
        place_points();
        const double height = safe_height();
        written_.program.safe_height_mm = height;
        write_start(blocks_, options_, path_control(), coordinates());
        go_to_first(height);
        for (std::size_t i = 1; i < points_.size(); ++i)
            add_move(i);
        blocks_.set_feed_meaning(BlockFeed::PerMinute);
        const Vec3 away = left_along_axis(points_.size() - 1, height);
        blocks_.add_machine_move(Motion::Rapid, away, {}, std::nullopt);
        write_end(blocks_, options_);
        return take();
    }

private:
    static BlockFormat blocks_format(const GcodeOptions& options,
                                     const MachineGcodeFormat& format)
    {
        BlockFormat blocks = block_format(options);
        blocks.angle_decimals = format.angle_decimals;
        return blocks;
    }

    std::string path_control() const
    {
        if (options_.control.path_control == PathControl::None)
            return "";
        return blending_block(options_, format_.blend.value_or(0));
    }

    // What X, Y and Z are, for the comment of the program.
    std::string coordinates() const
    {
        const PartOnMachine& setup = motion_.setup;
        const std::string of = setup.machine.configuration.word + ", tool length " +
                               to_text(setup.tool_length) + " mm";
        return (motion_.interpolation == Interpolation::Tcp ? "tips, " : "axes of ") + of;
    }

    void place_points()
    {
        const auto& positions = motion_.positions;
        points_.reserve(positions.size());
        std::string spelled;
        for (std::size_t i = 0; i < positions.size(); ++i) {
            ProgramPoint point;
            for (std::size_t k = 0; k < rotary_.size(); ++k) {
                const double sign = motion_.setup.machine.word_signs[k];
                spelled.clear();
                point.words[k] = append_fixed(
                    spelled, sign * Angle::radians(positions[i].rotary[k]).degrees(),
                    format_.angle_decimals);
                point.rotary[k] = sign * Angle::degrees(point.words[k]).radians();
                written_.rotary_range[k].add(point.rotary[k]);
            }
            point.xyz = in_program(made_.path.points[i].location.tip, point.rotary);
            points_.push_back(point);
        }
    }

    // X, Y and Z for a tip: positions of the axes, or the tip in the clamped part.
    Vec3 in_program(const Vec3& tip, const RotaryPositions& rotary) const
    {
        if (motion_.interpolation == Interpolation::Tcp)
            return clamped_point(motion_.setup, tip);
        return axis_positions(motion_.setup, rotary, tip).xyz;
    }

    double safe_height() const
    {
        double top = points_.front().xyz.z();
        for (const ProgramPoint& point : points_)
            top = std::max(top, point.xyz.z());
        const double unit = millimetres_per(options_.unit);
        std::string spelled;
        const auto rounded = [&](double height) {
            return append_fixed(spelled, height / unit, decimals_of(options_)) * unit;
        };
        if (options_.safe_height && *options_.safe_height < top)
            throw DomainError{
                "machine_gcode: the safe height " + to_text(*options_.safe_height) +
                " mm lies below the positions of Z, which reach " + to_text(top) + " mm"};
        if (options_.safe_height)
            return rounded(*options_.safe_height);
        const double wanted = std::max(top, turning_top()) + default_clearance_mm;
        const double travel = motion_.interpolation == Interpolation::Joint
                                  ? motion_.setup.machine.linear[2].to
                                  : wanted;
        return rounded(std::max(top, std::min(wanted, travel)));
    }

    // The top of the sphere in which the path turns with the part, mm; that of the path
    // itself where the part does not turn against X, Y and Z.
    double turning_top() const
    {
        const PartOnMachine& setup = motion_.setup;
        const auto carries_part = [](const RotaryAxis& axis) {
            return axis.side == MachineSide::Table;
        };
        const bool turns_part = std::ranges::any_of(rotary_, carries_part);
        if (!turns_part || motion_.interpolation == Interpolation::Tcp)
            return points_.front().xyz.z();
        const Vec3 centre = setup.machine.table_offset + setup.machine.axis_offset;
        double radius = 0;
        for (const AxisPositions& at : motion_.positions)
            radius = std::max(radius, (tip_over_bed(setup, at) - centre).norm());
        return centre.z() + radius;
    }

    // X, Y and Z at the safe height on the way along the tool axis from a point; straight
    // above it where the axis is almost level, or X and Y do not reach so far.
    Vec3 left_along_axis(std::size_t point, double height) const
    {
        const CutterLocation& pose = made_.path.points[point].location;
        const Vec3& from = points_[point].xyz;
        const Vec3 direction =
            in_program(pose.tip + pose.axis, points_[point].rotary) - from;
        Vec3 above = from;
        above.z() = height;
        if (!(direction.z() > least_rise))
            return above;
        Vec3 along = from + (height - from.z()) / direction.z() * direction;
        along.z() = height;
        LinearLimits across = motion_.setup.machine.linear;
        across[2] = {};
        const bool is_in_reach =
            motion_.interpolation == Interpolation::Tcp || is_within(across, along);
        return is_in_reach ? along : above;
    }

    std::vector<RotaryWord> words_of(std::size_t point) const
    {
        std::vector<RotaryWord> words;
        words.reserve(rotary_.size());
        for (std::size_t k = 0; k < rotary_.size(); ++k)
            words.push_back({static_cast<char>(rotary_[k].letter - 'a' + 'A'),
                             points_[point].words[k]});
        std::ranges::sort(words, {}, &RotaryWord::letter);
        return words;
    }

    void go_to_first(double height)
    {
        const CuttingConditions conditions = conditions_.at(0);
        const auto& length = options_.control.tool_length;
        if (options_.control.tool_change)
            blocks_.add_block('T' + std::to_string(*conditions.tool) + ' ' +
                              *options_.control.tool_change);
        if (conditions.spindle_rpm)
            blocks_.set_speed(*conditions.spindle_rpm);
        blocks_.start_spindle();
        if (options_.dwell_s > 0)
            blocks_.add_block(dwell(options_));
        if (const auto coolant = coolant_word(options_))
            blocks_.add_block(*coolant);
        blocks_.add_rise(height,
                         length ? *length + " H" + std::to_string(*conditions.tool) : "");
        blocks_.add_rotary_rapid(words_of(0));
        blocks_.add_level_rapid(left_along_axis(0, height));
        const bool is_rapid = made_.path.points.front().move == Move::Rapid;
        blocks_.add_machine_move(is_rapid ? Motion::Rapid : Motion::Feed,
                                 points_.front().xyz, words_of(0),
                                 conditions.feed_mm_per_min);
        note_rounding(0);
    }

    void add_move(std::size_t i)
    {
        const CuttingConditions conditions = conditions_.at(i);
        if (conditions.tool != conditions_.at(0).tool)
            throw DomainError{"machine_gcode: " + point_of_path(made_.rows[i]) +
                              " has another tool; expected one tool in a "
                              "program with rotary axes"};
        if (conditions.spindle_rpm)
            blocks_.set_speed(*conditions.spindle_rpm);
        if (!std::isfinite(made_.minutes[i])) {
            waiting_minutes_ = 0;
            if (!blocks_.add_machine_move(Motion::Rapid, points_[i].xyz, words_of(i),
                                          std::nullopt))
                ++written_.program.repeated_points;
        } else {
            add_feed_move(i, conditions);
        }
        note_rounding(i);
    }

    void add_feed_move(std::size_t i, const CuttingConditions& conditions)
    {
        if (i >= run_end_)
            begin_run(i);
        const double minutes = made_.minutes[i] + waiting_minutes_;
        std::optional<double> feed = conditions.feed_mm_per_min;
        if (!feed && minutes > 0)  // a rapid that is written at feed
            feed = (points_[i].xyz - points_[i - 1].xyz).norm() / minutes;
        if (is_inverse_ && minutes > 0) {
            feed = 1 / minutes;
            if (!(*feed >= least_inverse_time))
                throw GeometryError{point_of_path(made_.rows[i]) + ": the move takes " +
                                    to_text(minutes) +
                                    " min, so that its inverse time F rounds to 0; "
                                    "expected a faster feed or a shorter move"};
        }
        if (minutes > 0 &&
            blocks_.add_machine_move(Motion::Feed, points_[i].xyz, words_of(i), feed)) {
            waiting_minutes_ = 0;
            return;
        }
        ++written_.program.repeated_points;
        waiting_minutes_ = minutes;
    }

    // Moves at feed between two rapids have one meaning of F: inverse time if a rotary axis
    // turns among them.
    void begin_run(std::size_t begin)
    {
        run_end_ = begin;
        bool turns = false;
        while (run_end_ < points_.size() && std::isfinite(made_.minutes[run_end_])) {
            turns = turns || points_[run_end_].words != points_[run_end_ - 1].words;
            ++run_end_;
        }
        is_inverse_ = turns;
        blocks_.set_feed_meaning(turns ? BlockFeed::InverseTime : BlockFeed::PerMinute);
    }

    // Notes the rounding of the point that the last block has reached.
    void note_rounding(std::size_t i)
    {
        const Vec3 xyz = blocks_.tip();
        const CutterLocation& pose = made_.path.points[i].location;
        if (i == 0)
            written_.xyz_range = {xyz, xyz};
        written_.xyz_range.low = written_.xyz_range.low.cwiseMin(xyz);
        written_.xyz_range.high = written_.xyz_range.high.cwiseMax(xyz);
        const PartOnMachine& setup = motion_.setup;
        CutterLocation reached = tool_location(setup, {points_[i].rotary, xyz});
        if (motion_.interpolation == Interpolation::Tcp)
            reached.tip = setup.part_to_machine.transpose() * (xyz - setup.clamp);
        written_.rounding_tip_mm =
            std::max(written_.rounding_tip_mm, (reached.tip - pose.tip).norm());
        written_.rounding_axis =
            std::max(written_.rounding_axis, angle_between(reached.axis, pose.axis));
    }

    WrittenMachineProgram take()
    {
        WrittenProgram& program = written_.program;
        program.decimals = decimals_of(options_);
        program.lines = blocks_.lines();
        program.max_rounding_error_mm = blocks_.max_rounding_error_mm();
        program.feed_mm_per_min = conditions_.feeds();
        program.plunge_feed_mm_per_min = conditions_.plunge_feeds();
        program.spindle_rpm = conditions_.speeds();
        program.totals = path_totals(made_.path);
        program.text = std::move(blocks_.text());
        return std::move(written_);
    }

    const MachinePath& made_;
    const GcodeOptions& options_;
    const MachineGcodeFormat& format_;
    const MachineMotion& motion_;
    const std::vector<RotaryAxis>& rotary_;
    MoveConditions conditions_;
    BlockWriter blocks_;
    std::vector<ProgramPoint> points_;
    WrittenMachineProgram written_;
    double waiting_minutes_ = 0;  // of moves left out, for the next block
    std::size_t run_end_ = 0;     // one past the moves that share the meaning of F
    bool is_inverse_ = false;
};

}  // namespace

WrittenMachineProgram machine_gcode(const MachinePath& made, const GcodeOptions& options,
                                    const MachineGcodeFormat& format)
{
    require(!made.path.points.empty() && made.path.machine,
            "machine_gcode: need motions of a machine");
    require(made.minutes.size() == made.path.points.size() &&
                made.rows.size() == made.path.points.size() &&
                made.path.machine->positions.size() == made.path.points.size(),
            "machine_gcode: need positions and a time for every point");
    require_sound(options.control);
    require(0 <= decimals_of(options) && decimals_of(options) <= most_decimals &&
                0 <= format.angle_decimals && format.angle_decimals <= most_decimals,
            "machine_gcode: need 0 to 9 decimals");
    require(std::isfinite(options.dwell_s) && options.dwell_s >= 0,
            "machine_gcode: need a dwell from 0");
    require(!options.arc_tolerance && !options.ramp && !options.approach_distance,
            "machine_gcode: programs with rotary axes have no arcs, slopes or approach "
            "distance");
    require(!format.blend || (std::isfinite(*format.blend) && *format.blend >= 0),
            "machine_gcode: need a blend from 0");
    return MachineProgramWriter{made, options, format}.write();
}

}  // namespace endmill
