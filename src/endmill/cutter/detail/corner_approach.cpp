// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/detail/corner_approach.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace endmill {
namespace {

// Of the lengths that go into a distance: what their rounding makes of it.
constexpr double rounding_share = 1e-15;
// Three to five do; a line that takes more grazes the region.
constexpr int most_steps = 24;
constexpr double infinite = std::numeric_limits<double>::infinity();

// A half space that holds the region, seen from a place of the line. All lengths along
// its normal are multiplied by `distance`.
struct HalfSpace {
    Vec3 out;         // away from it, as long as `distance`
    double distance;  // mm, of the place from the point of the core
    double gap;       // from the place to the corner
    double short_by;  // how far the place is from the half space
    double rate;      // how fast the line comes nearer
    // Half the slope of distance^2 by the share of the move, and how that changes with the
    // share and along the line.
    double slope;
    double bend;
    double turn;
};

// A place of the line, and where on the move the core is looked at.
struct Look {
    double t;
    double share;
};

class Approach {
public:
    Approach(const StraightSweep& sweep, const Line& line, double before)
        : flat_{sweep.cutter().flat_radius()},
          corner_{sweep.cutter().corner_radius()},
          before_{before},
          offset_{line.origin - sweep.from() - Vec3{0, 0, corner_}},
          way_{line.direction},
          move_{sweep.to() - sweep.from()},
          move_across2_{move_.head<2>().squaredNorm()},
          scale_{sweep.cutter().radius() + sweep.length() +
                 line.origin.lpNorm<Eigen::Infinity>() +
                 sweep.from().lpNorm<Eigen::Infinity>()}
    {
    }

    CornerApproach run()
    {
        Look look = look_from(std::isfinite(before_) ? before_ : -infinite);
        for (int i = 0; i < most_steps && std::isfinite(look.t) && look.t <= before_;
             ++i) {
            const HalfSpace half = half_space(look);
            const double ahead = look.t - low_;
            if (half.rate > 0) {
                if (half.short_by >= (before_ - look.t) * half.rate)
                    return {true, {}};
                low_ = std::max(low_, look.t + half.short_by / half.rate);
                const double close = rounding(look.t) * half.rate;
                // Within the corner on one side, within the half space on the other.
                if (half.gap <= close && half.short_by >= -close)
                    return {true, SweepEntry{low_, half.out / half.distance}};
                look = better(look, half);
            } else if (half.short_by > 0 && half.short_by >= -ahead * half.rate) {
                return {true, {}};
            } else if (ahead > 0) {
                look = look_from(low_);
            } else {
                break;
            }
        }
        return {low_ >= before_, {}};
    }

private:
    static constexpr double least_square = std::numeric_limits<double>::min();

    double rounding(double t) const { return rounding_share * (scale_ + std::abs(t)); }

    // At t, or, if that says nothing, at the level of the lowest tip: no place before it is
    // in the region.
    Look look_from(double t)
    {
        if (!std::isfinite(t) && way_.z() > 0)
            t = low_ = (std::min(0.0, move_.z()) - corner_ - offset_.z()) / way_.z();
        const double length2 = move_across2_ + move_.z() * move_.z();
        if (!(length2 > least_square))
            return {t, 0};
        return {t, std::clamp((offset_ + t * way_).dot(move_) / length2, 0.0, 1.0)};
    }

    // Newton's step: the core as near as the corner radius, and at no other share nearer.
    // Where that leads off the move, or to the share where the core is farthest, first the share.
    Look better(const Look& look, const HalfSpace& half) const
    {
        const double size = half.bend * half.rate + half.slope * half.turn;
        double share =
            look.share - (half.slope * half.rate + half.turn * half.gap) / size;
        double step = (half.bend * half.gap - half.slope * half.slope) / size;
        if (!(size > least_square && share >= 0 && share <= 1)) {
            share = look.share;
            if (half.bend > least_square)
                share = std::clamp(share - half.slope / half.bend, 0.0, 1.0);
            step = (half.gap + half.slope * (share - look.share)) / half.rate;
        }
        return {std::clamp(look.t + step, low_, before_), share};
    }

    HalfSpace half_space(const Look& look) const
    {
        // v from the middle of the disc to the place, (k v.x, k v.y, q) from its nearest
        // point, or from straight above that.
        const Vec3 v = offset_ + look.t * way_ - look.share * move_;
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
        half.gap = half.distance * (half.distance - corner_);
        half.short_by =
            half.gap + std::min(-look.share * half.slope, (1 - look.share) * half.slope);
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
    double before_;
    double low_ = -infinite;  // no place before is in the region
    Vec3 offset_;             // of the line, from the middle of the first disc, mm
    Vec3 way_;
    Vec3 move_;
    double move_across2_;
    double scale_;
};

}  // namespace

CornerApproach corner_approach(const StraightSweep& sweep, const Line& line,
                               double before)
{
    return Approach{sweep, line, before}.run();
}

}  // namespace endmill
