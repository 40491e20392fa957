// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/corner_approach.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace endmill {
namespace {

// Of the lengths that go into a distance: what their rounding makes of it, and of an entry.
constexpr double rounding_share = 1e-15;
// Three to five do; one that takes more grazes the region, or begins right under a corner.
constexpr int most_steps = 24;
constexpr double infinite = std::numeric_limits<double>::infinity();

// A half space that holds the region, seen from a place of the line.
struct HalfSpace {
    Vec3 out;         // away from it, as long as `distance`
    double distance;  // of the place from the point of the core
    double short_by;  // how far the place is from it, times `distance`
    double rate;      // how fast the line comes nearer, times `distance`
    // Half the slope of distance^2 along the move, and how that changes there and along the
    // line: for Newton's step to the share of the move where the core is nearest.
    double slope;
    double bend;
    double turn;
};

class Approach {
public:
    Approach(const StraightSweep& sweep, const Line& line)
        : flat_{sweep.cutter().flat_radius()},
          corner_{sweep.cutter().corner_radius()},
          offset_{line.origin - sweep.from() - Vec3{0, 0, corner_}},
          way_{line.direction},
          move_{sweep.to() - sweep.from()},
          move_across2_{move_.head<2>().squaredNorm()},
          scale_{sweep.cutter().radius() + sweep.length() +
                 line.origin.lpNorm<Eigen::Infinity>() +
                 sweep.from().lpNorm<Eigen::Infinity>()}
    {
    }

    CornerApproach run(double before) const
    {
        double t = before;
        double share = 0;
        bool is_outside = false;  // all of the line before t
        if (std::isfinite(before)) {
            share = nearest_share(before);
            if (is_in_core(before, share))
                t = infinite;
        }
        if (!std::isfinite(t)) {
            // From where the line comes to the level of the lowest tip.
            t = (std::min(0.0, move_.z()) - corner_ - offset_.z()) / way_.z();
            if (!(way_.z() > 0) || !std::isfinite(t))
                return {false, {}};
            if (t >= before)
                return {true, {}};
            share = nearest_share(t);
            is_outside = true;
        }
        return search(t, share, is_outside, before);
    }

private:
    static constexpr double least_square = std::numeric_limits<double>::min();

    CornerApproach search(double t, double share, bool is_outside, double before) const
    {
        for (int i = 0; i < most_steps; ++i) {
            const HalfSpace half = half_space(t, share);
            if (!(half.distance > 0))
                return {false, {}};
            if (!(half.rate > 0))
                return {is_outside && half.short_by > 0, {}};
            const double next = t + half.short_by / half.rate;
            if (next >= before)
                return {true, {}};
            const double inside_by = (half.distance - corner_) * half.distance;
            if (is_outside && inside_by <= rounding(t) * half.rate)
                return {true, SweepEntry{std::max(t, next), half.out / half.distance}};
            const double step = is_outside && next < t ? 0 : next - t;
            t += step;
            if (half.bend > least_square)
                share = std::clamp(share - (half.slope + half.turn * step) / half.bend,
                                   0.0, 1.0);
            is_outside = true;
        }
        return {false, {}};
    }

    double rounding(double t) const { return rounding_share * (scale_ + std::abs(t)); }

    double nearest_share(double t) const
    {
        const double length2 = move_across2_ + move_.z() * move_.z();
        return length2 > least_square
                   ? std::clamp((offset_ + t * way_).dot(move_) / length2, 0.0, 1.0)
                   : 0;
    }

    // Above the disc: no way leads out.
    bool is_in_core(double t, double share) const
    {
        const Vec3 from_disc = offset_ + t * way_ - share * move_;
        return from_disc.z() >= 0 && from_disc.head<2>().squaredNorm() <= flat_ * flat_;
    }

    HalfSpace half_space(double t, double share) const
    {
        // v from the middle of the disc to the place, (k v.x, k v.y, q) from its nearest
        // point, or from straight above that.
        const Vec3 v = offset_ + t * way_ - share * move_;
        const double d = std::sqrt(v.x() * v.x() + v.y() * v.y());
        const double across = d - flat_;
        const double per_d = across > 0 ? 1 / d : 0;
        const double a = across > 0 ? across : 0;
        const double q = v.z() < 0 ? v.z() : 0;
        const double k = a * per_d;
        HalfSpace half;
        half.out = {k * v.x(), k * v.y(), q};
        half.distance = std::sqrt(a * a + q * q);
        half.rate = -half.out.dot(way_);
        half.slope = -half.out.dot(move_);
        half.short_by = half.distance * (half.distance - corner_) +
                        std::min(-share * half.slope, (1 - share) * half.slope);
        const double across_move = (v.x() * move_.x() + v.y() * move_.y()) * per_d;
        const double across_way = (v.x() * way_.x() + v.y() * way_.y()) * per_d;
        const double rise = v.z() < 0 ? move_.z() : 0;
        half.bend = across_move * across_move * (1 - k) + k * move_across2_ + rise * rise;
        half.turn = -across_move * across_way * (1 - k) -
                    k * (way_.x() * move_.x() + way_.y() * move_.y()) - rise * way_.z();
        return half;
    }

    double flat_;
    double corner_;
    Vec3 offset_;  // of the line, from the middle of the first disc, mm
    Vec3 way_;
    Vec3 move_;
    double move_across2_;
    double scale_;
};

}  // namespace

CornerApproach corner_approach(const StraightSweep& sweep, const Line& line,
                               double before)
{
    return Approach{sweep, line}.run(before);
}

}  // namespace endmill
