// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/bounded_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "endmill/deviation/detail/cut_ray.h"
#include "endmill/machine/tool_motion.h"
#include "endmill/stock/detail/ray_on_motion.h"

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Rounding error of a distance in mm, for coordinates up to some metres.
constexpr double rounding = 1e-10;
// Depth in mm below a place that may be removed at which the search for the end of a gouge
// starts.
constexpr double first_step = 2e-8;
constexpr int most_steps = 40;
// Least rate at which the distance is assumed to grow into the part.
constexpr double least_rise = 0.02;
// Steps of the search for the depth of one pose.
constexpr int most_halvings_of_depth = 20;
// Pieces are halved at most this often: the error falls to a millionth.
constexpr int most_halvings = 10;
// A piece is not halved if its error is below this share of the sharpness: the ray then
// grazes the cutter.
constexpr double small_error_share = 0.1;
// A gouge is followed down to this depth, mm.
constexpr double deepest_gouge = 1e4;
// Steps by which a direction is turned until it points away from no axis.
constexpr int most_projections = 16;
// Sine of the angle by which a direction may point below a plane across the axis. On an
// endless cutter it changes a half space by less than the rounding of the coordinates.
constexpr double level_sine = 1e-13;

// Returns a lower bound of the thickness where the ray's point may be removed: below it
// no pose reaches the point.
double gouge_entry(const RayOnMotion& on)
{
    double s = 0;
    for (int step = 0; step < most_steps && s >= -deepest_gouge; ++step) {
        const RayOnMotion::Distance here = on.distance(s);
        if (here.gap() > 0) {
            const auto entry = on.first_entry(s, 0);
            return entry ? entry->s : 0;
        }
        const double rise = std::max(-on.rate(here.least), least_rise);
        s -= (first_step - here.gap()) / rise;
    }
    return -deepest_gouge;
}

// A place on the ray that is removed for certain by a pose that counts.
struct SurePlace {
    double s;
    CuttingBody::Least least;  // of the pose
};

// Returns the deepest such place found below a point that is removed for certain. The pose
// must remove the point too; then it removes all between them, because it is convex.
// \param low lower bound of the thickness.
SurePlace sure_gouge(const RayOnMotion& on, const RayOnMotion::Distance& at_point,
                     double low)
{
    const RayOnMotion::Place lowest = on.place(low);
    const auto sure = on.sure_entry(lowest, 0);
    const double error = std::max(at_point.error, lowest.distance.error);
    if (sure && on.at_pose(0, sure->distance.least.at) <= -error)
        return {sure->s, sure->distance.least};
    double inside = 0;
    double outside = low;
    for (int step = 0; step < most_halvings_of_depth; ++step) {
        const double middle = (inside + outside) / 2;
        (on.at_pose(middle, at_point.least.at) <= -error ? inside : outside) = middle;
    }
    return {inside, at_point.least};
}

// Returns a place at or beyond the ray's point that is removed for certain.
// \param from lower bound of the thickness.
std::optional<SurePlace> sure_place(const RayOnMotion& on, double from, double most)
{
    const auto sure = on.sure_entry(on.place(std::max(0.0, from)), most);
    return sure ? std::optional{SurePlace{sure->s, sure->distance.least}} : std::nullopt;
}

// How the bounds of a ray are lowered by a piece.
struct BoundedCut {
    const PartRay& ray;
    const ToolPiece& piece;
    double sharpness;  // mm
};

// Lowers the bounds by a motion of the piece, which is halved at most `halvings` times.
void cut(BoundedRay& bounded, const BoundedCut& by, const ToolMotion& motion,
         int halvings)
{
    const PartRay& ray = by.ray;
    const RayOnMotion on{ray.point, ray.normal, motion, by.piece.body};
    const RayOnMotion::Distance at_point = on.distance(0, std::max(0.0, bounded.low));
    std::optional<double> low;
    if (at_point.gap() <= 0) {
        low = gouge_entry(on);
    } else if (at_point.gap() < bounded.low) {
        if (const auto entry = on.first_entry(0, bounded.low))
            low = entry->s;
    }
    if (!low || !(*low < bounded.low))
        return;
    const std::optional<SurePlace> sure = at_point.is_removed()
                                              ? sure_gouge(on, at_point, *low)
                                              : sure_place(on, *low, bounded.high);
    if (sure && sure->s < bounded.high) {
        bounded.high = sure->s;
        bounded.piece = &by.piece;
        bounded.slope = slope_of_cosine(on.rate(sure->least));
    }
    const bool is_sharp = bounded.high - *low <= by.sharpness;
    const double error = motion.chord_error(ray.point + *low * ray.normal);
    if (is_sharp || halvings == 0 || error <= small_error_share * by.sharpness) {
        bounded.low = *low;
        return;
    }
    for (const ToolMotion& half : motion.halves())
        cut(bounded, by, half, halvings - 1);
}

}  // namespace

void cut(BoundedRay& bounded, const PartRay& ray, const ToolPiece& piece,
         double sharpness)
{
    cut(bounded, BoundedCut{ray, piece, sharpness}, piece.motion, most_halvings);
}

PieceDistance distance_from(const ToolPiece& piece, const Vec3& place, double enough)
{
    const ToolMotion& motion = piece.motion;
    const double error = motion.chord_error(place) + rounding;
    const CuttingBody::Least least = piece.body.least_on_segment(
        motion.from().seen(place), motion.to().seen(place), enough + error);
    return {least.lower - error, least.at, least.gradient,
            motion.turn() * (1 + motion.turn() / 4)};
}

Vec3 seen_from(const ToolPiece& piece, const PieceDistance& distance, const Vec3& v)
{
    return (1 - distance.at) * (piece.motion.from().axes.transpose() * v) +
           distance.at * (piece.motion.to().axes.transpose() * v);
}

bool may_reach(const ToolPiece& piece, const RayDisc& rays)
{
    const double far = rays.reach + rays.length;
    const PieceDistance nearest = distance_from(piece, rays.centre, far + rays.sag);
    const double along = nearest.out.dot(seen_from(piece, nearest, rays.normal));
    const double across =
        std::sqrt(std::max(0.0, nearest.out.squaredNorm() - along * along));
    // Directions seen from the tool at other poses differ by the turn.
    const double slack = 2 * nearest.slack * far + rays.sag + rays.tilt * rays.length;
    return nearest.lower - across * rays.reach + std::min(0.0, along) * rays.length <=
           slack;
}

std::optional<double> thickness_by(const ToolPiece& piece, const PartRay& ray,
                                   double near, double before)
{
    const RayOnMotion on{ray.point, ray.normal, piece.motion, piece.body};
    // By the turn, a place between others may be farther from the cutter than they are; and
    // the error of the straight line changes between them.
    const double turn = piece.motion.turn();
    const double margin = turn * (1 + turn) * near / 4;
    const auto low = on.first_entry(0, before);
    if (!low)
        return std::nullopt;
    const auto sure = on.sure_entry(*low, before, margin);
    return sure ? std::optional{sure->s} : std::nullopt;
}

HalfSpace half_space_of(const ToolPiece& piece, const Vec3& normal)
{
    const ToolMotion& motion = piece.motion;
    const CuttingBody& body = piece.body;
    const bool is_endless = std::isinf(body.length());
    const double sag = 2 * motion.axis_sag();
    Vec3 w = normal;
    const auto projected = [&] {
        bool is_done = true;
        for (const ToolFrame* frame : {&motion.from(), &motion.to()})
            if (const double along = w.dot(frame->axes.col(2)) - sag;
                along < -level_sine) {
                w -= along * frame->axes.col(2);
                is_done = false;
            }
        return is_done;
    };
    for (int step = 0; is_endless && step < most_projections && !projected(); ++step) {
    }
    const double length = w.norm();
    HalfSpace half{length > 0 ? Vec3{w / length} : normal, -infinite};
    double least = infinite;
    for (const ToolFrame* frame : {&motion.from(), &motion.to()}) {
        Vec3 seen = frame->axes.transpose() * half.normal;
        if (std::abs(seen.z()) <= 2 * level_sine)
            seen.z() = 0;
        least = std::min(least, half.normal.dot(frame->tip) + body.support(seen));
    }
    half.least = least - half_space_slack(piece) - rounding;
    return half;
}

double half_space_slack(const ToolPiece& piece)
{
    const CuttingBody& body = piece.body;
    // The lowest place of the cutter lies at most this far from the tip.
    const double far = std::hypot(
        body.cutter().radius(),
        std::isinf(body.length()) ? body.cutter().corner_radius() : body.length());
    return piece.motion.largest_tool_bend(far) / 8;
}

}  // namespace endmill
