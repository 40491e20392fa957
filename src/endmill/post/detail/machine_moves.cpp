// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/machine_moves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "endmill/post/detail/joint_bound.h"

// A move is halved at its middle until the bounds of `joint_bound` are within the tolerance.
// Every new stop is exactly on the intended move, so errors do not add up. The bounds fall to
// a quarter with each halving.

namespace endmill {
namespace {

// mm, tolerance of rapids, which keep millimetres of clearance.
constexpr double rapid_tolerance = 0.1;
// Parameter below which a piece is not halved. A stop then differs from its neighbour by
// rounding alone.
constexpr double shortest_piece = 1e-12;
constexpr double never = std::numeric_limits<double>::infinity();

bool is_rapid(const IntendedMove& move)
{
    return move.point.move == Move::Rapid;
}

double even(double from, double to, double u)
{
    return from + u * (to - from);
}

bool turns(const IntendedMove& move)
{
    return move.from_rotary != move.to_rotary;
}

}  // namespace

MachineMoves::MachineMoves(const PartOnMachine& setup, const MachinePathOptions& options)
    : setup_{setup},
      options_{options}
{
    made_.path.machine =
        MachineMotion{.interpolation = options.frame, .setup = setup, .positions = {}};
}

void MachineMoves::begin(const CutterLocation& pose, const RotaryPositions& rotary,
                         const PathPoint& point)
{
    append(point, {0, pose, axis_positions(setup_, rotary, pose.tip)}, never, 0);
}

void MachineMoves::add(const IntendedMove& move)
{
    const double tolerance = is_rapid(move)
                                 ? std::max(options_.tolerance, rapid_tolerance)
                                 : options_.tolerance;
    const auto is_within = [&](const PieceErrors& found) {
        return found.tip <= tolerance &&
               options_.cutter.radius() * found.axis <= tolerance;
    };
    Stop from = stop_at(move, 0);
    std::vector<Stop> ahead{stop_at(move, 1)};  // ends of pieces, the next one last
    while (!ahead.empty()) {
        const Stop to = ahead.back();
        const PieceErrors found = errors(move, from, to);
        if (to.u - from.u > shortest_piece && !is_within(found)) {
            ahead.push_back(stop_at(move, (from.u + to.u) / 2));
            continue;
        }
        add_piece(move, from, to, found);
        from = to;
        ahead.pop_back();
    }
}

MachineMoves::Stop MachineMoves::stop_at(const IntendedMove& move, double u) const
{
    Stop stop{.u = u, .pose = move.to, .at = {}};
    RotaryPositions rotary = move.to_rotary;
    if (u == 0) {
        stop.pose = move.from;
        rotary = move.from_rotary;
    } else if (u < 1) {
        stop.pose = {.tip = (1 - u) * move.from.tip + u * move.to.tip,
                     .axis = axis_on_arc(move.from.axis, move.to.axis, u)};
        rotary = rotary_at(move, stop.pose.axis, u);
    }
    stop.at = axis_positions(setup_, rotary, stop.pose.tip);
    if (move.course == RotaryCourse::Even && u > 0 && u < 1)
        stop.pose.axis = tool_location(setup_, stop.at).axis;
    return stop;
}

// The positions of the solution, with the full rotations that are closest to the even
// course. In a singular direction the first axis takes that course.
RotaryPositions MachineMoves::rotary_at(const IntendedMove& move, const Vec3& axis,
                                        double u) const
{
    RotaryPositions rotary{even(move.from_rotary[0], move.to_rotary[0], u),
                           even(move.from_rotary[1], move.to_rotary[1], u)};
    if (move.course == RotaryCourse::Even || !turns(move))
        return rotary;
    const auto solutions = rotary_solutions(setup_, axis);
    if (move.branch >= solutions.size())
        return rotary;
    const RotaryFrame frame = machine_frame(setup_.machine.configuration);
    const bool is_singular =
        setup_.machine.configuration.rotary.size() == 2 &&
        distance_from_singular(frame, setup_.part_to_machine * axis) <= turn_tolerance;
    constexpr double full_turn = 2 * std::numbers::pi;
    for (std::size_t k = is_singular ? 1 : 0; k < rotary.size(); ++k)
        rotary[k] +=
            std::remainder(solutions[move.branch].positions[k] - rotary[k], full_turn);
    return rotary;
}

MachineMoves::PieceErrors MachineMoves::errors(const IntendedMove& move, const Stop& from,
                                               const Stop& to) const
{
    const double way = (to.pose.tip - from.pose.tip).norm();
    const JointBound bound = joint_bound(setup_, from.at, to.at);
    if (bound.rotary_turn == 0)
        return {.axis = move.axis_slack, .speed = way};
    const double axis =
        move.course == RotaryCourse::Even
            ? move.axis_slack
            : bound.axis_error(angle_between(from.pose.axis, to.pose.axis));
    if (options_.frame == Interpolation::Tcp)
        return {
            .tip = options_.cutter.corner_radius() * axis, .axis = axis, .speed = way};
    const double of_reference = options_.cutter.corner_radius() * axis;
    double tip = bound.tip_error(never);
    if (tip + of_reference > options_.tolerance)
        tip = bound.tip_error(middle_acceleration(setup_, from.at, to.at));
    return {.tip = tip + of_reference, .axis = axis, .speed = way + bound.second / 2};
}

void MachineMoves::add_piece(const IntendedMove& move, const Stop& from, const Stop& to,
                             const PieceErrors& found)
{
    const bool changes = !(from.at == to.at);
    const bool is_end = to.u == 1;
    if (!changes && !is_end)
        return;
    MachinePathReport& report = made_.report;
    PathPoint point = move.point;
    if (!is_end)
        point.known_contact = {};
    double minutes = never;
    if (move.feed_mm_per_min) {
        minutes = piece_minutes(move, from, to);
        const double way = std::max(
            (to.pose.tip - from.pose.tip).norm(),
            options_.cutter.radius() * angle_between(from.pose.axis, to.pose.axis));
        if (way > 0 && minutes > 0) {
            point.conditions.feed_mm_per_min = way / minutes;
            report.max_tip_feed_mm_per_min =
                std::max(report.max_tip_feed_mm_per_min, found.speed / minutes);
        }
        report.time_min += minutes;
    }
    if (changes) {
        ++report.pieces;
        if (!is_rapid(move)) {
            report.max_tip_error_mm = std::max(report.max_tip_error_mm, found.tip);
            report.max_axis_error = std::max(report.max_axis_error, found.axis);
        }
    }
    append(point, to, minutes, move.row);
}

// A move takes max(way of the tip, radius times turn of the axis) / feed; a turn with the
// tool at rest in the part takes the way of the machine instead.
double MachineMoves::piece_minutes(const IntendedMove& move, const Stop& from,
                                   const Stop& to)
{
    const double radius = options_.cutter.radius();
    double way = std::max((to.pose.tip - from.pose.tip).norm(),
                          radius * angle_between(from.pose.axis, to.pose.axis));
    if (move.course == RotaryCourse::Even)
        way = std::max({way, (to.at.xyz - from.at.xyz).norm(),
                        radius * (std::abs(to.at.rotary[0] - from.at.rotary[0]) +
                                  std::abs(to.at.rotary[1] - from.at.rotary[1]))});
    const double wanted = way / *move.feed_mm_per_min;
    const double least = least_minutes(from.at, to.at);
    if (least > wanted)
        made_.report.rate_limited_min += least;
    return std::max(wanted, least);
}

double MachineMoves::least_minutes(const AxisPositions& from,
                                   const AxisPositions& to) const
{
    const AxisRates& rates = setup_.machine.rates;
    double least = 0;
    const auto allow = [&](double way, const std::optional<double>& rate) {
        if (rate)
            least = std::max(least, std::abs(way) / *rate);
    };
    for (std::size_t k = 0; k < rates.rotary_rad_per_min.size(); ++k)
        allow(to.rotary[k] - from.rotary[k], rates.rotary_rad_per_min[k]);
    const Vec3 way = to.xyz - from.xyz;
    for (std::size_t k = 0; k < rates.linear_mm_per_min.size(); ++k)
        allow(way[static_cast<Eigen::Index>(k)], rates.linear_mm_per_min[k]);
    allow(way.norm(), rates.feed_mm_per_min);
    return least;
}

void MachineMoves::append(const PathPoint& point, const Stop& stop, double minutes,
                          std::size_t row)
{
    std::vector<PathPoint>& points = made_.path.points;
    PathPoint added = point;
    const bool continues = !points.empty() && points.back().pass == added.pass;
    added.point = continues ? points.back().point + 1 : 0;
    added.location = stop.pose;
    points.push_back(added);
    made_.path.machine->positions.push_back(stop.at);
    made_.minutes.push_back(minutes);
    made_.rows.push_back(row);
}

MachinePath MachineMoves::take()
{
    return std::exchange(made_, {});
}

}  // namespace endmill
