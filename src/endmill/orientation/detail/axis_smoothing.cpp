// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/detail/axis_smoothing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "endmill/core/parallel.h"

namespace endmill {
namespace {

// Ways count as at least this, mm, so that a turn on the spot has a finite weight.
constexpr double least_way = 1e-3;
// A row moves by a whole, a half, a quarter or an eighth of the way to its mean.
constexpr int most_bisections = 4;
// Moves below this, in rad, are left out: the resolution of rotary axes is about 1e-6.
constexpr double least_move = 1e-6;
// Share of the sum that a round must gain for another one to follow.
constexpr double least_gain = 1e-3;

// The rows by the values that are smoothed: the unit axis, or two rotary positions and 0.
class Rows {
public:
    Rows(std::span<const SmoothedRow> rows, const SmoothingLimits& limits)
        : rows_{rows},
          limits_{limits}
    {
        values_.reserve(rows.size());
        for (const SmoothedRow& row : rows)
            values_.push_back(limits.machine ? positions(row.axis) : row.axis);
    }

    double bend() const
    {
        double sum = 0;
        for (std::size_t k = 1; k < values_.size(); ++k)
            sum += weight(k) * (values_[k] - values_[k - 1]).squaredNorm();
        return sum;
    }

    // Moves the rows first, first + 2, ... whose neighbours rest meanwhile.
    void move_every_other(std::size_t first)
    {
        const std::size_t count = (values_.size() + 1 - first) / 2;
        parallel_for(count, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k)
                move(first + 2 * k);
        });
    }

    std::vector<Vec3> axes() const
    {
        std::vector<Vec3> found;
        found.reserve(values_.size());
        for (std::size_t k = 0; k < values_.size(); ++k)
            found.push_back(is_moved_[k] ? axis_of(values_[k]) : rows_[k].axis);
        return found;
    }

private:
    // One over the way from the row before.
    double weight(std::size_t row) const
    {
        return 1 / std::max(rows_[row].way_mm - rows_[row - 1].way_mm, least_way);
    }

    Vec3 axis_of(const Vec3& value) const
    {
        if (!limits_.machine)
            return value;
        return tool_location(*limits_.machine, {{value.x(), value.y()}, Vec3::Zero()})
            .axis;
    }

    // The positions for an axis that are nearest to those of the row before.
    Vec3 positions(const Vec3& axis) const
    {
        const Vec3 before = values_.empty() ? Vec3{Vec3::Zero()} : values_.back();
        Vec3 best = before;
        double least = std::numeric_limits<double>::infinity();
        for (const RotarySolution& solution : rotary_solutions(*limits_.machine, axis)) {
            if (!solution.is_within_limits)
                continue;
            Vec3 at{0, 0, 0};
            for (int k = 0; k < 2; ++k)
                at[k] =
                    unwrapped(static_cast<std::size_t>(k),
                              solution.positions[static_cast<std::size_t>(k)], before[k]);
            const double distance = (at - before).lpNorm<1>();
            if (distance < least) {
                least = distance;
                best = at;
            }
        }
        return best;
    }

    // A position without limits may be shifted by full rotations.
    double unwrapped(std::size_t axis, double position, double before) const
    {
        const bool has_axis = axis < limits_.machine->machine.configuration.rotary.size();
        if (!has_axis || std::isfinite(position_range(limits_.machine->machine, axis).to))
            return position;
        return before + std::remainder(position - before, 2 * std::numbers::pi);
    }

    Vec3 blend(const Vec3& from, const Vec3& to, double share) const
    {
        const Vec3 mixed = from + share * (to - from);
        return limits_.machine ? mixed : Vec3{mixed.normalized()};
    }

    // The part of the sum that depends on a row.
    double local_bend(std::size_t row, const Vec3& value) const
    {
        double sum = 0;
        if (row > 0)
            sum += weight(row) * (value - values_[row - 1]).squaredNorm();
        if (row + 1 < values_.size())
            sum += weight(row + 1) * (values_[row + 1] - value).squaredNorm();
        return sum;
    }

    Vec3 mean_of_neighbours(std::size_t row) const
    {
        Vec3 sum = Vec3::Zero();
        double weights = 0;
        if (row > 0) {
            sum += weight(row) * values_[row - 1];
            weights += weight(row);
        }
        if (row + 1 < values_.size()) {
            sum += weight(row + 1) * values_[row + 1];
            weights += weight(row + 1);
        }
        const Vec3 mean = sum / weights;
        return limits_.machine ? mean : Vec3{mean.normalized()};
    }

    // Whether the turn to a neighbour is within the limit, or not larger than before.
    bool is_turn_fine(std::size_t row, std::size_t neighbour, const Vec3& axis) const
    {
        if (rows_[std::max(row, neighbour)].starts_pass)
            return true;
        const Vec3 other = axis_of(values_[neighbour]);
        const double turn = angle_between(axis, other);
        return turn <= limits_.greatest_turn ||
               turn <= angle_between(axis_of(values_[row]), other);
    }

    bool can_take(std::size_t row, const Vec3& value) const
    {
        if (!(local_bend(row, value) < local_bend(row, values_[row])))
            return false;
        const Vec3 axis = axis_of(value);
        return (row == 0 || is_turn_fine(row, row - 1, axis)) &&
               (row + 1 == values_.size() || is_turn_fine(row, row + 1, axis)) &&
               limits_.is_allowed(row, axis);
    }

    void move(std::size_t row)
    {
        const Vec3 mean = mean_of_neighbours(row);
        double share = 1;
        for (int trial = 0; trial < most_bisections; ++trial, share /= 2) {
            const Vec3 value = blend(values_[row], mean, share);
            if (!value.allFinite() || (value - values_[row]).norm() < least_move)
                return;
            if (can_take(row, value)) {
                values_[row] = value;
                is_moved_[row] = 1;
                return;
            }
        }
    }

    std::span<const SmoothedRow> rows_;
    const SmoothingLimits& limits_;
    std::vector<Vec3> values_;
    std::vector<char> is_moved_ = std::vector<char>(rows_.size(), 0);
};

}  // namespace

SmoothedAxes smooth_axes(std::span<const SmoothedRow> rows, const SmoothingLimits& limits)
{
    Rows moved{rows, limits};
    SmoothedAxes result;
    result.rough_bend = moved.bend();
    result.smooth_bend = result.rough_bend;
    while (rows.size() > 1 && result.rounds < limits.rounds) {
        moved.move_every_other(0);
        moved.move_every_other(1);
        ++result.rounds;
        const double before = result.smooth_bend;
        result.smooth_bend = std::min(before, moved.bend());
        if (before - result.smooth_bend <= least_gain * before)
            break;
    }
    result.axes = moved.axes();
    return result;
}

}  // namespace endmill
