// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/joint_bound.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace endmill {
namespace {

// A curve with second derivative at most m leaves its chord by at most m / 8.
constexpr double chord_share = 8;

// Sums of the turns of the rotary axes, by side.
struct Turns {
    double part = 0;  // rad
    double tool = 0;  // rad
};

Turns turns_between(const PartOnMachine& setup, const AxisPositions& from,
                    const AxisPositions& to)
{
    Turns turns;
    const auto& rotary = setup.machine.configuration.rotary;
    for (std::size_t k = 0; k < rotary.size(); ++k)
        (rotary[k].side == MachineSide::Table ? turns.part : turns.tool) +=
            std::abs(to.rotary[k] - from.rotary[k]);
    return turns;
}

}  // namespace

double JointBound::tip_error(double middle) const
{
    return std::min(second, middle + third / 2) / chord_share;
}

double JointBound::axis_error(double angle) const
{
    return (rotary_turn * rotary_turn + angle * angle) / chord_share;
}

JointBound joint_bound(const PartOnMachine& setup, const AxisPositions& from,
                       const AxisPositions& to)
{
    const Turns turns = turns_between(setup, from, to);
    const double a = turns.part;
    const double b = turns.tool;
    if (a == 0 && b == 0)
        return {};
    const Machine& machine = setup.machine;
    const double offset = machine.axis_offset.norm();
    const double L = machine.pivot + setup.tool_length;
    const double arm = std::abs(L) + offset;
    const double way = (to.xyz - from.xyz).norm() + arm * b;
    const Vec3 centre = machine.table_offset + machine.axis_offset;
    // Between its ends the tip is at most half of its way further than at one of them.
    const double reach = std::max((tip_over_bed(setup, from) - centre).norm(),
                                  (tip_over_bed(setup, to) - centre).norm()) +
                         way / 2 + offset;
    return {.second = a * a * reach + 2 * a * way + arm * b * b,
            .third = a * a * a * reach + 3 * a * a * way + 3 * a * arm * b * b +
                     arm * b * b * b,
            .rotary_turn = a + b};
}

double middle_acceleration(const PartOnMachine& setup, const AxisPositions& from,
                           const AxisPositions& to)
{
    AxisPositions middle{.xyz = (from.xyz + to.xyz) / 2};
    AxisPositions rates{.xyz = to.xyz - from.xyz};
    for (std::size_t k = 0; k < middle.rotary.size(); ++k) {
        middle.rotary[k] = (from.rotary[k] + to.rotary[k]) / 2;
        rates.rotary[k] = to.rotary[k] - from.rotary[k];
    }
    return tip_motion(setup, middle, rates).acceleration.norm();
}

}  // namespace endmill
