// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/part_distance.h"

#include <algorithm>
#include <limits>

#include "endmill/surface/sampling.h"

// `free_ball` is the shrinking-ball algorithm of [MaBaeChoi]. It starts with a ball of
// the way's length that touches the foot. While the part has a place inside the ball, the
// ball is replaced by the one that touches the foot and passes through this place. The
// result is the largest ball without a place inside.

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double longest = 1e9;  // mm
// Far more than are needed, except at a foot with no free ball.
constexpr int most_shrinkings = 60;
constexpr double radius_rounding = 1e-9;  // share of a ball's radius
// The coarse triangulation has this many times the chord tolerance. With so many fewer
// triangles it proves most balls empty.
constexpr double coarse_share = 10;

}  // namespace

PartDistance::PartDistance(const PartCharts& charts, double chord_tolerance)
    : charts_{charts},
      chord_tolerance_{chord_tolerance}
{
}

// Makes the search trees on first use.
void PartDistance::prepare() const
{
    prepare_once_([this] {
        if (charts_.mesh())
            return;
        surface_tree_.emplace(charts_.surfaces(), chord_tolerance_);
        chord_error_ = surface_tree_->chord_error();
        coarse_tree_.emplace(charts_.surfaces(), coarse_share * chord_tolerance_);
    });
}

// Returns the triangles of the whole part. Unlike the pieces, those of surfaces meet
// without gaps.
const TriangleTree& PartDistance::whole() const
{
    make_whole_once_([this] {
        if (charts_.mesh()) {
            whole_.emplace(*charts_.mesh());
            return;
        }
        sampled_ = sampled(charts_.surfaces(), charts_.sides(), chord_tolerance_).mesh;
        whole_.emplace(sampled_);
    });
    return *whole_;
}

std::optional<NearestPoint> PartDistance::nearest(const Vec3& place,
                                                  std::optional<std::size_t>& hint,
                                                  double within) const
{
    prepare();
    std::optional<NearestPoint> found = surface_tree_
                                            ? surface_tree_->nearest(place, hint, within)
                                            : whole().nearest(place, hint, within);
    if (found)
        hint = found->triangle;
    return found;
}

double PartDistance::operator()(const Vec3& place, std::optional<std::size_t>& hint) const
{
    const double found = nearest(place, hint, infinite)->distance;
    return found + chord_error_;
}

bool PartDistance::is_clear(const Vec3& centre, double radius) const
{
    prepare();  // sets the chord error
    if (coarse_tree_ &&
        !coarse_tree_->nearest(centre, {}, radius + coarse_tree_->chord_error()))
        return true;
    std::optional<std::size_t> no_hint;
    return !nearest(centre, no_hint, radius - chord_error_);
}

FreeBall PartDistance::free_ball(const PartWay& way,
                                 std::optional<std::size_t>& hint) const
{
    prepare();
    FreeBall ball{std::min(way.length, longest), std::nullopt};
    for (int i = 0; i < most_shrinkings; ++i) {
        const Vec3 centre = way.foot + ball.length * way.direction;
        const auto other =
            nearest(centre, hint, ball.length * (1 - radius_rounding) - chord_error_);
        if (!other) {
            if (ball.other)
                ball.length = std::max(0.0, ball.length - uncertainty());
            return ball;
        }
        // The ball that touches the foot and passes through the other place.
        const Vec3 away = other->point - way.foot;
        const double over = away.dot(way.direction);
        const double through = over > 0 ? away.squaredNorm() / (2 * over) : 0;
        ball = {std::min(through, (ball.length + other->distance) / 2), other->point};
    }
    return {0, ball.other};
}

double PartDistance::uncertainty() const
{
    prepare();
    return 2 * chord_error_;
}

bool PartDistance::is_over_or_under(const Vec3& place) const
{
    return whole().any_hit({place, Vec3::UnitZ()}) ||
           whole().any_hit({place, -Vec3::UnitZ()});
}

}  // namespace endmill
