// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/path_nodes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "endmill/core/error.h"
#include "endmill/core/text.h"

// Along a great arc the first rotary axis turns by at most 90 degrees on either side of the
// point closest to the singular directions. A move on which an axis turns far is divided
// there, and into parts of a limited angle.

namespace endmill {
namespace {

// rad, turn of the first axis, and angle of the tool axis, from which a move is divided.
constexpr double large_turn = Angle::degrees(45).radians();
constexpr double largest_angle = Angle::degrees(60).radians();
// rad, axes at a larger angle count as opposite: the great arc is not determined.
constexpr double opposite_angle = Angle::degrees(179.9).radians();

class NodeMaker {
public:
    NodeMaker(const ToolPath& path, const PartOnMachine& setup,
              const MachinePathOptions& options)
        : path_{path},
          setup_{setup},
          options_{options},
          frame_{machine_frame(setup.machine.configuration)},
          has_two_axes_{setup.machine.configuration.rotary.size() == 2}
    {
    }

    PathNodes make()
    {
        found_.nodes.reserve(path_.points.size());
        add(path_.points.front().location, 0, true);
        for (std::size_t row = 1; row < path_.points.size(); ++row)
            add_move(row);
        return std::move(found_);
    }

private:
    void add_move(std::size_t row)
    {
        const CutterLocation& from = path_.points[row - 1].location;
        const CutterLocation& to = path_.points[row].location;
        const double angle = angle_between(from.axis, to.axis);
        if (angle > opposite_angle)
            throw GeometryError{
                point_of_path(row) + ": the axis turns by " + degrees_text(angle) +
                " degrees from the point before, and opposite axes have no "
                "great arc between them; expected a point between"};
        for (const double u : inner_parameters(from.axis, to.axis, angle))
            add({.tip = (1 - u) * from.tip + u * to.tip,
                 .axis = axis_on_arc(from.axis, to.axis, u)},
                row, false);
        add(to, row, true);
    }

    // Parameters at which a move is divided, ascending, without its ends.
    std::vector<double> inner_parameters(const Vec3& from, const Vec3& to,
                                         double angle) const
    {
        std::vector<double> inner;
        if (angle == 0 || !has_two_axes_)
            return inner;
        const std::array<double, 2> first{first_turn(from), first_turn(to)};
        const double turn =
            std::abs(std::remainder(first[1] - first[0], 2 * std::numbers::pi));
        if (turn > large_turn)
            if (const auto closest = closest_to_singular(from, to, angle))
                inner.push_back(*closest);
        const auto parts = static_cast<int>(std::ceil(angle / largest_angle));
        for (int k = 1; k < parts; ++k)
            inner.push_back(static_cast<double>(k) / parts);
        std::ranges::sort(inner);
        const auto same = [](double before, double after) {
            return after - before < turn_tolerance;
        };
        inner.erase(std::unique(inner.begin(), inner.end(), same), inner.end());
        return inner;
    }

    // The turn of the first rotary axis.
    double first_turn(const Vec3& axis) const
    {
        const RotaryAngles angles = rotary_angles(frame_, setup_.part_to_machine * axis);
        return frame_.family == RotaryFamily::CA ? angles.theta : angles.phi;
    }

    // The parameter at which the arc is closest to a singular direction; nothing if that is
    // one of its ends.
    std::optional<double> closest_to_singular(const Vec3& from, const Vec3& to,
                                              double angle) const
    {
        const Vec3 across = (to - std::cos(angle) * from) / std::sin(angle);
        const Vec3 singular = setup_.part_to_machine.transpose() * frame_.r1_axis;
        const double nearest = std::atan2(across.dot(singular), from.dot(singular));
        for (const double at :
             {nearest, nearest - std::numbers::pi, nearest + std::numbers::pi})
            if (at > turn_tolerance && at < angle - turn_tolerance)
                return at / angle;
        return std::nullopt;
    }

    void add(CutterLocation pose, std::size_t row, bool is_row_end)
    {
        double distance = distance_of(pose.axis);
        const bool is_in_cone =
            distance > 0 && distance <= std::sin(options_.singular_cone.radians());
        if (options_.singular != SingularRule::Exact && is_in_cone) {
            found_.singular_points += distance > turn_tolerance ? 1 : 0;
            pose = singular_pose(pose);
            distance = 0;
        }
        const auto solutions = rotary_solutions(setup_, pose.axis);
        if (solutions.empty())
            throw GeometryError{point_of_path(row) + ": the axis " +
                                shown_vector(pose.axis) +
                                " leaves the plane in which the machine " +
                                setup_.machine.configuration.word +
                                " tilts its tool; expected a machine with one more "
                                "rotary axis"};
        PathNode node{.pose = pose,
                      .row = row,
                      .is_row_end = is_row_end,
                      .distance_from_singular = distance,
                      .solutions = {},
                      .branches = solutions.size()};
        for (std::size_t k = 0; k < solutions.size(); ++k)
            node.solutions[k] = solutions[k].positions;
        found_.nodes.push_back(node);
    }

    double distance_of(const Vec3& axis) const
    {
        return has_two_axes_
                   ? distance_from_singular(frame_, setup_.part_to_machine * axis)
                   : 1;
    }

    // The pose along the nearest singular direction with the same reference point.
    CutterLocation singular_pose(const CutterLocation& pose) const
    {
        Vec3 axis = setup_.part_to_machine.transpose() * frame_.r1_axis;
        if (axis.dot(pose.axis) < 0)
            axis = -axis;
        return {.tip = pose.tip + options_.cutter.corner_radius() * (pose.axis - axis),
                .axis = axis};
    }

    static std::string shown_vector(const Vec3& v)
    {
        return to_text(v.x()) + ", " + to_text(v.y()) + ", " + to_text(v.z());
    }

    const ToolPath& path_;
    const PartOnMachine& setup_;
    const MachinePathOptions& options_;
    RotaryFrame frame_;
    bool has_two_axes_;
    PathNodes found_;
};

// Sets the positions of the first axis in the run of singular nodes from `begin` to `end`:
// those with which the path comes, and at the end those with which it goes on.
void fill_singular_run(std::vector<SearchPose>& poses, std::size_t begin, std::size_t end,
                       PoseTurn turn)
{
    const bool has_before = begin > 0;
    const bool has_after = end < poses.size();
    for (std::size_t branch = 0; branch < 2; ++branch) {
        double first = poses[begin].arrival[branch][0];
        if (has_before)
            first = poses[begin - 1].departure[branch][0];
        else if (has_after)
            first = poses[end].arrival[branch][0];
        for (std::size_t k = begin; k < end; ++k)
            poses[k].arrival[branch][0] = poses[k].departure[branch][0] = first;
        if (has_before && has_after)
            poses[end - 1].departure[branch][0] = poses[end].arrival[branch][0];
    }
    if (has_before && has_after)
        poses[end - 1].turn = turn;
}

// Whether the axes may turn at a node because the tool is in the air: between two rapids
// above the free height.
bool is_in_air(const std::vector<PathNode>& nodes, const ToolPath& path, std::size_t node,
               double free_height)
{
    if (node + 1 >= nodes.size() || nodes[node].pose.tip.z() < free_height)
        return false;
    const bool comes_rapidly =
        nodes[node].row > 0 && path.points[nodes[node].row].move == Move::Rapid;
    return comes_rapidly && path.points[nodes[node + 1].row].move == Move::Rapid;
}

}  // namespace

std::string point_of_path(std::size_t row)
{
    return "point " + std::to_string(row) + " of the path";
}

std::string degrees_text(double radians)
{
    constexpr double steps = 1e6;
    return to_text(std::round(Angle::radians(radians).degrees() * steps) / steps);
}

PathNodes path_nodes(const ToolPath& path, const PartOnMachine& setup,
                     const MachinePathOptions& options)
{
    return NodeMaker{path, setup, options}.make();
}

std::vector<SearchPose> search_poses(const std::vector<PathNode>& nodes,
                                     const ToolPath& path,
                                     const MachinePathOptions& options, bool may_retract)
{
    std::vector<SearchPose> poses(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i)
        poses[i] = {.arrival = nodes[i].solutions,
                    .departure = nodes[i].solutions,
                    .branches = nodes[i].branches,
                    .turn = may_retract ? PoseTurn::Retract : PoseTurn::None};
    const PoseTurn at_singular =
        options.singular == SingularRule::Retract ? PoseTurn::Retract : PoseTurn::Free;
    for (std::size_t begin = 0; begin < nodes.size(); ++begin) {
        std::size_t end = begin;
        while (end < nodes.size() && nodes[end].is_singular())
            ++end;
        if (end > begin)
            fill_singular_run(poses, begin, end, at_singular);
        begin = std::max(begin, end);
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (options.free_height && is_in_air(nodes, path, i, *options.free_height))
            poses[i].turn = PoseTurn::Free;
        // Within the cone a change of the solution tilts the axis by at most twice its
        // distance from the singular direction.
        const double moved =
            2 * options.cutter.radius() * nodes[i].distance_from_singular;
        const bool is_close =
            nodes[i].distance_from_singular <= std::sin(options.singular_cone.radians());
        if (!nodes[i].is_singular() && is_close && moved <= options.tolerance)
            poses[i].turn = PoseTurn::Free;
    }
    return poses;
}

}  // namespace endmill
