// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/several_setups.h"

#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "endmill/machine/axis_limits.h"
#include "endmill/setup/detail/pole_points.h"

namespace endmill {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::size_t turns = turns_about_tool_axis;

double azimuth_of(std::size_t turn)
{
    return 2 * pi * static_cast<double>(turn) / static_cast<double>(turns);
}

// Among the angles from 0 to pi those up to `end`, and those that are a turn on from what is
// not below `begin`.
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

    // The angle whose sine and cosine are in this ratio. \pre sine >= 0.
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

// `turn_within` for atan2(sine, cosine), without that.
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

// A cell about the tool axis; R1 or R2 at azimuth a has it `along` itself and `across`.
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
    explicit Reach(const SetupReach& reach)
        : is_ca_{reach.axes == 5 && reach.family == RotaryFamily::CA},
          second_sign_{reach.is_b_first ? -1.0 : 1.0},
          phi_{reach.limits.phi},
          theta_{reach.axes == 4 ? RotaryRange{-reach.arc_tolerance.radians(),
                                               reach.arc_tolerance.radians()}
                                 : reach.limits.theta}
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
    std::size_t begin = 0;  // after a turn that is not feasible
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

RotaryFrame frame_at(const SetupReach& reach, const Vec3& tool_axis, std::size_t turn)
{
    const Vec3 across = PoleFrame{tool_axis}.equator(azimuth_of(turn));
    if (reach.axes == 5 && reach.family == RotaryFamily::CA)
        return {RotaryFamily::CA, tool_axis, tool_axis, across};
    const Vec3 r2 = tool_axis.cross(across);
    return {RotaryFamily::AB, tool_axis, across, reach.is_b_first ? Vec3{-r2} : r2};
}

std::vector<FeasibleTurns> feasible_turns(const SetupReach& reach,
                                          std::span<const Vec3> centres, std::size_t pole)
{
    if (reach.axes == 3)
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
