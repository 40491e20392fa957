// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/branch_search.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <tuple>

// The poses are the layers of a graph; the states of a layer are a solution and a number of
// full rotations of each limited axis. A pose at which the axes may turn has two layers, one
// for arrival and one for departure. The cost of the best way to each state of a layer
// follows from those of the layer before, and the way itself from the predecessors.

namespace endmill {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;
// rad, unit of travel. Sums of whole numbers do not depend on their order, so that ways of
// equal length count as equal. 1e7 poses stay below the largest number.
constexpr double travel_unit = 1e-11;
// rad, differences of positions that are equal but for rounding and full rotations.
constexpr double same_position = 1e-6;
constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

struct Cost {
    std::int64_t retracts = 0;
    std::int64_t travel = 0;
    std::int64_t changes = 0;
    std::int64_t first = 0;

    // In the order of the members.
    friend bool operator<(const Cost& a, const Cost& b)
    {
        return std::tie(a.retracts, a.travel, a.changes, a.first) <
               std::tie(b.retracts, b.travel, b.changes, b.first);
    }
};

struct State {
    std::size_t branch;
    RotaryPositions at;             // rad
    std::optional<Cost> cost = {};  // of the best way to it; none: not reached
    std::size_t from = none;        // its predecessor in the layer before
};

using Layer = std::vector<State>;

std::int64_t in_units(double travel)
{
    return std::llround(std::abs(travel) / travel_unit);
}

// The difference nearest to zero; a half rotation is positive.
double nearest(double difference)
{
    const double turn = std::remainder(difference, full_turn);
    return turn == -std::numbers::pi ? std::numbers::pi : turn;
}

class Search {
public:
    Search(std::span<const SearchPose> poses, const std::array<RotaryRange, 2>& ranges)
        : poses_{poses},
          ranges_{ranges}
    {
    }

    BranchSearch run()
    {
        arrivals_.resize(poses_.size());
        departures_.resize(poses_.size());
        for (std::size_t i = 0; i < poses_.size(); ++i) {
            arrivals_[i] = states(poses_[i], poses_[i].arrival);
            if (i == 0)
                begin(arrivals_[i]);
            else
                connect(i);
            if (std::ranges::none_of(arrivals_[i],
                                     [](const State& s) { return s.cost.has_value(); }))
                return {.choices = {}, .blocked = blocked(i)};
            if (poses_[i].turn != PoseTurn::None)
                turn(i);
        }
        return choices();
    }

private:
    bool is_limited(std::size_t axis) const { return std::isfinite(ranges_[axis].from); }

    // All positions of one axis within its limits that equal `at` up to full rotations.
    std::vector<double> positions(std::size_t axis, double at) const
    {
        if (!is_limited(axis))
            return {nearest(at)};
        const RotaryRange& range = ranges_[axis];
        const auto first = static_cast<std::int64_t>(
            std::ceil((range.from - turn_tolerance - at) / full_turn));
        const auto last = static_cast<std::int64_t>(
            std::floor((range.to + turn_tolerance - at) / full_turn));
        std::vector<double> found;
        found.reserve(
            static_cast<std::size_t>(std::max<std::int64_t>(0, last - first + 1)));
        for (std::int64_t k = first; k <= last; ++k)
            found.push_back(at + static_cast<double>(k) * full_turn);
        return found;
    }

    Layer states(const SearchPose& pose,
                 const std::array<RotaryPositions, 2>& solutions) const
    {
        Layer layer;
        for (std::size_t branch = 0; branch < pose.branches; ++branch)
            for (const double first : positions(0, solutions[branch][0]))
                for (const double second : positions(1, solutions[branch][1]))
                    layer.push_back({branch, {first, second}});
        return layer;
    }

    static void begin(Layer& layer)
    {
        for (State& state : layer)
            state.cost =
                Cost{.first = in_units(std::abs(state.at[0]) + std::abs(state.at[1]))};
    }

    // The states from which the motion to the next pose begins.
    const Layer& last_layer(std::size_t pose) const
    {
        return poses_[pose].turn == PoseTurn::None ? arrivals_[pose] : departures_[pose];
    }

    // Turns of both axes between two poses. The other solution turns equally far, so that
    // both have exactly the same cost.
    RotaryPositions between(std::size_t pose, std::size_t branch) const
    {
        const RotaryPositions& from = poses_[pose - 1].departure[branch];
        const RotaryPositions& to = poses_[pose].arrival[branch];
        return {nearest(to[0] - from[0]), nearest(to[1] - from[1])};
    }

    void connect(std::size_t pose)
    {
        const Layer& before = last_layer(pose - 1);
        const RotaryPositions first = between(pose, 0);
        const std::int64_t travel = in_units(first[0]) + in_units(first[1]);
        for (std::size_t s = 0; s < before.size(); ++s) {
            if (!before[s].cost || before[s].branch >= poses_[pose].branches)
                continue;
            const RotaryPositions turn = between(pose, before[s].branch);
            State* const to =
                find(arrivals_[pose], before[s].branch,
                     {before[s].at[0] + turn[0], before[s].at[1] + turn[1]});
            if (to == nullptr)
                continue;
            Cost cost = *before[s].cost;
            cost.travel += travel;
            improve(*to, cost, s);
        }
    }

    State* find(Layer& layer, std::size_t branch, const RotaryPositions& at) const
    {
        for (State& state : layer)
            if (state.branch == branch && is_same(0, state.at[0], at[0]) &&
                is_same(1, state.at[1], at[1]))
                return &state;
        return nullptr;
    }

    bool is_same(std::size_t axis, double first, double second) const
    {
        const double off = first - second;
        return std::abs(is_limited(axis) ? off : std::remainder(off, full_turn)) <
               same_position;
    }

    static void improve(State& to, const Cost& cost, std::size_t from)
    {
        if (to.cost && !(cost < *to.cost))
            return;
        to.cost = cost;
        to.from = from;
    }

    // From every state of arrival to every state of departure.
    void turn(std::size_t pose)
    {
        departures_[pose] = states(poses_[pose], poses_[pose].departure);
        const Layer& before = arrivals_[pose];
        const bool leaves_part = poses_[pose].turn == PoseTurn::Retract;
        for (State& to : departures_[pose])
            for (std::size_t s = 0; s < before.size(); ++s) {
                if (!before[s].cost)
                    continue;
                Cost cost = *before[s].cost;
                std::int64_t travel = 0;
                for (std::size_t axis = 0; axis < 2; ++axis)
                    travel += in_units(turned(axis, before[s].at[axis], to.at[axis]));
                cost.travel += travel;
                cost.changes += to.branch != before[s].branch ? 1 : 0;
                cost.retracts += leaves_part && travel > 0 ? 1 : 0;
                improve(to, cost, s);
            }
    }

    double turned(std::size_t axis, double from, double to) const
    {
        return is_limited(axis) ? to - from : nearest(to - from);
    }

    // Positions of a blocked pose, and by how much they exceed their limit.
    struct Excess {
        BlockedPose at;
        double excess;  // rad
    };

    // Keeps positions if they exceed their limits, and by less than those found so far.
    void consider(const RotaryPositions& at, Excess& closest) const
    {
        Excess worst{.at = closest.at, .excess = 0};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const RotaryRange& range = ranges_[axis];
            const double over = std::max(range.from - at[axis], at[axis] - range.to);
            if (over <= worst.excess)
                continue;
            const double limit = at[axis] < range.from ? range.from : range.to;
            worst = {.at = {closest.at.pose, axis, at[axis], limit}, .excess = over};
        }
        if (worst.excess > 0 && worst.excess < closest.excess)
            closest = worst;
    }

    // The positions that exceed a limit the least: those that continue the best ways so
    // far, or where the pose itself is out of reach, those of the pose.
    BlockedPose blocked(std::size_t pose) const
    {
        Excess closest{.at = {pose, 0, 0, 0},
                       .excess = std::numeric_limits<double>::infinity()};
        if (pose == 0 || arrivals_[pose].empty()) {
            consider_all(poses_[pose], closest);
            return closest.at;
        }
        for (const State& state : last_layer(pose - 1)) {
            if (!state.cost || state.branch >= poses_[pose].branches)
                continue;
            const RotaryPositions turn = between(pose, state.branch);
            consider({state.at[0] + turn[0], state.at[1] + turn[1]}, closest);
        }
        return closest.at;
    }

    void consider_all(const SearchPose& pose, Excess& closest) const
    {
        for (std::size_t branch = 0; branch < pose.branches; ++branch)
            for (const double first : {-full_turn, 0.0, full_turn})
                for (const double second : {-full_turn, 0.0, full_turn})
                    consider({nearest(pose.arrival[branch][0]) + first,
                              nearest(pose.arrival[branch][1]) + second},
                             closest);
    }

    BranchSearch choices() const
    {
        BranchSearch found;
        found.choices.resize(poses_.size());
        if (poses_.empty())
            return found;
        const Layer& end = last_layer(poses_.size() - 1);
        const auto cheaper = [](const State& first, const State& second) {
            return first.cost && (!second.cost || *first.cost < *second.cost);
        };
        const auto best = std::ranges::min_element(end, cheaper);
        found.retracts = static_cast<std::size_t>(best->cost->retracts);
        found.branch_changes = static_cast<std::size_t>(best->cost->changes);
        auto state = static_cast<std::size_t>(best - end.begin());
        for (std::size_t i = poses_.size(); i-- > 0;) {
            BranchChoice& choice = found.choices[i];
            choice.departure = last_layer(i)[state].at;
            choice.departure_branch = last_layer(i)[state].branch;
            if (poses_[i].turn != PoseTurn::None)
                state = departures_[i][state].from;
            choice.arrival = arrivals_[i][state].at;
            choice.arrival_branch = arrivals_[i][state].branch;
            state = arrivals_[i][state].from;
        }
        unwrap(found);
        return found;
    }

    // Adds full rotations to the positions of axes without limits, so that each motion is
    // the one that was counted, and sums up the travel.
    void unwrap(BranchSearch& found) const
    {
        RotaryPositions at = found.choices.front().arrival;
        for (std::size_t i = 0; i < poses_.size(); ++i) {
            BranchChoice& choice = found.choices[i];
            for (std::size_t axis = 0; axis < 2; ++axis) {
                double by = 0;
                if (i > 0)
                    by = between(i, choice.arrival_branch)[axis];
                const double arrival =
                    is_limited(axis) ? choice.arrival[axis] : at[axis] + by;
                const double change =
                    turned(axis, choice.arrival[axis], choice.departure[axis]);
                found.travel += std::abs(by) + std::abs(change);
                choice.arrival[axis] = arrival;
                choice.departure[axis] = arrival + change;
                at[axis] = choice.departure[axis];
            }
        }
    }

    std::span<const SearchPose> poses_;
    std::array<RotaryRange, 2> ranges_;
    std::vector<Layer> arrivals_;
    std::vector<Layer> departures_;  // of poses with a turn only
};

}  // namespace

BranchSearch search_branches(std::span<const SearchPose> poses,
                             const std::array<RotaryRange, 2>& ranges)
{
    return Search{poses, ranges}.run();
}

}  // namespace endmill
