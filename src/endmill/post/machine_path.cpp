// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/machine_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/post/detail/branch_search.h"
#include "endmill/post/detail/joint_bound.h"
#include "endmill/post/detail/machine_moves.h"
#include "endmill/post/detail/path_nodes.h"
#include "endmill/post/program.h"

// 1. A path that a machine interpolates is replaced by poses with linear motion between.
// 2. `path_nodes` adds poses where an axis turns far.
// 3. `search_branches` chooses the positions of the rotary axes, first without retracts.
// 4. `MachineMoves` divides the moves until the machine stays within the tolerance.
// 5. The travel of X, Y and Z is checked.

namespace endmill {
namespace {

// Share of the tolerance for replacing a path that a machine interpolates.
constexpr double replacing_share = 0.1;
// rad, steps of a tool that goes round the sphere of retracts.
constexpr double sphere_step = Angle::degrees(10).radians();
// mm, height over a point above which a return to it is a rapid.
constexpr double return_clearance = 5;

// A length in mm with up to six decimals.
std::string length_text(double mm)
{
    constexpr double steps = 1e6;
    return to_text(std::round(mm * steps) / steps);
}

void require_poses(const ToolPath& path)
{
    constexpr double largest_off = 1e-6;
    require(!path.points.empty(), "machine_path: need a path with points");
    for (std::size_t row = 0; row < path.points.size(); ++row) {
        const CutterLocation& pose = path.points[row].location;
        if (!pose.tip.allFinite() || !(std::abs(pose.axis.norm() - 1) <= largest_off))
            throw DomainError{point_of_path(row) +
                              " has no finite tip and unit axis; expected both"};
    }
}

// The pose at parameter u between two points of a path that a machine interpolates.
CutterLocation pose_between(const ToolPath& path, std::size_t row, double u)
{
    const MachineMotion& machine = *path.machine;
    const AxisPositions& from = machine.positions[row - 1];
    const AxisPositions& to = machine.positions[row];
    AxisPositions at{.xyz = (1 - u) * from.xyz + u * to.xyz};
    for (std::size_t k = 0; k < at.rotary.size(); ++k)
        at.rotary[k] = from.rotary[k] + u * (to.rotary[k] - from.rotary[k]);
    CutterLocation pose = tool_location(machine.setup, at);
    if (machine.interpolation == Interpolation::Tcp)
        pose.tip = (1 - u) * path.points[row - 1].location.tip +
                   u * path.points[row].location.tip;
    return pose;
}

// A path of poses with linear motion between, and for each the point that it comes from.
struct LinearPath {
    ToolPath path;
    std::vector<std::size_t> rows;
};

// The number of equal parts of a move after which linear motion between their ends differs
// from the machine's motion by at most the tolerance. Errors of parts fall with
// the square of their number.
int parts_of_move(const ToolPath& path, std::size_t row, const Cutter& cutter,
                  double tolerance)
{
    const MachineMotion& machine = *path.machine;
    const JointBound bound =
        joint_bound(machine.setup, machine.positions[row - 1], machine.positions[row]);
    const double angle =
        angle_between(path.points[row - 1].location.axis, path.points[row].location.axis);
    const double axis = bound.axis_error(std::max(angle, bound.rotary_turn));
    double error = cutter.radius() * axis;
    if (machine.interpolation == Interpolation::Joint)
        error = std::max(error,
                         bound.tip_error(bound.second) + cutter.corner_radius() * axis);
    constexpr double most_parts = 1e6;
    return static_cast<int>(
        std::clamp(std::ceil(std::sqrt(error / (tolerance))), 1.0, most_parts));
}

LinearPath linear_motion(const ToolPath& path, const Cutter& cutter, double tolerance)
{
    LinearPath linear;
    linear.path.points.reserve(path.points.size());
    for (std::size_t row = 0; row < path.points.size(); ++row) {
        const int parts =
            row > 0 && path.machine ? parts_of_move(path, row, cutter, tolerance) : 1;
        for (int k = 1; k < parts; ++k) {
            PathPoint point = path.points[row];
            point.known_contact = {};
            point.location = pose_between(path, row, static_cast<double>(k) / parts);
            linear.path.points.push_back(point);
            linear.rows.push_back(row);
        }
        linear.path.points.push_back(path.points[row]);
        linear.rows.push_back(row);
    }
    for (PathPoint& point : linear.path.points)
        point.location.axis.normalize();
    return linear;
}

// A sphere around the tips of a path, larger by the distance to which the tool retracts.
struct RetractSphere {
    Vec3 centre;
    double radius;
};

RetractSphere retract_sphere(const ToolPath& path, double retract)
{
    const TipBox box = *path_totals(path).extent;
    const Vec3 centre = (box.low + box.high) / 2;
    double radius = 0;
    for (const PathPoint& point : path.points)
        radius = std::max(radius, (point.location.tip - centre).norm());
    return {centre, radius + retract};
}

// Adds the motions of a path whose positions at the nodes are known.
class PathMover {
public:
    PathMover(const ToolPath& path, const std::vector<PathNode>& nodes,
              const PartOnMachine& setup, const MachinePathOptions& options)
        : path_{path},
          nodes_{nodes},
          setup_{setup},
          options_{options},
          moves_{setup, options}
    {
    }

    MachinePath move(const std::vector<BranchChoice>& choices,
                     const std::vector<SearchPose>& poses)
    {
        moves_.begin(nodes_.front().pose, choices.front().arrival, path_.points.front());
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            if (i > 0)
                add_arc(i, choices[i - 1], choices[i]);
            if (choices[i].arrival == choices[i].departure)
                continue;
            if (poses[i].turn == PoseTurn::Retract)
                reorient(i, choices[i]);
            else
                turn_in_place(i, choices[i]);
        }
        return moves_.take();
    }

private:
    void add_arc(std::size_t node, const BranchChoice& from, const BranchChoice& to)
    {
        const PathNode& end = nodes_[node];
        PathPoint point = path_.points[end.row];
        if (!end.is_row_end)
            point.known_contact = {};
        moves_.add({.from = nodes_[node - 1].pose,
                    .to = end.pose,
                    .from_rotary = from.departure,
                    .to_rotary = to.arrival,
                    .course = RotaryCourse::GreatArc,
                    .branch = to.arrival_branch,
                    .point = point,
                    .row = end.row,
                    .feed_mm_per_min = feed_of(point, from.departure != to.arrival)});
    }

    // The feed of the move to a point. Rapids that turn an axis may have one.
    std::optional<double> feed_of(const PathPoint& point, bool turns) const
    {
        if (point.move == Move::Rapid)
            return turns ? options_.rapid_feed : std::nullopt;
        return point.conditions.feed_mm_per_min;
    }

    // The feed at which a turn at a node is made: that of the move after it.
    PathPoint point_at(std::size_t node) const
    {
        const std::size_t row = nodes_[std::min(node + 1, nodes_.size() - 1)].row;
        PathPoint point = path_.points[row];
        point.known_contact = {};
        point.location = nodes_[node].pose;
        if (row > 0 && path_.points[nodes_[node].row].move == Move::Rapid)
            point.move = Move::Rapid;
        return point;
    }

    void turn_in_place(std::size_t node, const BranchChoice& choice)
    {
        const PathNode& at = nodes_[node];
        PathPoint point = point_at(node);
        if (point.move != Move::Rapid)
            point.move = Move::Link;
        const bool is_in_air = point.move == Move::Rapid;
        moves_.add({.from = at.pose,
                    .to = at.pose,
                    .from_rotary = choice.arrival,
                    .to_rotary = choice.departure,
                    .course = RotaryCourse::Even,
                    .axis_slack =
                        is_in_air || at.is_singular() ? 0 : 2 * at.distance_from_singular,
                    .point = point,
                    .row = at.row,
                    .feed_mm_per_min = feed_of(point, true)});
    }

    // Leaves the part along the axis, goes round the sphere while the axes turn, and
    // returns.
    void reorient(std::size_t node, const BranchChoice& choice)
    {
        const RetractSphere sphere = retract_sphere(path_, *options_.retract);
        const CutterLocation& pose = nodes_[node].pose;
        const Vec3 from_centre = pose.tip - sphere.centre;
        const double along = from_centre.dot(pose.axis);
        const double height =
            -along + std::sqrt(along * along + sphere.radius * sphere.radius -
                               from_centre.squaredNorm());
        // Chords between steps stay outside of the sphere.
        const double radius = sphere.radius / std::cos(sphere_step / 2);
        const Vec3 left = (from_centre + height * pose.axis).normalized();
        rapid_.emplace(Rapid{point_at(node), nodes_[node].row, pose, choice.arrival});
        rapid_->point.move = Move::Rapid;
        rapid_->point.conditions.feed_mm_per_min.reset();
        go_rapidly(sphere.centre + radius * left, choice.arrival);
        go_round(sphere.centre, radius, {left, pose.axis}, choice.arrival);
        turn_on_sphere(sphere.centre, radius, choice);
        go_round(sphere.centre, radius, {pose.axis, left}, choice.departure);
        return_to(node, choice);
    }

    // Turns the axes with the tip above the centre along the tool axis.
    void turn_on_sphere(const Vec3& centre, double radius, const BranchChoice& choice)
    {
        const double turn = std::max(std::abs(choice.departure[0] - choice.arrival[0]),
                                     std::abs(choice.departure[1] - choice.arrival[1]));
        const int steps = std::max(1, static_cast<int>(std::ceil(turn / sphere_step)));
        for (int k = 1; k <= steps; ++k) {
            const double u = static_cast<double>(k) / steps;
            const RotaryPositions rotary{
                choice.arrival[0] + u * (choice.departure[0] - choice.arrival[0]),
                choice.arrival[1] + u * (choice.departure[1] - choice.arrival[1])};
            const Vec3 axis = tool_location(setup_, {rotary, {}}).axis;
            go_rapidly(centre + radius * axis, k == steps ? choice.departure : rotary);
        }
    }

    void go_round(const Vec3& centre, double radius, const std::array<Vec3, 2>& ends,
                  const RotaryPositions& rotary)
    {
        const double angle = angle_between(ends[0], ends[1]);
        const int steps = std::max(1, static_cast<int>(std::ceil(angle / sphere_step)));
        for (int k = 1; k <= steps; ++k)
            go_rapidly(centre + radius * axis_on_arc(ends[0], ends[1],
                                                     static_cast<double>(k) / steps),
                       rotary);
    }

    void go_rapidly(const Vec3& tip, const RotaryPositions& rotary)
    {
        const CutterLocation to{tip, tool_location(setup_, {rotary, {}}).axis};
        moves_.add({.from = rapid_->pose,
                    .to = to,
                    .from_rotary = rapid_->rotary,
                    .to_rotary = rotary,
                    .course = RotaryCourse::Even,
                    .point = rapid_->point,
                    .row = rapid_->row,
                    .feed_mm_per_min = feed_of(rapid_->point, rapid_->rotary != rotary)});
        rapid_->pose = to;
        rapid_->rotary = rotary;
    }

    // The last millimetres are a plunge if the path goes on at feed.
    void return_to(std::size_t node, const BranchChoice& choice)
    {
        const CutterLocation& pose = nodes_[node].pose;
        const PathPoint next = point_at(node);
        if (next.move == Move::Rapid)
            return go_rapidly(pose.tip, choice.departure);
        go_rapidly(pose.tip + return_clearance * pose.axis, choice.departure);
        PathPoint point = next;
        point.move = Move::Plunge;
        moves_.add({.from = rapid_->pose,
                    .to = pose,
                    .from_rotary = choice.departure,
                    .to_rotary = choice.departure,
                    .course = RotaryCourse::Even,
                    .point = point,
                    .row = nodes_[node].row,
                    .feed_mm_per_min = point.conditions.feed_mm_per_min});
    }

    struct Rapid {
        PathPoint point;
        std::size_t row;
        CutterLocation pose;  // reached so far
        RotaryPositions rotary;
    };

    const ToolPath& path_;
    const std::vector<PathNode>& nodes_;
    const PartOnMachine& setup_;
    const MachinePathOptions& options_;
    MachineMoves moves_;
    std::optional<Rapid> rapid_;
};

std::array<RotaryRange, 2> ranges_of(const Machine& machine)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::array<RotaryRange, 2> ranges{RotaryRange{-infinity, infinity},
                                      RotaryRange{-infinity, infinity}};
    for (std::size_t k = 0; k < machine.configuration.rotary.size(); ++k)
        ranges[k] = position_range(machine, k);
    return ranges;
}

[[noreturn]] void refuse_blocked(const BlockedPoint& blocked, const Machine& machine,
                                 bool may_retract)
{
    const char letter = machine.configuration.rotary[blocked.axis].letter;
    const double excess = std::abs(blocked.position - blocked.limit);
    throw GeometryError{
        point_of_path(blocked.row) + ": axis " + static_cast<char>(letter - 'a' + 'A') +
        " at " + degrees_text(blocked.position) + " degrees exceeds its limit " +
        degrees_text(blocked.limit) + " by " + degrees_text(excess) +
        (may_retract ? "; expected another setup (endmill setup --path) or wider limits"
                     : "; expected another setup (endmill setup --path), wider limits or "
                       "--retract")};
}

// A shift of the clamping position with which X, Y and Z stay within their travel, found by
// projection to one limit after the other.
std::optional<Vec3> fitting_shift(const MachinePath& made, const Machine& machine)
{
    constexpr int most_rounds = 200;
    constexpr double rounding = 1e-9;  // mm
    const auto& positions = made.path.machine->positions;
    Vec3 shift = Vec3::Zero();
    for (int round = 0; round < most_rounds; ++round) {
        double worst = 0;
        for (const AxisPositions& at : positions) {
            const Vec3 origin = axis_positions(machine, at.rotary, Vec3::Zero(), 0).xyz;
            const Vec3 moved =
                at.xyz + axis_positions(machine, at.rotary, shift, 0).xyz - origin;
            for (int axis = 0; axis < 3; ++axis) {
                const LinearRange& range = machine.linear[static_cast<std::size_t>(axis)];
                const double off = std::max(range.from - moved[axis], 0.0) -
                                   std::max(moved[axis] - range.to, 0.0);
                if (std::abs(off) <= rounding)
                    continue;
                worst = std::max(worst, std::abs(off));
                // The row of the table's rotation for this axis, as a direction of the
                // clamping position.
                const Vec3 direction{
                    (axis_positions(machine, at.rotary, Vec3::UnitX(), 0).xyz -
                     origin)[axis],
                    (axis_positions(machine, at.rotary, Vec3::UnitY(), 0).xyz -
                     origin)[axis],
                    (axis_positions(machine, at.rotary, Vec3::UnitZ(), 0).xyz -
                     origin)[axis]};
                shift += (off + std::copysign(rounding, off)) * direction;
                break;
            }
        }
        if (worst <= rounding)
            return shift;
    }
    return std::nullopt;
}

void require_travel(const MachinePath& made, const PartOnMachine& setup)
{
    constexpr double rounding = 1e-6;  // mm, as travel counts in `setup`
    const auto& positions = made.path.machine->positions;
    for (std::size_t i = 0; i < positions.size(); ++i)
        for (int axis = 0; axis < 3; ++axis) {
            const LinearRange& range =
                setup.machine.linear[static_cast<std::size_t>(axis)];
            const double at = positions[i].xyz[axis];
            const double over = std::max(range.from - at, at - range.to);
            if (!(over > rounding))
                continue;
            std::string advice =
                "no clamping position fits at this rotation of the part; endmill setup "
                "--path finds another one";
            if (const auto shift = fitting_shift(made, setup.machine)) {
                const Vec3 clamp = setup.clamp + *shift;
                advice = "--clamp " + length_text(clamp.x()) + ',' +
                         length_text(clamp.y()) + ',' + length_text(clamp.z()) + " fits";
            }
            throw GeometryError{point_of_path(made.rows[i]) + ": " + "XYZ"[axis] +
                                " at " + length_text(at) + " mm exceeds its travel " +
                                length_text(at < range.from ? range.from : range.to) +
                                " by " + length_text(over) + " mm; " + advice};
        }
}

void require_fit(const PartOnMachine& setup)
{
    const MachineConfiguration& configuration = setup.machine.configuration;
    if (!configuration.is_valid())
        throw GeometryError{"the machine " + configuration.word +
                            " cannot direct its tool: " + why_not_valid(configuration)};
}

}  // namespace

ToolPath linear_path(const ToolPath& path, const Cutter& cutter, double tolerance)
{
    require(std::isfinite(tolerance) && tolerance > 0,
            "linear_path: need a tolerance above 0");
    return linear_motion(path, cutter, tolerance).path;
}

double free_height(const ToolPath& path)
{
    double top = -std::numeric_limits<double>::infinity();
    for (const PathPoint& point : path.points)
        if (point.move != Move::Rapid)
            top = std::max(top, point.location.tip.z());
    return top + default_clearance_mm;
}

std::variant<MachinePath, BlockedPoint> machine_motions(const ToolPath& path,
                                                        const PartOnMachine& setup,
                                                        const MachinePathOptions& given)
{
    require_sound(given);
    require_poses(path);
    require_fit(setup);
    MachinePathOptions options = given;
    const LinearPath linear =
        linear_motion(path, options.cutter, replacing_share * options.tolerance);
    if (path.machine)
        options.tolerance *= 1 - replacing_share;
    const PathNodes found = path_nodes(linear.path, setup, options);
    std::vector<SearchPose> poses =
        search_poses(found.nodes, linear.path, options, false);
    const std::array<RotaryRange, 2> ranges = ranges_of(setup.machine);
    BranchSearch search = search_branches(poses, ranges);
    if (search.blocked && options.retract) {
        poses = search_poses(found.nodes, linear.path, options, true);
        search = search_branches(poses, ranges);
    }
    if (search.blocked)
        return BlockedPoint{linear.rows[found.nodes[search.blocked->pose].row],
                            search.blocked->axis, search.blocked->position,
                            search.blocked->limit};
    MachinePath made =
        PathMover{linear.path, found.nodes, setup, options}.move(search.choices, poses);
    for (std::size_t& row : made.rows)
        row = linear.rows[row];
    made.report.retracts = search.retracts;
    made.report.branch_changes = search.branch_changes;
    made.report.rotary_travel = search.travel;
    made.report.singular_points = found.singular_points;
    return made;
}

MachinePath machine_path(const ToolPath& path, const PartOnMachine& setup,
                         const MachinePathOptions& options)
{
    std::variant<MachinePath, BlockedPoint> motions =
        machine_motions(path, setup, options);
    if (const auto* blocked = std::get_if<BlockedPoint>(&motions))
        refuse_blocked(*blocked, setup.machine, options.retract.has_value());
    auto& made = std::get<MachinePath>(motions);
    require_travel(made, setup);
    return std::move(made);
}

}  // namespace endmill
