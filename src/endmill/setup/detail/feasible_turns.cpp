// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/feasible_turns.h"

#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "endmill/machine/axis_limits.h"
#include "endmill/setup/detail/pole_points.h"

// How the feasible turns of a cell are found.
//
// The angles of a cell depend on the turn about the tool axis only through sin and cos of
// its azimuth against R1 or R2. For each of the 72 turns:
// 1. The products `along` and `across` give sine and cosine of the angle, up to a common
//    factor.
// 2. TurnRange tests whether that angle lies within the limits. It compares the signs of
//    sin(end - angle) and sin(angle - begin), so that no arc tangent is needed.
// 3. In C,A both solutions count, (phi, theta) and (-phi, theta + 180 degrees); phi does
//    not depend on the turn. In A,B the first solution counts. Neighbouring feasible
//    turns are joined to runs.

namespace endmill {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::size_t turns = turns_about_tool_axis;

double azimuth_of(std::size_t turn)
{
    return 2 * pi * static_cast<double>(turn) / static_cast<double>(turns);
}

// The angles within [0, pi] that equal an angle of [begin, end] up to whole turns: those
// up to `end`, and if the range begins below -pi also those from begin + 2 pi on.
class HalfRange {
public:
    // \pre begin <= 0 <= end, rad
    HalfRange(double begin, double end)
        : holds_all_{end >= pi || begin <= -2 * pi},
          holds_far_{begin <= -pi},
          sine_{std::sin(end)},
          cosine_{std::cos(end)},
          far_sine_{std::sin(begin)},
          far_cosine_{std::cos(begin)}
    {
    }

    // Tests the angle atan2(sine, cosine). \pre sine >= 0.
    bool holds(double sine, double cosine) const
    {
        return holds_all_ || cosine * sine_ - sine * cosine_ >= 0 ||
               (holds_far_ && sine * far_cosine_ - cosine * far_sine_ >= 0);
    }

private:
    bool holds_all_;
    bool holds_far_;
    double sine_;
    double cosine_;
    double far_sine_;
    double far_cosine_;
};

// Tests atan2(sine, cosine) as `turn_within` does, without computing it.
class TurnRange {
public:
    explicit TurnRange(const RotaryRange& range)
        : left_{range.from - turn_tolerance, range.to + turn_tolerance},
          right_{-range.to - turn_tolerance, -range.from + turn_tolerance}
    {
    }

    bool holds(double sine, double cosine) const
    {
        return sine >= 0 ? left_.holds(sine, cosine) : right_.holds(-sine, cosine);
    }

private:
    HalfRange left_;
    HalfRange right_;
};

// A cell in the frame of the tool axis. `along` and `across` are its components along a
// rotary axis that is perpendicular to the tool axis, and across both.
struct SeenFrom {
    double x;
    double y;
    double z;

    double along(const Vec3& axis) const { return x * axis.x() + y * axis.y(); }
    double across(const Vec3& axis) const { return x * axis.y() - y * axis.x(); }
};

using IsFeasible = std::array<bool, turns>;

class Reach {
public:
    explicit Reach(const RotaryReach& reach)
        : is_ca_{reach.configuration.family == RotaryFamily::CA},
          second_sign_{rotary_order(reach.configuration) == RotaryOrder::BFirst ? -1.0
                                                                                : 1.0},
          phi_{reach.limits.phi},
          theta_{reach_limits(reach).theta}
    {
        for (std::size_t turn = 0; turn < turns; ++turn)
            axes_[turn] = {std::cos(azimuth_of(turn)), std::sin(azimuth_of(turn)), 0};
    }

    IsFeasible feasible(const SeenFrom& cell) const
    {
        return is_ca_ ? by_sectors(cell) : by_rectangles(cell);
    }

private:
    IsFeasible by_sectors(const SeenFrom& cell) const
    {
        const double off = std::hypot(cell.x, cell.y);
        const bool is_first = phi_.holds(off, cell.z);
        const bool is_other = phi_.holds(-off, cell.z);
        IsFeasible feasible{};
        if (off < turn_tolerance) {
            feasible.fill(is_first || is_other);
            return feasible;
        }
        for (std::size_t turn = 0; turn < turns; ++turn) {
            const double sine = cell.along(axes_[turn]);
            const double cosine = cell.across(axes_[turn]);
            feasible[turn] = (is_first && theta_.holds(sine, cosine)) ||
                             (is_other && theta_.holds(-sine, -cosine));
        }
        return feasible;
    }

    IsFeasible by_rectangles(const SeenFrom& cell) const
    {
        IsFeasible feasible{};
        for (std::size_t turn = 0; turn < turns; ++turn) {
            const double across = cell.across(axes_[turn]);
            feasible[turn] = phi_.holds(across, cell.z) &&
                             theta_.holds(second_sign_ * cell.along(axes_[turn]),
                                          std::sqrt(across * across + cell.z * cell.z));
        }
        return feasible;
    }

    bool is_ca_;
    double second_sign_;
    TurnRange phi_;
    TurnRange theta_;
    std::array<Vec3, turns> axes_;
};

void add_runs(const IsFeasible& feasible, std::size_t cell,
              std::vector<FeasibleTurns>& runs)
{
    const auto number = static_cast<std::uint32_t>(cell);
    std::size_t begin = 0;  // becomes a turn that is not feasible, if there is one
    while (begin < turns && feasible[begin])
        ++begin;
    if (begin == turns) {
        runs.push_back({number, 0, std::uint8_t{turns}});
        return;
    }
    std::size_t count = 0;
    for (std::size_t i = begin + 1; i <= begin + turns; ++i) {
        if (feasible[i % turns]) {
            ++count;
        } else if (count > 0) {
            runs.push_back({number, static_cast<std::uint8_t>((i - count) % turns),
                            static_cast<std::uint8_t>(count)});
            count = 0;
        }
    }
}

}  // namespace

RotaryFrame frame_at(const RotaryReach& reach, const Vec3& tool_axis, std::size_t turn)
{
    const Vec3 across = PoleFrame{tool_axis}.equator(azimuth_of(turn));
    if (reach.configuration.family == RotaryFamily::CA)
        return {RotaryFamily::CA, tool_axis, tool_axis, across};
    const Vec3 r2 = tool_axis.cross(across);
    return {RotaryFamily::AB, tool_axis, across,
            rotary_order(reach.configuration) == RotaryOrder::BFirst ? Vec3{-r2} : r2};
}

std::vector<FeasibleTurns> feasible_turns(const RotaryReach& reach,
                                          std::span<const Vec3> centres, std::size_t pole)
{
    if (reach.configuration.rotary.empty())
        return {{static_cast<std::uint32_t>(pole), 0, std::uint8_t{turns}}};
    const PolePoints points{centres[pole], centres};
    const Reach within{reach};
    IsFeasible all;
    all.fill(true);
    std::vector<FeasibleTurns> runs;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const SeenFrom cell{points.x[i], points.y[i], points.z[i]};
        add_runs(i == pole ? all : within.feasible(cell), i, runs);
    }
    return runs;
}

}  // namespace endmill
