// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/detail/contact_strip.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/cutter/cutter.h"

namespace endmill {
namespace {

// An arc is not divided into shares smaller than this. Near the axis the bottom of a flat
// or bull-nose cutter turns faster than any sampling can follow.
constexpr double least_share = 0x1p-16;

double angle_between(const Vec3& one, const Vec3& other)
{
    return std::atan2(one.cross(other).norm(), one.dot(other));
}

// The reference points of a flat or bull-nose cutter while the normal follows an arc.
class BottomArc {
public:
    BottomArc(const NormalArc& arc, const Cutter& cutter, double tolerance)
        : arc_{arc},
          cutter_{cutter},
          tolerance_{tolerance},
          most_turn_{chord_angle(cutter.flat_radius(), tolerance / 2)},
          sine_{std::sin(most_turn_)},
          cosine_{std::cos(most_turn_)}
    {
    }

    // Divides `stretch` until the reference points of each piece lie within the tolerance
    // of their chord, and appends the ends of the pieces.
    void add_ends(const Interval& stretch, std::vector<double>& ends) const
    {
        std::vector<Piece> pieces{{place(stretch.low), place(stretch.high)}};
        while (!pieces.empty()) {
            const Piece piece = pieces.back();
            pieces.pop_back();
            const double low = piece.low.share;
            const double high = piece.high.share;
            if (high - low > least_share) {
                const Place middle = place(std::midpoint(low, high));
                if (!keeps_to_chord(piece, middle)) {
                    pieces.push_back({middle, piece.high});
                    pieces.push_back({piece.low, middle});
                    continue;
                }
            }
            ends.push_back(high);
        }
    }

private:
    struct Place {
        double share;
        Vec3 normal;
        Vec3 offset;  // from the contact to the reference point
    };
    struct Piece {
        Place low;
        Place high;
    };

    Place place(double share) const
    {
        const Vec3 normal = arc_.at(share);
        return {share, normal, control_offset(cutter_, normal)};
    }

    // Whether the bottom circle turns so little between two normals that the points
    // between stay within the tolerance of their chord.
    bool turns_little(const Vec3& one, const Vec3& other) const
    {
        const double along = one.x() * other.x() + one.y() * other.y();
        const double across = one.x() * other.y() - one.y() * other.x();
        return most_turn_ >= std::numbers::pi ||
               sine_ * along >= cosine_ * std::abs(across);
    }

    bool keeps_to_chord(const Piece& piece, const Place& middle) const
    {
        if (!turns_little(piece.low.normal, piece.high.normal))
            return false;
        const Vec3 chord = piece.high.offset - piece.low.offset;
        const Vec3 to_middle = middle.offset - piece.low.offset;
        const double length2 = chord.squaredNorm();
        const double share = length2 > 0 ? to_middle.dot(chord) / length2 : 0;
        return (to_middle - std::clamp(share, 0.0, 1.0) * chord).norm() <= tolerance_;
    }

    const NormalArc& arc_;
    const Cutter& cutter_;
    double tolerance_;
    double most_turn_;  // rad, largest turn of the bottom circle over a chord
    double sine_;
    double cosine_;
};

// Halves the interval until keeps(piece) holds for every piece.
// \return the upper ends of the pieces.
template <typename Keeps>
std::vector<double> ends_of_pieces(const Interval& whole, const Keeps& keeps)
{
    std::vector<double> ends;
    std::vector<Interval> pieces{whole};
    while (!pieces.empty()) {
        const Interval piece = pieces.back();
        pieces.pop_back();
        if (piece.length() <= least_share || keeps(piece)) {
            ends.push_back(piece.high);
            continue;
        }
        const double middle = std::midpoint(piece.low, piece.high);
        pieces.push_back({middle, piece.high});
        pieces.push_back({piece.low, middle});
    }
    return ends;
}

// The distance between a strip and the surface of reference points over its fixed
// contact. The two arcs of normals at the strip's sides are `gap` rad apart and pass the
// axis at `beside` rad. At an angle a beside the axis, the points on the bottom circle
// are gap / a rad apart. Their chord errs by (R - r) (gap / a)^2 / 8 across the circle,
// and by a times that along the normal. The error is at most r a^2 / 2, the height of the
// disc above the circle. Both bounds are equal at a = `worst`.
double error_beside_axis(const Cutter& cutter, double gap, double beside)
{
    const double bend = cutter.flat_radius() * gap * gap / 8;
    const double worst = std::cbrt(2 * bend / cutter.corner_radius());
    return bend > 0 ? bend / std::max(beside, worst) : 0;
}

// Whether the strip between the arcs from `normal` to two level normals is within the
// tolerance.
bool keeps_beside_axis(const Vec3& normal, const Vec3& one, const Vec3& other,
                       const ArcSampling& sampling)
{
    if (sampling.cutter.is_ball() || sampling.cutter.corner_radius() == 0)
        // a ball has no bottom circle; that of a flat cutter is not below its bottom
        return true;
    const double tilt = std::hypot(normal.x(), normal.y());
    const Vec3 across = normal.cross(one).stableNormalized();
    const Vec3 beyond = normal.cross(other).stableNormalized();
    // An arc that begins outwards leads away from the axis.
    const auto beside = [&](const Vec3& level, const Vec3& pole) {
        return normal.dot(level) >= 0 ? tilt : std::abs(pole.z());
    };
    const double least = std::min(beside(one, across), beside(other, beyond));
    const bool is_between = across.z() * beyond.z() <= 0 && least < tilt;
    return error_beside_axis(sampling.cutter, angle_between(across, beyond) * tilt,
                             is_between ? 0 : least) <= sampling.tolerance;
}

// Calls keep(triangle) for the triangles between two chains. The chain whose next share
// is smaller advances.
template <typename Keep>
void for_each_triangle(const ContactChain& right, const ContactChain& left,
                       const Keep& keep)
{
    const auto keep_triangle = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
        if (a != b && b != c && c != a)
            keep(Triangle{a, b, c});
    };
    const std::size_t last_right = right.vertices.size() - 1;
    const std::size_t last_left = left.vertices.size() - 1;
    std::size_t r = 0;
    std::size_t l = 0;
    while (r < last_right || l < last_left)
        if (l == last_left ||
            (r < last_right && right.shares[r + 1] <= left.shares[l + 1])) {
            keep_triangle(right.vertices[r], right.vertices[r + 1], left.vertices[l]);
            ++r;
        } else {
            keep_triangle(right.vertices[r], left.vertices[l + 1], left.vertices[l]);
            ++l;
        }
}

// The number of triangles between two chains that share no vertex except possibly the
// first.
std::size_t triangles_between(const ContactChain& right, const ContactChain& left)
{
    const std::size_t steps = right.vertices.size() + left.vertices.size() - 2;
    const bool is_one = right.vertices.front() == left.vertices.front();
    return steps - (is_one && steps > 0 ? 1 : 0);
}

}  // namespace

double chord_angle(double radius, double tolerance)
{
    if (radius <= tolerance)
        return std::numbers::pi;
    return 2 * std::acos(1 - tolerance / radius);
}

Vec3 NormalArc::at(double share) const
{
    return std::cos(share * angle) * start + std::sin(share * angle) * heading;
}

NormalArc arc_between(const Vec3& start, const Vec3& end)
{
    const Vec3 across = end - end.dot(start) * start;
    return {start, across.stableNormalized(), angle_between(start, end)};
}

NormalArc arc_over_border(const Vec3& normal, const Vec3& along)
{
    const Vec3 edge = along - along.dot(normal) * normal;
    const Vec3 outwards = edge.cross(normal).stableNormalized();
    return {normal, outwards, std::atan2(normal.z(), -outwards.z())};
}

namespace {

// The largest step of the equal ones into which an arc of normals is divided first, rad.
double even_step(const Cutter& cutter, double tolerance)
{
    return cutter.is_ball() ? chord_angle(cutter.radius(), tolerance)
                            : chord_angle(cutter.corner_radius(), tolerance / 2);
}

}  // namespace

std::vector<double> arc_shares(const NormalArc& arc, const Cutter& cutter,
                               double tolerance)
{
    const double step = even_step(cutter, tolerance);
    const int steps = std::max(1, static_cast<int>(std::ceil(arc.angle / step)));
    std::vector<double> shares{0};
    if (cutter.is_ball()) {
        shares.reserve(static_cast<std::size_t>(steps) + 1);
        for (int k = 1; k <= steps; ++k)
            shares.push_back(k / double(steps));
        return shares;
    }
    const BottomArc bottom{arc, cutter, tolerance};
    for (int k = 0; k < steps; ++k)
        bottom.add_ends({k / double(steps), (k + 1) / double(steps)}, shares);
    return shares;
}

std::vector<double> corner_shares(const NormalArc& level, const Vec3& normal,
                                  const ArcSampling& sampling, std::size_t least)
{
    const double step = chord_angle(sampling.cutter.radius(), sampling.tolerance);
    const auto steps = std::max(
        {std::size_t{1}, least, static_cast<std::size_t>(std::ceil(level.angle / step))});
    std::vector<double> shares{0};
    for (std::size_t k = 0; k < steps; ++k) {
        const auto count = static_cast<double>(steps);
        const Interval whole{static_cast<double>(k) / count,
                             static_cast<double>(k + 1) / count};
        const auto ends = ends_of_pieces(whole, [&](const Interval& piece) {
            return keeps_beside_axis(normal, level.at(piece.low), level.at(piece.high),
                                     sampling);
        });
        shares.insert(shares.end(), ends.begin(), ends.end());
    }
    return shares;
}

Vec3 level_end(const NormalArc& arc)
{
    const Vec3 end = arc.at(1);
    return Vec3{end.x(), end.y(), 0}.normalized();
}

std::int32_t OffsetDraft::add(const Vec3& point, const OffsetContact& contact)
{
    points.push_back(point + control_offset(cutter, contact.normal));
    contacts.push_back(contact);
    return static_cast<std::int32_t>(points.size() - 1);
}

ContactChain OffsetDraft::add_chain(std::int32_t from, const NormalArc& arc,
                                    ContactKind kind, std::optional<std::int32_t> to)
{
    const Vec3 point = contact_point(from);
    OffsetContact contact = contacts[from];
    contact.kind = kind;
    require_room(std::floor(arc.angle / even_step(cutter, arc_tolerance)));
    ContactChain chain{{from}, arc_shares(arc, cutter, arc_tolerance)};
    for (std::size_t k = 1; k < chain.shares.size(); ++k) {
        const bool is_last = k + 1 == chain.shares.size();
        if (is_last && to) {
            chain.vertices.push_back(*to);
            break;
        }
        contact.normal = is_last && kind == ContactKind::Border ? level_end(arc)
                                                                : arc.at(chain.shares[k]);
        chain.vertices.push_back(add(point, contact));
    }
    return chain;
}

void OffsetDraft::require_room(double more) const
{
    const double count = static_cast<double>(points.size()) + more;
    if (count > static_cast<double>(most_vertices))
        throw LimitError{
            "the offset with its strips over borders and creases would have at least " +
            std::to_string(static_cast<long long>(count)) +
            " vertices; expected at most " + std::to_string(most_vertices)};
}

// 1. The shares of all chains are computed on all threads.
// 2. The sums of their numbers give each chain its range of vertex numbers.
// 3. The vertices are computed on all threads.
// The result is the same as that of add_chain, called for one chain after the other.
std::vector<ContactChain> OffsetDraft::add_chains(std::span<const ChainPlan> plans,
                                                  ContactKind kind)
{
    const double step = even_step(cutter, arc_tolerance);
    double least = 0;
    for (const ChainPlan& plan : plans)
        least += std::floor(plan.arc.angle / step);
    require_room(least);
    std::vector<ContactChain> chains(plans.size());
    parallel_for(plans.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            chains[k].shares = arc_shares(plans[k].arc, cutter, arc_tolerance);
    });
    std::vector<std::size_t> first{points.size()};
    for (const ContactChain& chain : chains)
        first.push_back(first.back() + chain.shares.size() - 1);
    points.resize(first.back());
    contacts.resize(first.back());
    parallel_for(plans.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            fill_chain(plans[k], kind, first[k], chains[k]);
    });
    return chains;
}

void OffsetDraft::fill_chain(const ChainPlan& plan, ContactKind kind, std::size_t first,
                             ContactChain& chain)
{
    const Vec3 point = contact_point(plan.from);
    OffsetContact contact = contacts[plan.from];
    contact.kind = kind;
    chain.vertices.resize(chain.shares.size());
    chain.vertices[0] = plan.from;
    for (std::size_t k = 1; k < chain.shares.size(); ++k) {
        const bool is_level = k + 1 == chain.shares.size() && kind == ContactKind::Border;
        contact.normal = is_level ? level_end(plan.arc) : plan.arc.at(chain.shares[k]);
        const std::size_t vertex = first + k - 1;
        points[vertex] = point + control_offset(cutter, contact.normal);
        contacts[vertex] = contact;
        chain.vertices[k] = static_cast<std::int32_t>(vertex);
    }
}

void OffsetDraft::add_strip(const ContactChain& right, const ContactChain& left)
{
    for_each_triangle(right, left,
                      [&](const Triangle& triangle) { triangles.push_back(triangle); });
}

void OffsetDraft::add_strips(std::span<const ContactChain> chains,
                             std::span<const StripPlan> plans)
{
    std::vector<std::size_t> first(plans.size() + 1);
    for (std::size_t k = 0; k < plans.size(); ++k)
        first[k + 1] = triangles_between(chains[plans[k].right], chains[plans[k].left]);
    first[0] = triangles.size();
    std::partial_sum(first.begin(), first.end(), first.begin());
    triangles.resize(first.back());
    parallel_for(plans.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            auto place = triangles.begin() + static_cast<std::ptrdiff_t>(first[k]);
            for_each_triangle(chains[plans[k].right], chains[plans[k].left],
                              [&](const Triangle& triangle) { *place++ = triangle; });
        }
    });
}

Vec3 OffsetDraft::contact_point(std::int32_t vertex) const
{
    return points[vertex] - control_offset(cutter, contacts[vertex].normal);
}

}  // namespace endmill
