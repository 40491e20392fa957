// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/arc_fitting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "endmill/post/detail/plain_number.h"

// The circles through the two ends of a run of points are a family with one parameter t,
// the signed distance of the centre from the chord, along the normal n of the chord. With
// the middle M of the chord and half its length h, the power of a point P,
//
//     |P - C|^2 - r^2 = |P - M|^2 - h^2 - 2 t (P - M) . n,
//
// is linear in t, so the least squares of the powers give t in closed form. The candidate
// is then rounded to the words of the block, and the rounded arc is compared with the
// moves. Both are monotone in the angle about the centre, so the largest difference of
// their distances from the centre bounds the distance between the two curves.

namespace endmill {
namespace {

// An arc must replace this number of moves: a circle fits any two.
constexpr std::size_t fewest_moves = 3;
constexpr double smallest_radius_mm = 0.05;  // smaller corners are left to the control
constexpr double largest_radius_mm = 1e4;    // a greater arc is a line for most controls
// rad; below half a turn, where R is ambiguous and the centre is uncertain.
constexpr double largest_sweep = 3;
// mm. Controls refuse an arc whose radii at the two ends differ by more than 0.005 mm.
constexpr double largest_radius_difference_mm = 0.002;

// Share of the tolerance by which points may lie off the arc. The rest is for the chords:
// an arc close to all points replaces the error of their chords and adds none of its own.
constexpr double largest_point_share = 0.25;
constexpr double rounded_digits =
    2;  // points may be off by these last digits in any case

using Vec2 = Eigen::Vector2d;

double cross(const Vec2& a, const Vec2& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

// Fits and checks arcs from one point in one plane.
class PlaneFit {
public:
    PlaneFit(const ToolPath& path, std::size_t first, ArcPlane plane,
             const ArcFitting& fitting)
        : path_{path},
          first_{first},
          plane_{plane},
          axes_{plane_axes(plane)},
          fitting_{fitting},
          normal_{rounded(tip(first)[axes_.normal])}
    {
    }

    // The arc to point `last`, or nothing.
    std::optional<FittedArc> arc_to(std::size_t last) const
    {
        if (rounded(tip(last)[axes_.normal]) != normal_)
            return std::nullopt;
        FittedArc fitted{last, {}, std::nullopt, 0};
        fitted.arc.plane = plane_;
        fitted.arc.start = rounded_tip(first_);
        fitted.arc.end = rounded_tip(last);
        if (!place_centre(fitted) || !measure(fitted))
            return std::nullopt;
        return fitted;
    }

private:
    const Vec3& tip(std::size_t point) const { return path_.points[point].location.tip; }

    Vec2 flat(const Vec3& vector) const
    {
        return {vector[axes_.first], vector[axes_.second]};
    }

    double rounded(double mm) const
    {
        std::string ignored;
        return append_fixed(ignored, mm / fitting_.unit_mm, fitting_.decimals) *
               fitting_.unit_mm;
    }

    Vec3 rounded_tip(std::size_t point) const
    {
        const Vec3& exact = tip(point);
        return {rounded(exact.x()), rounded(exact.y()), rounded(exact.z())};
    }

    // Sets sense, centre and radius word by least squares of the powers.
    bool place_centre(FittedArc& fitted) const
    {
        const Vec2 start = flat(fitted.arc.start);
        const Vec2 end = flat(fitted.arc.end);
        const Vec2 middle = (start + end) / 2;
        const double half = (end - start).norm() / 2;
        if (!(half > 0))
            return false;
        const Vec2 along = (end - start) / (2 * half);
        const Vec2 normal{-along.y(), along.x()};
        double bow_times_power = 0;
        double bow_squares = 0;
        double bows = 0;
        for (std::size_t k = first_ + 1; k < fitted.last; ++k) {
            const Vec2 from_middle = flat(tip(k)) - middle;
            const double bow = from_middle.dot(normal);
            bow_times_power += bow * (from_middle.squaredNorm() - half * half);
            bow_squares += bow * bow;
            bows += bow;
        }
        const double t = bow_times_power / (2 * bow_squares);
        const double radius = std::hypot(half, t);
        if (!(smallest_radius_mm <= radius && radius <= largest_radius_mm) ||
            2 * std::atan2(half, std::abs(t)) > largest_sweep || t * bows >= 0)
            return false;
        fitted.arc.clockwise = bows > 0;
        return round_centre(fitted, start, middle + t * normal, radius);
    }

    // Rounds the centre, or the radius, to the words of the block.
    bool round_centre(FittedArc& fitted, const Vec2& start, const Vec2& centre,
                      double radius) const
    {
        Vec3 result = fitted.arc.start;
        if (fitting_.form == ArcForm::Radius) {
            fitted.radius = rounded(radius);
            const auto found = centre_of_radius(fitted.arc, *fitted.radius, 0);
            if (!found)
                return false;
            result = *found;
        } else {
            result[axes_.first] += rounded(centre.x() - start.x());
            result[axes_.second] += rounded(centre.y() - start.y());
        }
        fitted.arc.centre = result;
        return true;
    }

    // Measures the distance between the arc and the moves that it replaces. False if it
    // exceeds the tolerance, or if the moves turn back about the centre.
    bool measure(FittedArc& fitted) const
    {
        const ArcRadii radii = arc_radii(fitted.arc);
        const double difference = std::abs(radii.start - radii.end);
        if (difference > largest_radius_difference_mm)
            return false;
        // The ends of the arc differ from the points by their rounding.
        const double ends = std::max((fitted.arc.start - tip(first_)).norm(),
                                     (fitted.arc.end - tip(fitted.last)).norm());
        const Vec2 centre = flat(fitted.arc.centre);
        const double sense = fitted.arc.clockwise ? -1 : 1;
        const double point_tolerance =
            largest_point_share * fitting_.tolerance_mm +
            rounded_digits * fitting_.unit_mm * std::pow(10, -fitting_.decimals);
        Vec2 from = flat(tip(first_)) - centre;
        double error = 0;
        double last_off_plane = std::abs(tip(first_)[axes_.normal] - normal_);
        for (std::size_t k = first_ + 1; k <= fitted.last; ++k) {
            const Vec2 to = flat(tip(k)) - centre;
            if (sense * cross(from, to) < 0 || from.dot(to) <= 0 ||
                std::abs(to.norm() - radii.start) > point_tolerance)
                return false;
            const double in_plane =
                largest_difference(from, to, radii.start) + difference;
            // A chord is farthest from the plane at one of its ends.
            const double off_plane = std::abs(tip(k)[axes_.normal] - normal_);
            error = std::max(
                error, std::hypot(in_plane, std::max(off_plane, last_off_plane)) + ends);
            last_off_plane = off_plane;
            if (!(error <= fitting_.tolerance_mm))
                return false;
            from = to;
        }
        fitted.error_mm = error;
        return true;
    }

    // Largest difference of the distances from the centre, of a chord between two points
    // relative to the centre, and of a circle.
    static double largest_difference(const Vec2& from, const Vec2& to, double radius)
    {
        double error =
            std::max(std::abs(from.norm() - radius), std::abs(to.norm() - radius));
        const Vec2 chord = to - from;
        if (-from.dot(chord) > 0 && to.dot(chord) > 0)
            error = std::max(error,
                             std::abs(std::abs(cross(from, to)) / chord.norm() - radius));
        return error;
    }

    const ToolPath& path_;
    std::size_t first_;
    ArcPlane plane_;
    PlaneAxes axes_;
    const ArcFitting& fitting_;
    double normal_;
};

}  // namespace

std::optional<FittedArc> longest_arc(const ToolPath& path, std::size_t first,
                                     std::size_t end, const ArcFitting& fitting)
{
    if (end - first <= fewest_moves)
        return std::nullopt;
    for (const ArcPlane plane : {ArcPlane::Xy, ArcPlane::Zx, ArcPlane::Yz}) {
        const PlaneFit fit{path, first, plane, fitting};
        std::optional<FittedArc> longest = fit.arc_to(first + fewest_moves);
        if (!longest)
            continue;
        // Doubles the number of moves until an arc fails, then halves the gap.
        std::size_t failed = end;
        while (longest->last + 1 < failed) {
            const std::size_t moves = longest->last - first;
            const std::size_t next = failed == end ? std::min(first + 2 * moves, end - 1)
                                                   : (longest->last + failed) / 2;
            if (auto longer = fit.arc_to(next))
                longest = longer;
            else
                failed = next;
        }
        return longest;
    }
    return std::nullopt;
}

}  // namespace endmill
