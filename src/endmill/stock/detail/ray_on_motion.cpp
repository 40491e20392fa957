// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/ray_on_motion.h"

#include <algorithm>
#include <cmath>

// For one pose the distance is convex along the line, and over the poses of the straight
// approximation jointly convex but for the turn of the line's direction, which is at most
// the turn of the motion. A Newton step whose rate is steeper by this turn can therefore
// not pass a place with F = e. The error e changes along the line by less than a quarter of
// the square of the turn.

namespace endmill {
namespace {

// Rounding error of a distance in mm, for coordinates up to some metres.
constexpr double rounding = 1e-10;
// Steps of a search. Where the line grazes the cutter they become slow; the bounds reached
// so far hold.
constexpr int most_entry_steps = 40;
constexpr int most_sure_steps = 12;
// Least rate at which the distance is assumed to fall towards a removed place.
constexpr double least_fall = 0.02;

}  // namespace

RayOnMotion::RayOnMotion(const Vec3& start, const Vec3& direction,
                         const ToolMotion& motion, const CuttingBody& body)
    : start_{start},
      direction_{direction},
      motion_{&motion},
      body_{&body},
      from_{motion.from().seen(start)},
      to_{motion.to().seen(start)},
      along_from_{motion.from().axes.transpose() * direction},
      along_to_{motion.to().axes.transpose() * direction}
{
}

RayOnMotion::Distance RayOnMotion::distance(double s, double enough) const
{
    const double error = this->error(s);
    return {body_->least_on_segment(from_ + s * along_from_, to_ + s * along_to_,
                                    enough + error),
            error};
}

double RayOnMotion::error(double s) const
{
    return known_error_ ? *known_error_
                        : motion_->chord_error(start_ + s * direction_) + rounding;
}

double RayOnMotion::largest_error(const CuttingBody::Stretch& on, double beside) const
{
    const double turn = motion_->turn();
    return std::max(error(on.from), error(on.to)) + turn * turn * (1 + turn) / 4 * beside;
}

double RayOnMotion::rate(const CuttingBody::Least& least) const
{
    return least.gradient.dot((1 - least.at) * along_from_ + least.at * along_to_);
}

double RayOnMotion::at_pose(double s, double u) const
{
    return body_
        ->distance((1 - u) * (from_ + s * along_from_) + u * (to_ + s * along_to_))
        .value;
}

// All poses see a place within half the way between its ends, and the error, of the middle
// of these ends.
double RayOnMotion::spread(const CuttingBody::Stretch& on, double error,
                           double beside) const
{
    const Vec3 way = to_ - from_;
    const Vec3 change = along_to_ - along_from_;
    const double widest2 = std::max((way + on.from * change).squaredNorm(),
                                    (way + on.to * change).squaredNorm());
    return (std::sqrt(widest2) + motion_->turn() * beside) / 2 + error;
}

std::optional<CuttingBody::Stretch> RayOnMotion::near_stretch(double from, double to,
                                                              double beside) const
{
    const CuttingBody::Stretch whole{from, to};
    const double within = spread(whole, largest_error(whole, beside), beside) + beside;
    const auto near = body_->near_stretch(middle_start(), middle_direction(), within);
    if (!near || near->to < from || near->from > to)
        return std::nullopt;
    return CuttingBody::Stretch{std::max(near->from, from), std::min(near->to, to)};
}

RayOnMotion RayOnMotion::moved(const Vec3& movement, const Vec3& seen_from_start,
                               const Vec3& seen_from_end) const
{
    RayOnMotion other = *this;
    other.start_ += movement;
    other.from_ += seen_from_start;
    other.to_ += seen_from_end;
    return other;
}

std::optional<RayOnMotion::Place> RayOnMotion::first_entry(double s, double most) const
{
    const double slack = motion_->turn() * (1 + motion_->turn() / 4);
    for (int step = 0; step < most_entry_steps; ++step) {
        const Distance here = distance(s, most - s);
        if (here.gap() <= accuracy_)
            return Place{s, here};
        const double fall = std::min(1.0, slack - rate(here.least));
        if (!(fall > 0) || !(s + here.gap() / fall < most))
            return std::nullopt;
        s += here.gap() / fall;
    }
    return place(s);
}

std::optional<RayOnMotion::Place> RayOnMotion::sure_entry(const Place& from, double most,
                                                          double margin) const
{
    if (!(from.s <= most))
        return std::nullopt;
    Place at = from;
    for (int step = 1;; ++step) {
        const Distance& here = at.distance;
        if (here.is_removed(margin))
            return at;
        const double fall = std::max(-rate(here.least), least_fall);
        const double s =
            at.s + (here.least.value + here.error + margin + accuracy_) / fall;
        if (step == most_sure_steps || !(s <= most))
            return std::nullopt;
        at = place(s);
    }
}

RayOnMotion RayOnMotion::reversed() const
{
    RayOnMotion other = *this;
    other.direction_ = -direction_;
    other.along_from_ = -along_from_;
    other.along_to_ = -along_to_;
    return other;
}

}  // namespace endmill
