// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/reach.h"

#include <array>
#include <utility>

#include "endmill/core/detail/widest_registers.h"

namespace endmill {
namespace {

constexpr std::size_t sweep_members = 8;
constexpr std::size_t first_room = 32;

[[gnu::always_inline]] inline double square(double a)
{
    return a * a;
}

[[gnu::always_inline]] inline double lesser(double a, double b)
{
    return select(b < a, b, a);
}

[[gnu::always_inline]] inline double greater(double a, double b)
{
    return select(a < b, b, a);
}

// UprightSweep::squared_distance and beyond_reach, with selections instead of branches. It
// does not serve upright moves.
ENDMILL_WIDEST_REGISTERS
void compute_gaps(const std::array<const double*, sweep_members>& rows, const Vec3& point,
                  double radius, std::span<double> gaps)
{
    const auto [from_x, from_y, from_z, feed_x, feed_y, lengths, rises, inverse_squares] =
        rows;
    double* const __restrict results = gaps.data();
    const std::size_t count = gaps.size();
    const double point_x = point.x();
    const double point_y = point.y();
    const double point_z = point.z();
    const double squared_radius = radius * radius;
    const double diameter = 2 * radius;
    for (std::size_t k = 0; k < count; ++k) {
        const double length = lengths[k];
        const double rise = rises[k];
        const double x = point_x - from_x[k];
        const double y = point_y - from_y[k];
        const double z = point_z - from_z[k];
        const double along = x * feed_x[k] + y * feed_y[k];
        const double across = x * feed_y[k] - y * feed_x[k];
        const double share =
            lesser(greater((along * length + z * rise) * inverse_squares[k], 0.0), 1.0);
        const double to_move = square(along - share * length) + square(z - share * rise);
        const double to_start = square(lesser(along, 0.0)) + square(lesser(z, 0.0));
        const double to_end =
            square(greater(along - length, 0.0)) + square(lesser(z - rise, 0.0));
        const double beside =
            select(along < 0, lesser(to_move, to_start),
                   select(along > length, lesser(to_move, to_end),
                          select(z * length >= rise * along, 0.0, to_move)));
        results[k] = (across * across + beside - squared_radius) / diameter;
    }
}

}  // namespace

void SweepRows::add(const UprightSweep& sweep)
{
    if (size_ == room_)
        grow();
    const std::array<double, sweep_members> members{
        sweep.from_.x(), sweep.from_.y(), sweep.from_.z(), sweep.feed_x_,
        sweep.feed_y_,   sweep.length_,   sweep.rise_,     sweep.inverse_square_};
    for (std::size_t k = 0; k < sweep_members; ++k)
        rows_[k * room_ + size_] = members[k];
    if (!(sweep.length_ > 0))
        upright_.emplace_back(size_, sweep);
    ++size_;
}

void SweepRows::grow()
{
    const std::size_t room = std::max(first_room, 2 * room_);
    std::vector<double> rows(sweep_members * room);
    for (std::size_t k = 0; k < sweep_members; ++k)
        std::copy_n(rows_.begin() + static_cast<std::ptrdiff_t>(k * room_), size_,
                    rows.begin() + static_cast<std::ptrdiff_t>(k * room));
    rows_ = std::move(rows);
    room_ = room;
}

void SweepRows::gaps_at(const Vec3& point, double radius, std::span<double> gaps) const
{
    std::array<const double*, sweep_members> rows{};
    for (std::size_t k = 0; k < sweep_members; ++k)
        rows[k] = rows_.data() + k * room_;
    compute_gaps(rows, point, radius, gaps.first(size_));
    for (const auto& [k, sweep] : upright_)
        gaps[k] = beyond_reach(sweep.squared_distance(point), radius);
}

}  // namespace endmill
