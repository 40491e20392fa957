// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/ball_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "endmill/core/detail/widest_registers.h"
#include "endmill/deviation/detail/cut_ray.h"
#include "endmill/stock/detail/tile_heights.h"

// The volume that a ball sweeps on a move, open above, is the union of two parts:
// 1. the capsule: the ball swept along the segment between its centres (`enter_capsule`);
// 2. everything above the capsule's outline: an upright prism over the rectangle that the
//    middle section sweeps (`enter_prism`) and two upright cylinders over the balls at
//    the ends (`enter_round`).
// A ray's line enters the union at the smallest of the entries. Part 2 is computed only
// if some line may enter it before the capsule. Every loop computes all cases and selects
// one, so that the compiler processes several rays at once; `cut_ray` is the same for one
// ray with branches.
// Source: paper/notes/swept-cutter.md.

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

using Row = RayRows::Row;

// Copies the rays that may be shortened, which are often few, and lists their numbers.
void pick(const RayRows& rows, const Row& short_by, RayRows& few,
          std::array<int, most_tile_cells>& which)
{
    int count = 0;
    for (int k = 0; k < rows.count; ++k) {
        which[count] = k;
        count += short_by[k] < 0 ? 1 : 0;
    }
    few.count = count;
    for (int i = 0; i < few.padded(); ++i) {
        const int k = which[std::min(i, count - 1)];
        for (std::size_t c = 0; c < 3; ++c) {
            few.point[c][i] = rows.point[c][k];
            few.normal[c][i] = rows.normal[c][k];
        }
        few.left[i] = i < count ? rows.left[k] : -infinite;
        few.cosine[i] = rows.cosine[k];
        few.sweep[i] = rows.sweep[k];
    }
}

// A move of a ball.
struct BallMove {
    double radius;  // mm
    double x;       // mm, centre at the start
    double y;
    double z;
    double dx;  // mm, the whole move
    double dy;
    double dz;
    double squared;      // squared length of the move
    double per_squared;  // 1 / squared; 0 for a move without length
    double lowest;       // mm, lowest centre
    double length;       // mm, in the xy plane
    double along_x;      // unit direction in the xy plane
    double along_y;
    double slope;
};

BallMove ball_move(const StraightSweep& sweep)
{
    const double radius = sweep.cutter().radius();
    const Vec3 move = sweep.to() - sweep.from();
    const double squared = move.squaredNorm();
    const double length = sweep.length();
    return {.radius = radius,
            .x = sweep.from().x(),
            .y = sweep.from().y(),
            .z = sweep.from().z() + radius,
            .dx = move.x(),
            .dy = move.y(),
            .dz = move.z(),
            .squared = squared,
            .per_squared = squared > 0 ? 1 / squared : 0,
            .lowest = std::min(sweep.from().z(), sweep.to().z()) + radius,
            .length = length,
            .along_x = length > 0 ? move.x() / length : 1,
            .along_y = length > 0 ? move.y() / length : 0,
            .slope = sweep.slope()};
}

// Where the lines of rays enter the swept volume, or a part of it.
struct Entries {
    Row t;       // mm; infinite if the line misses it
    Row cosine;  // between the normal of the surface there and the line
    Row inside;  // below 0 if the ray's point is outside
};

// Where the line of a ray enters the capsule.
struct CapsuleEntry {
    double t;       // mm; infinite if the line misses it
    double cosine;  // as in Entries
    double inside;  // as in Entries
    double open;    // above 0 if another part may be entered earlier
};

// Computes how far the point (ox, oy, oz), from the centre at the start, is inside the
// capsule, in mm^2.
inline double depth_in_capsule(const BallMove& move, double ox, double oy, double oz)
{
    const double along = (move.dx * ox + move.dy * oy + move.dz * oz) * move.per_squared;
    const double positive = select(along > 0, along, 0);
    const double nearest = select(positive < 1, positive, 1);
    const double qx = ox - nearest * move.dx;
    const double qy = oy - nearest * move.dy;
    const double qz = oz - nearest * move.dz;
    return move.radius * move.radius - (qx * qx + qy * qy + qz * qz);
}

// Computes the entry of ray `k`.
inline CapsuleEntry capsule_entry(const RayRows& rows, const BallMove& move, int k)
{
    const double square = move.radius * move.radius;
    const double nx = rows.normal[0][k];
    const double ny = rows.normal[1][k];
    const double nz = rows.normal[2][k];
    const double ox = rows.point[0][k] - move.x;
    const double oy = rows.point[1][k] - move.y;
    const double oz = rows.point[2][k] - move.z;
    const double dn = move.dx * nx + move.dy * ny + move.dz * nz;
    const double d_o = move.dx * ox + move.dy * oy + move.dz * oz;
    const double on = ox * nx + oy * ny + oz * nz;
    const double oo = ox * ox + oy * oy + oz * oz;
    // Entry into the infinite cylinder around the segment.
    const double a = move.squared - dn * dn;
    const double b = move.squared * on - d_o * dn;
    const double c = move.squared * (oo - square) - d_o * d_o;
    const double h = b * b - a * c;
    const double t_beside = (-b - std::sqrt(select(h > 0, h, 0))) / a;
    const double at = (d_o + t_beside * dn) * move.per_squared;
    const bool is_oblique = a > 0;
    const bool is_beside = is_oblique & (at >= 0) & (at <= 1);
    // Entry into the ball at an end of the segment. A line along the move enters the
    // nearer ball.
    const double far = select(is_oblique, at, 0.5 - dn);
    const bool is_last = far > 0.5;
    const double vx = select(is_last, ox - move.dx, ox);
    const double vy = select(is_last, oy - move.dy, oy);
    const double vz = select(is_last, oz - move.dz, oz);
    const double vn = vx * nx + vy * ny + vz * nz;
    const double px = vx - vn * nx;
    const double py = vy - vn * ny;
    const double pz = vz - vn * nz;
    const double rest = square - (px * px + py * py + pz * pz);
    const double t_end = -vn - std::sqrt(select(rest > 0, rest, 0));
    // A line that misses the cylinder also misses the balls.
    const double least = select(is_oblique & (h < rest), h, rest);
    const double t = select(is_beside, t_beside, t_end);
    const double over = select(is_beside, h, least);
    const double end_dn = select(is_last, dn, 0);
    // The lower half of the capsule's surface belongs to the boundary of the whole
    // volume. The upright parts start at the height of the centres.
    const double end_dz = select(is_last, move.dz, 0);
    const double height = oz + t * nz - select(is_beside, at * move.dz, end_dz);
    const double above = select(over >= 0, height, infinite);
    const double reached = rows.point[2][k] + rows.left[k] * nz - move.lowest;
    const double high = select(nz >= 0, reached, infinite);
    const double both = select(above < high, above, high);
    // A point above the capsule may also be cleared.
    const double inside = depth_in_capsule(move, ox, oy, oz);
    const bool is_over = (t < 0) & (inside < 0);
    const double over_it = select(is_over, rows.point[2][k] - move.lowest, both);
    return {.t = select(over >= 0, t, infinite),
            .cosine = (on + t - select(is_beside, at * dn, end_dn)) / move.radius,
            .inside = inside,
            .open = select(both > over_it, both, over_it)};
}

// Shortens ray `k` if its entry comes before its end. An entry below the ray's point counts
// only if the volume clears the point. A volume that ends at the point, within rounding,
// leaves thickness 0.
inline void shorten(RayRows& rows, int k, const CapsuleEntry& entry, double number)
{
    const double t = entry.t;
    const double left = rows.left[k];
    const bool clears = (t >= 0) | (entry.inside >= 0);
    const bool touches = (t >= -touching_depth) & (left > 0);
    const bool is_shorter = (t < left) & (clears | touches);
    const double kept = select(clears, t, 0);
    rows.left[k] = select(is_shorter, kept, left);
    rows.cosine[k] = select(is_shorter, entry.cosine, rows.cosine[k]);
    rows.sweep[k] = select(is_shorter, number, rows.sweep[k]);
}

// Computes the entries into the capsule, and shortens the rays if that is all.
// \return whether a line may enter another part earlier. The rays are unchanged then.
ENDMILL_WIDEST_REGISTERS
bool enter_capsule(RayRows& rows, const BallMove& move, double number, Entries& entries)
{
    const BallMove own = move;
    std::array<double, RayRows::lanes> open{};
    for (int first = 0; first < rows.padded(); first += RayRows::lanes) {
        ENDMILL_NOT_UNROLLED
        for (int lane = 0; lane < RayRows::lanes; ++lane) {
            const int k = first + lane;
            const CapsuleEntry entry = capsule_entry(rows, own, k);
            entries.t[k] = entry.t;
            entries.cosine[k] = entry.cosine;
            entries.inside[k] = entry.inside;
            open[lane] = select(entry.open > open[lane], entry.open, open[lane]);
        }
    }
    if (std::ranges::max(open) > 0)
        return true;
    for (int k = 0; k < rows.padded(); ++k)
        shorten(rows, k, {entries.t[k], entries.cosine[k], entries.inside[k], 0}, number);
    return false;
}

// The interval low <= t <= high of a line.
struct Bounds {
    double low = -infinite;
    double high = infinite;
};

// Returns the part of the interval where value + t rate >= 0.
// \param per_rate 1 / rate, if the rate is not 0.
inline Bounds where_positive(const Bounds& bounds, double value, double rate,
                             double per_rate)
{
    const double at = -value * per_rate;
    const double low = select((rate > 0) & (at > bounds.low), at, bounds.low);
    const double high = select((rate < 0) & (at < bounds.high), at, bounds.high);
    return {select((rate == 0) & (value < 0), infinite, low), high};
}

// A ray in the coordinates of the move: s along it and e across it seen from above, and
// z, all from the centre at its start; then the rates of these along the ray.
struct RayInPlan {
    double s;
    double e;
    double z;
    double rate_s;
    double rate_e;
    double rate_z;
};

// Converts ray `k`.
inline RayInPlan in_plan(const RayRows& rows, BallMove move, int k)
{
    const double ox = rows.point[0][k] - move.x;
    const double oy = rows.point[1][k] - move.y;
    const double nx = rows.normal[0][k];
    const double ny = rows.normal[1][k];
    return {ox * move.along_x + oy * move.along_y,
            oy * move.along_x - ox * move.along_y,
            rows.point[2][k] - move.z,
            nx * move.along_x + ny * move.along_y,
            ny * move.along_x - nx * move.along_y,
            rows.normal[2][k]};
}

// Where the lines enter the upright parts, and whether the rays' points are inside.
struct Upright {
    Row t;
    Row inside;  // as in Entries
};

// Computes the entries into the prism above the rectangle that the ball's middle section
// sweeps.
ENDMILL_WIDEST_REGISTERS
void enter_prism(const RayRows& rows, BallMove move, Upright& upright)
{
    const double R = move.radius;
    const double nothing = move.length > 0 ? -infinite : infinite;
    for (int k = 0; k < rows.padded(); ++k) {
        const RayInPlan ray = in_plan(rows, move, k);
        const double rate_over = ray.rate_z - move.slope * ray.rate_s;
        const double per_s = 1 / ray.rate_s;
        const double per_e = 1 / ray.rate_e;
        Bounds prism{nothing, infinite};
        prism =
            where_positive(prism, ray.z - move.slope * ray.s, rate_over, 1 / rate_over);
        prism = where_positive(prism, R + ray.e, ray.rate_e, per_e);
        prism = where_positive(prism, R - ray.e, -ray.rate_e, -per_e);
        prism = where_positive(prism, ray.s, ray.rate_s, per_s);
        prism = where_positive(prism, move.length - ray.s, -ray.rate_s, -per_s);
        upright.t[k] = select(prism.low <= prism.high, prism.low, infinite);
        upright.inside[k] = select(-prism.low < prism.high, -prism.low, prism.high);
    }
}

// Computes the entries into the upright cylinder over the ball at the start of the move
// (`share` 0) or at its end (`share` 1), where these are earlier.
ENDMILL_WIDEST_REGISTERS
void enter_round(const RayRows& rows, BallMove move, double share, Upright& upright)
{
    const double square = move.radius * move.radius;
    const double way = share * move.length;
    const double rise = share * move.dz;
    for (int k = 0; k < rows.padded(); ++k) {
        const RayInPlan ray = in_plan(rows, move, k);
        const double a = ray.rate_s * ray.rate_s + ray.rate_e * ray.rate_e;
        const double per_a = 1 / a;
        const double x = ray.s - way;
        const double nearest = -(x * ray.rate_s + ray.e * ray.rate_e) * per_a;
        const double px = x + nearest * ray.rate_s;
        const double py = ray.e + nearest * ray.rate_e;
        const bool is_upright = !(a > 0);
        const double away = select(is_upright, x * x + ray.e * ray.e, px * px + py * py);
        const double rest = square - away;
        const double half = std::sqrt(select(rest > 0, rest, 0) * per_a);
        const double low = select(is_upright, -infinite, nearest - half);
        const double high = select(is_upright, infinite, nearest + half);
        Bounds round{select(rest >= 0, low, infinite), high};
        round = where_positive(round, ray.z - rise, ray.rate_z, 1 / ray.rate_z);
        const bool is_sooner = (round.low <= round.high) & (round.low < upright.t[k]);
        upright.t[k] = select(is_sooner, round.low, upright.t[k]);
        const double inside = select(-round.low < round.high, -round.low, round.high);
        upright.inside[k] = select(inside > upright.inside[k], inside, upright.inside[k]);
    }
}

// Replaces the entries into the capsule by entries into the upright parts where these are
// earlier. Such an entry lies on the upright outline.
ENDMILL_WIDEST_REGISTERS
void enter_sooner(const RayRows& rows, BallMove move, const Upright& upright,
                  Entries& entries)
{
    for (int k = 0; k < rows.padded(); ++k) {
        const RayInPlan ray = in_plan(rows, move, k);
        const double t = upright.t[k];
        const double s = ray.s + t * ray.rate_s;
        const double e = ray.e + t * ray.rate_e;
        const double positive = select(s > 0, s, 0);
        const double nearest = select(positive < move.length, positive, move.length);
        const double out = s - nearest;
        const double size = std::sqrt(out * out + e * e);
        const double across = (out * ray.rate_s + e * ray.rate_e) / size;
        // A line that is inside for all t came from above.
        const double cosine = select((size > 0) & (size < infinite), across, -ray.rate_z);
        const bool is_sooner = t < entries.t[k];
        entries.cosine[k] = select(is_sooner, cosine, entries.cosine[k]);
        entries.t[k] = select(is_sooner, t, entries.t[k]);
        entries.inside[k] =
            select(upright.inside[k] >= 0, upright.inside[k], entries.inside[k]);
    }
}

// Shortens the rays by the entries.
ENDMILL_WIDEST_REGISTERS
void take(RayRows& rows, const Entries& entries, double number)
{
    for (int k = 0; k < rows.padded(); ++k)
        shorten(rows, k, {entries.t[k], entries.cosine[k], entries.inside[k], 0}, number);
}

}  // namespace

void shorten_by_ball(RayRows& rows, const StraightSweep& sweep, std::int32_t number,
                     const Row& short_by)
{
    RayRows few;
    std::array<int, most_tile_cells> which;
    pick(rows, short_by, few, which);
    const BallMove move = ball_move(sweep);
    Entries entries;
    if (enter_capsule(few, move, number, entries)) {
        Upright upright;
        enter_prism(few, move, upright);
        enter_round(few, move, 0, upright);
        enter_round(few, move, 1, upright);
        enter_sooner(few, move, upright, entries);
        take(few, entries, number);
    }
    for (int i = 0; i < few.count; ++i) {
        const auto k = static_cast<std::size_t>(which[static_cast<std::size_t>(i)]);
        rows.left[k] = few.left[static_cast<std::size_t>(i)];
        rows.cosine[k] = few.cosine[static_cast<std::size_t>(i)];
        rows.sweep[k] = few.sweep[static_cast<std::size_t>(i)];
    }
}

}  // namespace endmill
