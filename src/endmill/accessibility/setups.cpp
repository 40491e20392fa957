// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/accessibility/setups.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include <Eigen/Geometry>

#include "endmill/accessibility/pole_points.h"
#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/machine/axis_limits.h"
#include "endmill/machine/rotary_angles.h"

namespace endmill {
namespace {

using Bits = std::vector<std::uint64_t>;

constexpr int turns_about_tool_axis = 72;  // of 5 degrees

// A candidate and how many facets of the rest it reaches.
struct Reached {
    std::size_t facets = 0;
    std::size_t cell = 0;
    int turn = 0;
};

RotaryFrame frame_at(const SetupReach& reach, const PoleFrame& pole, int turn)
{
    const double azimuth = 2 * std::numbers::pi * turn / turns_about_tool_axis;
    const Vec3 across = pole.equator(azimuth);
    if (reach.axes == 5 && reach.family == RotaryFamily::CA)
        return {RotaryFamily::CA, pole.pole, pole.pole, across};
    const Vec3 r2 = pole.pole.cross(across);
    return {RotaryFamily::AB, pole.pole, across, reach.is_b_first ? Vec3{-r2} : r2};
}

// Whether the direction is one that the machine's tool takes.
bool is_feasible(const SetupReach& reach, const RotaryFrame& frame, const Vec3& direction)
{
    const RotaryLimits& limits = reach.limits;
    if (reach.axes == 4) {
        const double off =
            std::asin(std::min(std::abs(direction.dot(frame.r1_axis)), 1.0));
        return off <= reach.arc_tolerance.radians() + turn_tolerance &&
               turn_within(limits.phi, rotary_angles(frame, direction).phi);
    }
    const RotaryAngles angles = rotary_angles(frame, direction);
    const auto holds = [&](const RotaryAngles& turns) {
        return turn_within(limits.phi, turns.phi) &&
               turn_within(limits.theta, turns.theta);
    };
    return holds(angles) || (frame.family == RotaryFamily::CA &&
                             holds(other_rotary_angles(frame.family, angles)));
}

class GreedyChoice {
public:
    GreedyChoice(const VisibilityMap& map, std::span<const Vec3> centres,
                 const SetupReach& reach)
        : map_{map},
          centres_{centres},
          reach_{reach},
          turns_{reach.axes == 3 ? 1 : turns_about_tool_axis},
          rest_(map.words(), 0)
    {
        for (std::size_t i = 0; i < map.cells(); ++i)
            for (std::size_t w = 0; w < map.words(); ++w)
                rest_[w] |= map.column(i)[w];
    }

    bool is_done() const
    {
        return std::ranges::all_of(rest_, [](std::uint64_t word) { return word == 0; });
    }

    PartialSetup next()
    {
        const Reached best = best_candidate();
        const RotaryFrame frame = frame_of(best);
        const Bits reached = reached_by(best.cell, frame);
        PartialSetup setup{{frame.tool_axis, frame.r1_axis, frame.r2_axis}, {}};
        setup.facets = facets_of(reached);
        for (std::size_t w = 0; w < rest_.size(); ++w)
            rest_[w] &= ~reached[w];
        return setup;
    }

    std::vector<std::size_t> rest() const { return facets_of(rest_); }

private:
    static std::vector<std::size_t> facets_of(const Bits& bits)
    {
        std::vector<std::size_t> facets;
        for (std::size_t w = 0; w < bits.size(); ++w)
            for (std::uint64_t left = bits[w]; left != 0; left &= left - 1)
                facets.push_back(64 * w +
                                 static_cast<std::size_t>(std::countr_zero(left)));
        return facets;
    }

    RotaryFrame frame_of(const Reached& candidate) const
    {
        return frame_at(reach_, PoleFrame{centres_[candidate.cell]}, candidate.turn);
    }

    // Of the rest.
    Bits reached_by(std::size_t cell, const RotaryFrame& frame) const
    {
        Bits reached(map_.words(), 0);
        const auto add = [&](std::size_t i) {
            for (std::size_t w = 0; w < reached.size(); ++w)
                reached[w] |= map_.column(i)[w] & rest_[w];
        };
        add(cell);
        for (std::size_t i = 0; reach_.axes > 3 && i < map_.cells(); ++i)
            if (is_feasible(reach_, frame, centres_[i]))
                add(i);
        return reached;
    }

    Reached best_at(std::size_t cell) const
    {
        const PoleFrame pole{centres_[cell]};
        Reached best{0, cell, 0};
        for (int turn = 0; turn < turns_; ++turn) {
            std::size_t facets = 0;
            for (const std::uint64_t word :
                 reached_by(cell, frame_at(reach_, pole, turn)))
                facets += static_cast<std::size_t>(std::popcount(word));
            if (facets > best.facets)
                best = {facets, cell, turn};
        }
        return best;
    }

    Reached best_candidate() const
    {
        std::vector<Reached> found(map_.cells());
        parallel_for(found.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t cell = begin; cell < end; ++cell)
                found[cell] = best_at(cell);
        });
        return *std::ranges::max_element(found, {}, &Reached::facets);
    }

    const VisibilityMap& map_;
    std::span<const Vec3> centres_;
    const SetupReach& reach_;
    int turns_;
    Bits rest_;
};

}  // namespace

SetupCover greedy_setups(const VisibilityMap& map, std::span<const Vec3> centres,
                         const SetupReach& reach, std::size_t most)
{
    require(centres.size() == map.cells(), "greedy_setups: need a centre for each cell");
    require(3 <= reach.axes && reach.axes <= 5, "greedy_setups: need 3, 4 or 5 axes");
    require(most >= 1, "greedy_setups: need 1 <= most");
    SetupCover cover;
    GreedyChoice choice{map, centres, reach};
    while (!choice.is_done() && cover.setups.size() < most)
        cover.setups.push_back(choice.next());
    cover.uncovered = choice.rest();
    return cover;
}

}  // namespace endmill
