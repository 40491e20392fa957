// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/clamping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "endmill/core/parallel.h"
#include "endmill/setup/detail/distinct_cones.h"
#include "endmill/setup/detail/extreme_points.h"
#include "endmill/setup/detail/linear_maximum.h"
#include "endmill/setup/setup_travel.h"

// The first linear programs have four unknowns: the clamping position s and a length t.
// 1. t becomes the greatest common slack of the axes that are not settled.
// 2. An axis whose slack cannot exceed t while the others keep it is settled at t.
// 3. This is repeated with the other axes, until all are settled.
// 4. Of the positions at which all axes keep their slack, a last program finds the one
//    nearest to the wanted position.

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// Slack in mm that a later program may lose to an earlier one. It keeps programs soluble
// in spite of rounding, and is far below travel_rounding.
constexpr double given_up = 1e-8;
// Difference in mm up to which a greater slack counts as none.
constexpr double same_slack = 1e-7;
// Number of poses that are examined together. It does not depend on the number of
// threads, and so neither does the number of poses examined.
constexpr std::size_t batch = 64;

// What a program demands of an axis: a slack of `least`, to which t is added if the axis
// shares it.
struct AxisDemand {
    double least = 0;
    bool shares_t = false;
};

using AxisDemands = std::array<AxisDemand, 3>;

class ClampingProgram {
public:
    explicit ClampingProgram(std::span<const ClampingBound> bounds) : bounds_{bounds} {}

    bool limits(int axis) const
    {
        return std::ranges::any_of(
            bounds_, [&](const ClampingBound& bound) { return bound.axis == axis; });
    }

    // The greatest t, and a clamping position for it.
    std::optional<Eigen::VectorXd> greatest(const AxisDemands& demands) const
    {
        LinearMaximum problem = program(demands, 4, 0);
        problem.objective = Eigen::Vector4d{0, 0, 0, 1};
        return linear_maximum(problem);
    }

    // The position nearest to `wanted` that meets the demands. Its unknowns are s and the
    // three coordinate differences, whose sum becomes least.
    std::optional<Eigen::VectorXd> nearest(const AxisDemands& demands,
                                           const Vec3& wanted) const
    {
        LinearMaximum problem = program(demands, 6, 6);
        Eigen::Index row = problem.rows.rows() - 6;
        for (int k = 0; k < 3; ++k)
            for (const int sign : {1, -1}) {
                problem.rows(row, k) = sign;
                problem.rows(row, 3 + k) = -1;
                problem.limits[row++] = sign * wanted[k];
            }
        problem.objective = Eigen::VectorXd::Zero(6);
        problem.objective.tail<3>().setConstant(-1);
        return linear_maximum(problem);
    }

private:
    // The inequalities of the demands, and `more` empty rows after them. The first three
    // unknowns are s, the fourth is t if an axis shares it.
    LinearMaximum program(const AxisDemands& demands, Eigen::Index unknowns,
                          Eigen::Index more) const
    {
        LinearMaximum problem;
        const auto most = static_cast<Eigen::Index>(2 * bounds_.size());
        problem.rows = Eigen::MatrixXd::Zero(most + more, unknowns);
        problem.limits = Eigen::VectorXd::Zero(most + more);
        Eigen::Index row = 0;
        const auto add = [&](const Vec3& direction, double limit, const AxisDemand& own) {
            if (limit == infinity)
                return;
            problem.rows.row(row).head<3>() = direction.transpose();
            problem.rows(row, 3) = own.shares_t ? 1 : 0;
            problem.limits[row++] = limit - own.least;
        };
        for (const ClampingBound& bound : bounds_) {
            const AxisDemand& own = demands[static_cast<std::size_t>(bound.axis)];
            add(bound.direction, bound.high, own);
            add(-bound.direction, -bound.low, own);
        }
        problem.rows.conservativeResize(row + more, Eigen::NoChange);
        problem.limits.conservativeResize(row + more);
        return problem;
    }

    std::span<const ClampingBound> bounds_;
};

// Settles the slack of all axes, the least one first.
AxisDemands settled_slacks(const ClampingProgram& program)
{
    AxisDemands settled;
    std::vector<int> open;
    for (int axis = 0; axis < 3; ++axis)
        if (program.limits(axis))
            open.push_back(axis);
    while (!open.empty()) {
        AxisDemands shared = settled;
        for (const int axis : open)
            shared[static_cast<std::size_t>(axis)] = {0, true};
        const auto common = program.greatest(shared);
        const double t = common ? (*common)[3] - given_up : -infinity;
        // The slack that each axis can have if the others keep t.
        std::vector<std::pair<double, int>> alone;
        for (const int axis : open) {
            AxisDemands own = settled;
            for (const int other : open)
                own[static_cast<std::size_t>(other)] = {t, false};
            own[static_cast<std::size_t>(axis)] = {0, true};
            const auto best = program.greatest(own);
            alone.emplace_back(best ? (*best)[3] : t, axis);
        }
        const double least = std::ranges::min(alone).first;
        for (const auto& [slack, axis] : alone)
            if (slack <= least + same_slack) {
                settled[static_cast<std::size_t>(axis)] = {t, false};
                std::erase(open, axis);
            }
    }
    return settled;
}

}  // namespace

ClampingSearch::ClampingSearch(const TriangleMesh& part, const PartVisibility& visibility,
                               std::span<const Vec3> centres, const Machine& machine,
                               const RotaryLimits& limits, double tool_length)
    : centres_{centres},
      machine_{machine},
      limits_{limits},
      tool_length_{tool_length},
      cones_{0, centres.size()}
{
    const DistinctCones cones{visibility.map};
    cones_ = cones.map();
    hulls_.resize(cones.size());
    for (std::size_t facet = 0; facet < cones.cone_of().size(); ++facet) {
        if (cones.cone_of()[facet] == DistinctCones::none)
            continue;
        const auto [a, b, c] = part.corners(facet);
        hulls_[cones.cone_of()[facet]].push_back((a + b + c) / 3);
    }
    for (std::vector<Vec3>& hull : hulls_)
        hull = extreme_points(std::move(hull));
}

std::optional<std::vector<ClampingBound>> ClampingSearch::bounds(
    const SetupPose& pose) const
{
    const auto reaches =
        facet_reach(cones_, centres_, pose_frame(machine_.configuration, pose), limits_);
    std::vector<std::pair<std::size_t, std::size_t>> by_cell;  // cell and cone
    for (std::size_t cone = 0; cone < reaches.size(); ++cone) {
        if (!reaches[cone])
            return std::nullopt;
        by_cell.emplace_back(reaches[cone]->cell, cone);
    }
    if (by_cell.empty())
        return std::nullopt;
    std::ranges::sort(by_cell);
    const Eigen::Matrix3d turn = part_to_machine(pose, machine_.configuration);
    std::vector<ClampingBound> found;
    for (auto first = by_cell.begin(); first != by_cell.end();) {
        const auto end = std::find_if(first, by_cell.end(), [&](const auto& entry) {
            return entry.first != first->first;
        });
        const RotaryPositions rotary =
            rotary_positions(machine_.configuration, reaches[first->second]->angles);
        const auto position = [&](const Vec3& point) {
            return axis_positions(machine_, rotary, point, tool_length_).xyz;
        };
        const Vec3 origin = position(Vec3::Zero());
        for (int axis = 0; axis < 3; ++axis) {
            const LinearRange& range = machine_.linear[static_cast<std::size_t>(axis)];
            if (range == LinearRange{})
                continue;
            Vec3 direction;  // row of the rotation of the table
            for (int k = 0; k < 3; ++k)
                direction[k] = position(Vec3::Unit(k))[axis] - origin[axis];
            const Vec3 in_part = turn.transpose() * direction;
            double low = infinity;
            double high = -infinity;
            for (auto entry = first; entry != end; ++entry)
                for (const Vec3& point : hulls_[entry->second]) {
                    const double along = in_part.dot(point);
                    low = std::min(low, along);
                    high = std::max(high, along);
                }
            found.push_back({axis, direction, range.from - origin[axis] - low,
                             range.to - origin[axis] - high});
        }
        first = end;
    }
    return found;
}

std::vector<ClampingBound> clamping_bounds(const Machine& machine,
                                           std::span<const AxisPositions> positions)
{
    // A rotation of the table shares its bounds among all positions with it.
    std::map<RotaryPositions, std::array<LinearRange, 3>> boxes;
    for (const AxisPositions& at : positions) {
        constexpr LinearRange none{infinity, -infinity};
        auto& box =
            boxes.try_emplace(at.rotary, std::array{none, none, none}).first->second;
        for (int axis = 0; axis < 3; ++axis) {
            LinearRange& range = box[static_cast<std::size_t>(axis)];
            range.from = std::min(range.from, at.xyz[axis]);
            range.to = std::max(range.to, at.xyz[axis]);
        }
    }
    std::vector<ClampingBound> found;
    for (const auto& [rotary, box] : boxes) {
        const Vec3 origin = axis_positions(machine, rotary, Vec3::Zero(), 0).xyz;
        for (int axis = 0; axis < 3; ++axis) {
            const LinearRange& range = machine.linear[static_cast<std::size_t>(axis)];
            if (range == LinearRange{})
                continue;
            Vec3 direction;  // row of the rotation of the table
            for (int k = 0; k < 3; ++k)
                direction[k] =
                    axis_positions(machine, rotary, Vec3::Unit(k), 0).xyz[axis] -
                    origin[axis];
            const LinearRange& taken = box[static_cast<std::size_t>(axis)];
            found.push_back(
                {axis, direction, range.from - taken.from, range.to - taken.to});
        }
    }
    return found;
}

ClampingFit clamping_fit(std::span<const ClampingBound> bounds, const Vec3& clamp)
{
    ClampingFit fit{clamp, Vec3::Constant(infinity)};
    for (const ClampingBound& bound : bounds) {
        const double along = bound.direction.dot(clamp);
        fit.slack[bound.axis] =
            std::min({fit.slack[bound.axis], along - bound.low, bound.high - along});
    }
    return fit;
}

double greatest_slack(std::span<const ClampingBound> bounds)
{
    if (bounds.empty())
        return infinity;
    const auto best = ClampingProgram{bounds}.greatest(
        {AxisDemand{0, true}, AxisDemand{0, true}, AxisDemand{0, true}});
    return best ? (*best)[3] : -infinity;
}

ClampingFit best_clamping(std::span<const ClampingBound> bounds, const Vec3& wanted)
{
    const ClampingProgram program{bounds};
    AxisDemands demands = settled_slacks(program);
    for (AxisDemand& demand : demands)
        demand.least -= given_up;
    const auto nearest = program.nearest(demands, wanted);
    return clamping_fit(bounds, nearest ? Vec3{nearest->head<3>()} : wanted);
}

TravelSearch travel_search(const ClampingSearch& search,
                           std::span<const FittedPose> poses,
                           const std::optional<Vec3>& clamp)
{
    TravelSearch result;
    double greatest = 0;
    for (std::size_t first = 0; first < poses.size() && !result.fits(); first += batch) {
        const std::size_t count = std::min(batch, poses.size() - first);
        std::vector<std::optional<double>> slacks(count);
        parallel_for(count, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k)
                if (const auto bounds = search.bounds(poses[first + k].pose))
                    slacks[k] = clamp ? clamping_fit(*bounds, *clamp).least_slack()
                                      : greatest_slack(*bounds);
        });
        for (std::size_t k = 0; k < count && !result.fits(); ++k) {
            ++result.poses;
            if (!slacks[k]) {
                ++result.out_of_reach;
                continue;
            }
            if (result.pose && *slacks[k] <= greatest)
                continue;
            greatest = *slacks[k];
            result.pose = poses[first + k];
            const auto bounds = search.bounds(result.pose->pose);
            result.clamping = clamp ? clamping_fit(*bounds, *clamp)
                                    : best_clamping(*bounds, Vec3::Zero());
        }
    }
    return result;
}

}  // namespace endmill
