// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/fixed_axis_ball.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "endmill/core/detail/widest_registers.h"

// As in ball_chords, every loop over the rays computes all cases and selects one.

namespace endmill {
namespace {

constexpr int rays_at_once = 8;
constexpr double infinite = std::numeric_limits<double>::infinity();
// Greatest difference of a unit axis from a direction. It moves places some metres up the
// tool by less than the rounding of a distance.
constexpr double axis_tolerance = 1e-14;
// Rounding error of a distance in mm, as in RayOnMotion.
constexpr double rounding = 1e-10;
// A motion across the rays that is shorter than this, in mm, counts as none.
constexpr double least_way = 1e-10;
// A ray grazes the ball if half its chord is below this share of the radius.
constexpr double grazing_share = 0.01;
// Bound of the error of an end in mm: the rounding of the distance and a way that does not
// count, divided by the least share of half a chord.
constexpr double end_error = (rounding + least_way) / grazing_share;

// A ray misses the ball if the square of half its chord is below minus this, times radius and
// rounding.
constexpr double missing_share = 4;

// The lower and the upper ends of the chords through a line of balls, mm.
struct EightEnds {
    alignas(64) Eight low;
    alignas(64) Eight high;
    alignas(64) Eight low_square;   // of half the chord through the ball there, mm^2
    alignas(64) Eight high_square;  // negative if there is none
    alignas(64) Eight low_at;       // u of the ball
    alignas(64) Eight high_at;
};

[[gnu::always_inline]] inline double limited_to_one(double u)
{
    const double positive = select(u > 0, u, 0);
    return select(positive < 1, positive, 1);
}

// \param is_level whether only one direction across the rays counts, so that no ray is beside
// the line.
template <bool is_level = false>
[[gnu::always_inline]] inline void find_ends(const BallLineEnds& line,
                                             const Eight& columns, const Eight& rows,
                                             EightEnds& ends)
{
    const double square = line.radius * line.radius;
    const auto [wx, wy] = line.across;
    ENDMILL_INDEPENDENT
    for (int i = 0; i < rays_at_once; ++i) {
        const double x = line.counts[0] * (columns[i] - line.centre[0]);
        const double y = line.counts[1] * (rows[i] - line.centre[1]);
        const double middle = x * line.along[0] + y * line.along[1];
        const double beside = x * line.direction[1] - y * line.direction[0];
        const double half =
            is_level ? line.radius : std::sqrt(std::abs(square - beside * beside));
        const double shift = line.share * half;
        const double low_u = limited_to_one(line.low_offset + middle - shift);
        const double high_u = limited_to_one(line.high_offset + middle + shift);
        const double low_x = x - low_u * wx;
        const double low_y = y - low_u * wy;
        const double high_x = x - high_u * wx;
        const double high_y = y - high_u * wy;
        const double low_square = square - low_x * low_x - low_y * low_y;
        const double high_square = square - high_x * high_x - high_y * high_y;
        ends.low[i] = line.start + line.way * low_u - std::sqrt(std::abs(low_square));
        ends.high[i] = line.start + line.way * high_u + std::sqrt(std::abs(high_square));
        ends.low_square[i] = low_square;
        ends.high_square[i] = high_square;
        ends.low_at[i] = low_u;
        ends.high_at[i] = high_u;
    }
}

// Takes the ends without heights where the centre of their ball is not above the ray.
// \param heights mm, of the rays above the first centre. \param rise mm, of the centre.
[[gnu::always_inline]] inline void take_level(const EightEnds& level,
                                              const Eight& heights, double rise,
                                              EightEnds& ends)
{
    ENDMILL_INDEPENDENT
    for (int i = 0; i < rays_at_once; ++i) {
        const bool low = rise * level.low_at[i] <= heights[i];
        const bool high = rise * level.high_at[i] <= heights[i];
        ends.low[i] = select(low, level.low[i], ends.low[i]);
        ends.low_square[i] = select(low, level.low_square[i], ends.low_square[i]);
        ends.high[i] = select(high, level.high[i], ends.high[i]);
        ends.high_square[i] = select(high, level.high_square[i], ends.high_square[i]);
    }
}

// The length of rays.
struct RayLength {
    double per_unit;  // units per mm, a power of two
    double units;     // in units
};

[[gnu::always_inline]] inline double on_ray(double units, const RayLength& length)
{
    const double positive = select(units > 0, units, 0);
    return select(positive < length.units, positive, length.units);
}

// Rounds the ends. They are whole numbers of units between 0 and the length of the rays, so
// that the conversion to whole numbers rounds down.
[[gnu::always_inline]] inline void round_chords(const EightEnds& ends, double radius,
                                                const RayLength& length,
                                                EightWholeChords& chords)
{
    const double sharp = grazing_share * grazing_share * radius * radius;
    const double missing = -missing_share * rounding * radius;
    const double per_unit = length.per_unit;
    const double units = length.units;
    ENDMILL_INDEPENDENT
    for (int i = 0; i < rays_at_once; ++i) {
        const double least = select(ends.low_square[i] < ends.high_square[i],
                                    ends.low_square[i], ends.high_square[i]);
        const double counts = select(least >= sharp, 1, 0);
        const double from = on_ray((ends.low[i] - end_error) * per_unit, length);
        const double to = on_ray((ends.high[i] + end_error) * per_unit, length);
        const double sure_from = on_ray((ends.low[i] + end_error) * per_unit, length);
        const double sure_to = on_ray((ends.high[i] - end_error) * per_unit, length);
        const auto whole = static_cast<std::int32_t>(units);
        const auto is_chord = static_cast<std::int32_t>(counts);
        chords.may.from[i] = static_cast<std::int32_t>(from);
        chords.may.to[i] = is_chord * (whole - static_cast<std::int32_t>(units - to));
        chords.sure.from[i] = whole - static_cast<std::int32_t>(units - sure_from);
        chords.sure.to[i] = is_chord * static_cast<std::int32_t>(sure_to);
        chords.is_grazing[i] =
            static_cast<std::int32_t>(select(least > missing, 1 - counts, 0));
    }
}

// Chords of rays above the ball.
ENDMILL_WIDEST_REGISTERS
void find_level_chords(const BallLineEnds& level, const Eight& beside,
                       const RayLength& length, EightWholeChords& chords)
{
    EightEnds ends;
    find_ends<true>(level, beside, beside, ends);
    round_chords(ends, level.radius, length, chords);
}

// The lines of balls of some rays.
struct LineAndLevel {
    const BallLineEnds& line;
    const BallLineEnds& level;  // for rays across the tool axis
    int height;   // 0 if it is the place in a row, 1 if it is that of the row
    double sign;  // of the tool axis
    double rise;  // mm, of the centre along the tool axis
};

// Chords of rays along the tool axis, where one end is that of the ray.
ENDMILL_WIDEST_REGISTERS
void find_chords_along(const LineAndLevel& lines, const RayLength& length,
                       const Eight& columns, std::span<const double> rows,
                       std::span<EightWholeChords> chords)
{
    for (std::size_t row = 0; row < chords.size(); ++row) {
        EightEnds ends;
        alignas(64) Eight place;
        place.fill(rows[row]);
        find_ends(lines.line, columns, place, ends);
        if (lines.sign > 0) {
            ends.high.fill(infinite);
            ends.high_square = ends.low_square;
        } else {
            ends.low.fill(-infinite);
            ends.low_square = ends.high_square;
        }
        round_chords(ends, lines.line.radius, length, chords[row]);
    }
}

// Chords of rays across the tool axis.
ENDMILL_WIDEST_REGISTERS
void find_chords_across(const LineAndLevel& lines, const RayLength& length,
                        const Eight& columns, std::span<const double> rows,
                        std::span<EightWholeChords> chords)
{
    const auto& [line, level, height, sign, rise] = lines;
    const double first = line.centre[static_cast<std::size_t>(height)];
    for (std::size_t row = 0; row < chords.size(); ++row) {
        EightEnds ends;
        alignas(64) Eight place;
        alignas(64) Eight heights;
        place.fill(rows[row]);
        for (int i = 0; i < rays_at_once; ++i)
            heights[i] = sign * ((height == 0 ? columns[i] : rows[row]) - first);
        // The columns ascend.
        const double lowest = std::min(heights.front(), heights.back());
        const double highest = std::max(heights.front(), heights.back());
        if (lowest >= std::max(0.0, rise)) {
            find_ends<true>(level, columns, place, ends);
        } else {
            find_ends(line, columns, place, ends);
            if (highest >= std::min(0.0, rise)) {
                EightEnds of_level;
                find_ends<true>(level, columns, place, of_level);
                take_level(of_level, heights, rise, ends);
            }
        }
        round_chords(ends, line.radius, length, chords[row]);
    }
}

// \param start the first centre, along the rays from their start. \param counts which
// directions across the rays count.
BallLineEnds line_ends(const FixedAxisBall& ball, int field_axis, double start,
                       const std::array<double, 2>& counts)
{
    const std::array<int, 2> across{(field_axis + 1) % 3, (field_axis + 2) % 3};
    const Vec3 way = ball.to - ball.from;
    BallLineEnds line{.radius = ball.radius,
                      .start = start,
                      .way = way[field_axis],
                      .centre = {ball.from[across[0]], ball.from[across[1]]},
                      .counts = counts,
                      .across = {counts[0] * way[across[0]], counts[1] * way[across[1]]},
                      .along = {},
                      .direction = {},
                      .share = 0,
                      .low_offset = 0,
                      .high_offset = 0};
    const double length = std::hypot(line.across[0], line.across[1]);
    if (length < least_way) {
        line.across = {0, 0};
        (line.way > 0 ? line.high_offset : line.low_offset) = 1;
        return line;
    }
    for (std::size_t c = 0; c < 2; ++c) {
        line.direction[c] = line.across[c] / length;
        line.along[c] = line.direction[c] / length;
    }
    line.share = line.way / (length * std::hypot(line.way, length));
    return line;
}

}  // namespace

std::optional<FixedAxisBall> fixed_axis_ball(const ToolPiece& piece)
{
    const ToolMotion& motion = piece.motion;
    if (motion.turn() != 0 || !piece.body.cutter().is_ball() ||
        std::isfinite(piece.body.length()))
        return std::nullopt;
    const Vec3 up = motion.from().axes.col(2);
    Eigen::Index axis = 0;
    up.cwiseAbs().maxCoeff(&axis);
    const double sign = up[axis] > 0 ? 1 : -1;
    const Vec3 exact = sign * Vec3::Unit(axis);
    if (!((up - exact).cwiseAbs().maxCoeff() <= axis_tolerance))
        return std::nullopt;
    const double radius = piece.body.cutter().radius();
    return FixedAxisBall{motion.from().tip + radius * exact,
                         motion.to().tip + radius * exact, radius, static_cast<int>(axis),
                         sign};
}

FixedAxisBallOnField::FixedAxisBallOnField(const FixedAxisBall& ball, int field_axis,
                                           const DexelStock& stock)
    : height_{ball.axis == field_axis ? -1 : (ball.axis - field_axis + 2) % 3},
      sign_{ball.sign},
      radius_{ball.radius},
      per_unit_{1 / stock.unit()},
      units_{static_cast<double>(stock.units(field_axis))},
      rise_{ball.sign * (ball.to[ball.axis] - ball.from[ball.axis])}
{
    const double start = ball.from[field_axis] - stock.block().low[field_axis];
    line_ = line_ends(ball, field_axis, start, {1, 1});
    level_ = line_ends(ball, field_axis, start,
                       {height_ == 0 ? 0.0 : 1.0, height_ == 1 ? 0.0 : 1.0});
    for (std::size_t c = 0; c < 2; ++c) {
        const auto at = (field_axis + 1 + static_cast<int>(c)) % 3;
        least_[c] = std::min(ball.from[at], ball.to[at]);
        most_[c] = std::max(ball.from[at], ball.to[at]);
    }
    low_ = per_unit_ * (line_.start + std::min(0.0, line_.way));
    high_ = per_unit_ * (line_.start + std::max(0.0, line_.way));
    if (is_along_axis())
        (sign_ > 0 ? high_ : low_) = sign_ * infinite;
    whole_bound_ = bound_of(radius_);
}

// The bound if no chord through a ball is longer than this to both sides of its centre, mm.
DexelInterval FixedAxisBallOnField::bound_of(double half) const
{
    const double margin = per_unit_ * (half + end_error) + 1;
    const RayLength length{per_unit_, units_};
    return {static_cast<std::int32_t>(on_ray(low_ - margin, length)),
            static_cast<std::int32_t>(on_ray(high_ + margin, length))};
}

// Distance of a range of rays from the range of the centres, in one direction across the
// rays, mm. Rays above the ball in the direction of the axis are in its cylinder.
double FixedAxisBallOnField::away(std::size_t direction, double low, double high) const
{
    const bool is_height = static_cast<int>(direction) == height_;
    const double below = is_height && sign_ < 0 ? 0 : least_[direction] - high;
    const double above = is_height && sign_ > 0 ? 0 : low - most_[direction];
    return std::max({0.0, below, above});
}

// Square of half the longest chord at this distance from the centres, mm^2; not above 0 if
// there is none. Rays that graze the ball count.
double FixedAxisBallOnField::half_square(double away) const
{
    return radius_ * (radius_ + missing_share * rounding) - away * away;
}

DexelInterval FixedAxisBallOnField::bound(const Rectangle& rays) const
{
    const double beside = away(0, rays.low[0], rays.high[0]);
    const double square =
        half_square(away(1, rays.low[1], rays.high[1])) - beside * beside;
    return square > 0 ? bound_of(std::sqrt(square)) : DexelInterval{0, 0};
}

bool FixedAxisBallOnField::is_above(const Rectangle& rays) const
{
    if (is_along_axis())
        return false;
    return sign_ > 0 ? rays.low[height_] >= most_[height_]
                     : rays.high[height_] <= least_[height_];
}

void FixedAxisBallOnField::find_chords(const Eight& columns, std::span<const double> rows,
                                       std::span<EightWholeChords> chords) const
{
    // The rows within reach follow one another.
    const auto is_missed = [&](double row) {
        return !(half_square(away(1, row, row)) > 0);
    };
    std::size_t first = 0;
    std::size_t last = chords.size();
    for (; first < last && is_missed(rows[first]); ++first)
        chords[first] = {};
    for (; last > first && is_missed(rows[last - 1]); --last)
        chords[last - 1] = {};
    const std::span within = rows.subspan(first, last - first);
    const std::span found = chords.subspan(first, last - first);
    const RayLength length{per_unit_, units_};
    const LineAndLevel lines{line_, level_, height_, sign_, rise_};
    (is_along_axis() ? find_chords_along : find_chords_across)(lines, length, columns,
                                                               within, found);
}

EightWholeChords FixedAxisBallOnField::chords_above(const Eight& beside) const
{
    EightWholeChords chords;
    find_level_chords(level_, beside, {per_unit_, units_}, chords);
    return chords;
}

}  // namespace endmill
