// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/ball_chords.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "endmill/core/detail/widest_registers.h"

// Every loop over the rays computes all cases and selects one, and takes roots of absolute
// values. This lets the compiler process several rays at once, with the same bits for any
// number of them. The searches are those of RayOnMotion; see there why they are safe.

namespace endmill {
namespace {

constexpr int rays_at_once = 8;
constexpr double infinite = std::numeric_limits<double>::infinity();
// As in CuttingBody.
constexpr double rounding_share = 1e-12;
// As in RayOnMotion.
constexpr int most_entry_steps = 40;
constexpr int most_sure_steps = 12;
constexpr double least_fall = 0.02;

// F on eight rays, with the pose where it is attained and its rate along the ray.
struct EightDistances {
    alignas(64) Eight value;
    alignas(64) Eight at;
    alignas(64) Eight rate;
};

// The numbers of a ball on rays that all loops need.
struct BallNumbers {
    explicit BallNumbers(const BallOnRays& ball)
        : radius{ball.radius},
          ax{ball.along_from.x()},
          ay{ball.along_from.y()},
          az{ball.along_from.z()},
          bx{ball.along_to.x()},
          by{ball.along_to.y()},
          bz{ball.along_to.z()}
    {
    }

    double radius;
    double ax, ay, az;  // direction at u = 0
    double bx, by, bz;  // direction at u = 1
};

[[gnu::always_inline]] inline void find_distances(const BallNumbers& ball,
                                                  const EightRays& rays, const Eight& s,
                                                  EightDistances& found)
{
    const auto& [fx, fy, fz] = rays.from;
    const auto& [tx, ty, tz] = rays.to;
    const double radius = ball.radius;
    ENDMILL_NOT_UNROLLED
    for (int i = 0; i < rays_at_once; ++i) {
        const double px = fx[i] + s[i] * ball.ax;
        const double py = fy[i] + s[i] * ball.ay;
        const double pz = fz[i] + s[i] * ball.az;
        const double wx = tx[i] + s[i] * ball.bx - px;
        const double wy = ty[i] + s[i] * ball.by - py;
        const double wz = tz[i] + s[i] * ball.bz - pz;
        const double h = pz - radius;
        const double along = px * wx + py * wy;
        const double square = wx * wx + wy * wy;
        const bool is_below = select(wz == 0, select(h < 0, 1, 0),
                                     select(along * wz >= h * square, 1, 0)) != 0;
        const double steep = square + select(is_below, wz * wz, 0);
        const double slope = along + select(is_below, h * wz, 0);
        const double free = -slope / select(steep > 0, steep, 1);
        const double least = select(free > 0, free, 0);
        const double inside = select(least < 1, least, 1);
        const double u = select(steep > 0, inside, 0);
        const double x = px + u * wx;
        const double y = py + u * wy;
        const double over = pz + u * wz - radius;
        const double below = select(over < 0, over, 0);
        const double length = std::sqrt(std::abs(x * x + y * y + below * below));
        const double share = select(length > 0, 1 / select(length > 0, length, 1), 0);
        const double v = 1 - u;
        found.value[i] = length - radius;
        found.at[i] = u;
        found.rate[i] =
            share * (x * (v * ball.ax + u * ball.bx) + y * (v * ball.ay + u * ball.by) +
                     below * (v * ball.az + u * ball.bz));
    }
}

// A search on eight rays, upwards for sign = 1 and downwards for -1.
struct EightSearch {
    const BallNumbers& ball;
    const EightRays& rays;
    double error;     // mm, as in ball_chords
    double accuracy;  // mm
    double slack;     // by how much the rate of F may rise on the way
    double sign = 1;

    EightSearch downwards() const { return {ball, rays, error, accuracy, slack, -1}; }
};

// Rays that a search has not ended on: 1, else 0.
[[gnu::always_inline]] inline bool is_any(const Eight& marks)
{
    double sum = 0;
    for (int i = 0; i < rays_at_once; ++i)
        sum += marks[i];
    return sum > 0;
}

// The place of a search on each ray.
struct EightPlacesOnRays {
    alignas(64) Eight s;
    alignas(64) Eight is_found;  // 1 or 0
    EightDistances there;
};

// As RayOnMotion::first_entry from `at.s`, on the rays where `at.is_found` is 1.
[[gnu::always_inline]] inline void find_first_entries(const EightSearch& search,
                                                      const Eight& most,
                                                      EightPlacesOnRays& at)
{
    const auto& [ball, rays, error, accuracy, slack, sign] = search;
    alignas(64) Eight is_searching = at.is_found;
    for (int step = 0;; ++step) {
        find_distances(ball, rays, at.s, at.there);
        if (step == most_entry_steps)
            return;
        ENDMILL_NOT_UNROLLED
        for (int i = 0; i < rays_at_once; ++i) {
            const double gap = at.there.value[i] - error;
            const double steepest = slack - sign * at.there.rate[i];
            const double fall = select(steepest < 1, steepest, 1);
            const double next = at.s[i] + sign * (gap / select(fall > 0, fall, 1));
            const double far = select(gap > accuracy, is_searching[i], 0);
            const double ahead = select(sign * next < sign * most[i], 1, 0);
            const double further = far * select(fall > 0, ahead, 0);
            at.is_found[i] -= far - further;
            at.s[i] = select(further > 0, next, at.s[i]);
            is_searching[i] = further;
        }
        if (!is_any(is_searching))
            return;
    }
}

// As RayOnMotion::sure_entry from places with known distances, on the rays where `at.is_found`
// is 1.
[[gnu::always_inline]] inline void find_sure_entries(const EightSearch& search,
                                                     const Eight& most,
                                                     EightPlacesOnRays& at)
{
    const auto& [ball, rays, error, accuracy, slack, sign] = search;
    alignas(64) Eight is_searching = at.is_found;
    for (int step = 1;; ++step) {
        const double goes_on = step == most_sure_steps ? 0 : 1;
        ENDMILL_NOT_UNROLLED
        for (int i = 0; i < rays_at_once; ++i) {
            const double rest = at.there.value[i] + error;
            const double steepest = -sign * at.there.rate[i];
            const double fall = select(steepest > least_fall, steepest, least_fall);
            const double next = at.s[i] + sign * ((rest + accuracy) / fall);
            const double far = select(rest > 0, is_searching[i], 0);
            const double further =
                far * goes_on * select(sign * next <= sign * most[i], 1, 0);
            at.is_found[i] -= far - further;
            at.s[i] = select(further > 0, next, at.s[i]);
            is_searching[i] = further;
        }
        if (!is_any(is_searching))
            return;
        find_distances(ball, rays, at.s, at.there);
    }
}

// Marks the rays where all between two sure places is removed by the pose that removes one.
[[gnu::always_inline]] inline void find_whole(const EightSearch& search,
                                              const EightPlacesOnRays& low,
                                              const EightPlacesOnRays& high,
                                              Eight& is_whole)
{
    const BallNumbers& ball = search.ball;
    const double error = search.error;
    const auto& [fx, fy, fz] = search.rays.from;
    const auto& [tx, ty, tz] = search.rays.to;
    ENDMILL_NOT_UNROLLED
    for (int i = 0; i < rays_at_once; ++i) {
        const double s = (low.s[i] + high.s[i]) / 2;
        const double px = fx[i] + s * ball.ax;
        const double py = fy[i] + s * ball.ay;
        const double pz = fz[i] + s * ball.az;
        const double wx = tx[i] + s * ball.bx - px;
        const double wy = ty[i] + s * ball.by - py;
        const double wz = tz[i] + s * ball.bz - pz;
        const auto is_outside = [&](double u) {
            const double x = px + u * wx;
            const double y = py + u * wy;
            const double over = pz + u * wz - ball.radius;
            const double below = select(over < 0, over, 0);
            const double length = std::sqrt(std::abs(x * x + y * y + below * below));
            return select(length - ball.radius + error > 0, 1.0, 0.0);
        };
        const double outside = is_outside(low.there.at[i]) + is_outside(high.there.at[i]);
        is_whole[i] =
            select(low.there.at[i] == high.there.at[i], 1, select(outside > 0, 0, 1));
    }
}

}  // namespace

BallOnRays::BallOnRays(const Vec3& start, const Vec3& direction, const ToolMotion& motion,
                       double ball_radius)
    : radius{ball_radius},
      turn{motion.turn()},
      from{motion.from().seen(start)},
      to{motion.to().seen(start)},
      along_from{motion.from().axes.transpose() * direction},
      along_to{motion.to().axes.transpose() * direction},
      frame_from{motion.from().axes.transpose()},
      frame_to{motion.to().axes.transpose()}
{
}

ENDMILL_WIDEST_REGISTERS
EightRays moved_rays(const BallOnRays& ball, const EightPlaces& movements)
{
    EightRays rays;
    const auto& [x, y, z] = movements;
    for (int c = 0; c < 3; ++c) {
        const double start_from = ball.from[c];
        const double start_to = ball.to[c];
        const std::array from{ball.frame_from(c, 0), ball.frame_from(c, 1),
                              ball.frame_from(c, 2)};
        const std::array to{ball.frame_to(c, 0), ball.frame_to(c, 1),
                            ball.frame_to(c, 2)};
        ENDMILL_NOT_UNROLLED
        for (int i = 0; i < rays_at_once; ++i) {
            rays.from[c][i] =
                start_from + (from[0] * x[i] + from[1] * y[i] + from[2] * z[i]);
            rays.to[c][i] = start_to + (to[0] * x[i] + to[1] * y[i] + to[2] * z[i]);
        }
    }
    return rays;
}

ENDMILL_WIDEST_REGISTERS
EightStretches near_stretches(const BallOnRays& ball, const EightRays& rays,
                              double within)
{
    EightStretches near;
    const double ax = (ball.along_from.x() + ball.along_to.x()) / 2;
    const double ay = (ball.along_from.y() + ball.along_to.y()) / 2;
    const double az = (ball.along_from.z() + ball.along_to.z()) / 2;
    const double level = ax * ax + ay * ay;
    const double full = level + az * az;
    const double is_level = level > 0 ? 1 : 0;
    const double is_rising = az > 0 ? 1 : 0;
    const double is_falling = az < 0 ? 1 : 0;
    const double level_or_one = level > 0 ? level : 1;
    const double rise_or_one = az != 0 ? az : 1;
    ENDMILL_NOT_UNROLLED
    for (int i = 0; i < rays_at_once; ++i) {
        const double x = (rays.from[0][i] + rays.to[0][i]) / 2;
        const double y = (rays.from[1][i] + rays.to[1][i]) / 2;
        const double z = (rays.from[2][i] + rays.to[2][i]) / 2;
        const double larger = select(std::abs(x) > std::abs(y), std::abs(x), std::abs(y));
        const double largest = select(larger > std::abs(z), larger, std::abs(z));
        const double radius = ball.radius + (within + rounding_share * (1 + largest));
        const double towards = x * ax + y * ay;
        const double outside = x * x + y * y - radius * radius;
        const double h = z - ball.radius;
        // the cylinder, above the middle of the ball
        const double beside = towards * towards - level * outside;
        const double root = std::sqrt(std::abs(beside));
        const double sure =
            select(is_level > 0, select(beside >= 0, 1, 0), select(outside <= 0, 1, 0));
        const double first =
            select(is_level > 0, (-towards - root) / level_or_one, -infinite);
        const double last =
            select(is_level > 0, (-towards + root) / level_or_one, infinite);
        const double middle = -h / rise_or_one;
        const double low = select(is_rising > 0, middle, -infinite);
        const double high = select(is_falling > 0, middle, infinite);
        const double above = select(is_rising + is_falling > 0, 1, select(h >= 0, 1, 0));
        const double from = select(first > low, first, low);
        const double to = select(last < high, last, high);
        const double has_side = sure * above * select(from <= to, 1, 0);
        // the ball
        const double onto = towards + h * az;
        const double under = onto * onto - full * (outside + h * h);
        const double half = std::sqrt(std::abs(under));
        const double enters = select(under >= 0, (-onto - half) / full, infinite);
        const double leaves = select(under >= 0, (-onto + half) / full, -infinite);
        const double side_from = select(has_side > 0, from, infinite);
        const double side_to = select(has_side > 0, to, -infinite);
        near.from[i] = select(side_from < enters, side_from, enters);
        near.to[i] = select(side_to > leaves, side_to, leaves);
    }
    return near;
}

ENDMILL_WIDEST_REGISTERS
EightChords ball_chords(const BallOnRays& ball, const EightRays& rays,
                        const EightStretches& search, double error, double accuracy)
{
    const BallNumbers numbers{ball};
    const EightSearch upwards{numbers, rays, error, accuracy,
                              ball.turn * (1 + ball.turn / 4)};
    const EightSearch downwards = upwards.downwards();
    EightChords chords;
    EightPlacesOnRays high;
    high.s = search.to;
    high.is_found.fill(1);
    find_first_entries(downwards, search.from, high);
    EightPlacesOnRays low;
    low.s = search.from;
    low.is_found = high.is_found;
    find_first_entries(upwards, high.s, low);
    ENDMILL_NOT_UNROLLED
    for (int i = 0; i < rays_at_once; ++i) {
        chords.may.from[i] = select(low.is_found[i] > 0, low.s[i], infinite);
        chords.may.to[i] = select(low.is_found[i] > 0, high.s[i], -infinite);
    }
    high.is_found = low.is_found;
    alignas(64) const Eight highest = high.s;
    find_sure_entries(upwards, highest, low);
    high.is_found = low.is_found;
    find_sure_entries(downwards, low.s, high);
    find_whole(upwards, low, high, chords.is_whole);
    ENDMILL_NOT_UNROLLED
    for (int i = 0; i < rays_at_once; ++i) {
        chords.sure.from[i] = select(high.is_found[i] > 0, low.s[i], infinite);
        chords.sure.to[i] = select(high.is_found[i] > 0, high.s[i], -infinite);
    }
    return chords;
}

}  // namespace endmill
