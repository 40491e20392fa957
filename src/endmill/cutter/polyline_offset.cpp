// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/core/tolerance.h"
#include "endmill/cutter/plane_offset.h"

// The polyline becomes a list of contacts: each point once with the normal of every
// segment that ends there, and at a convex corner with normals between them. plane_offset
// turns each contact into reference points. Consecutive contacts are joined by chords.
//
// At a concave corner the chord joins two reference points of one contact. The reference
// points at which this contact is inside the cutter form a convex region, so that the
// whole chord lies in it and trimming removes it.

namespace endmill {
namespace {

using Vec2 = Eigen::Vector2d;

constexpr double half_turn = std::numbers::pi;
const Vec2 upwards{0, 1};
const Vec2 leftwards{-1, 0};
const Vec2 rightwards{1, 0};

double cross(const Vec2& a, const Vec2& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

// The angle from normal `a` to normal `b`, from -pi (included) to pi. It is negative at a
// convex corner. A half turn counts as convex: the cutter rolls around the end of a sheet.
double turn_between(const Vec2& a, const Vec2& b)
{
    const double turn = std::atan2(cross(a, b), a.dot(b));
    return turn >= half_turn ? -half_turn : turn;
}

// Number of chords of an arc by `turn` whose error is at most the tolerance.
double pieces_of(double turn, const Cutter& cutter, const PolylineOffsetOptions& options)
{
    const double radius = cutter.corner_radius();
    if (radius <= options.arc_tolerance)
        return 1;
    const double step = 4 * std::asin(std::sqrt(options.arc_tolerance / (2 * radius)));
    return std::max(1.0, std::ceil(std::abs(turn) / step));
}

// Collects the contacts of a polyline.
class Contacts {
public:
    Contacts(const Cutter& cutter, const PolylineOffsetOptions& options)
        : cutter_{cutter},
          options_{options}
    {
    }

    void add(const Vec2& point, const Vec2& normal) { list_.push_back({point, normal}); }

    // Adds the normals between `from` and `to` at a corner, both excluded. The normal
    // straight up is always among those of an arc over it, because the side of a flat
    // bottom that touches changes there.
    void roll(const Vec2& point, const Vec2& from, const Vec2& to)
    {
        if (!options_.rolls_around_corners || turn_between(from, to) >= 0)
            return;
        const bool is_over_top = from.x() < -level_normal && to.x() > level_normal &&
                                 cross(from, upwards) < 0 && cross(upwards, to) < 0;
        if (!is_over_top) {
            add_arc(point, from, to);
            return;
        }
        add_arc(point, from, upwards);
        add(point, upwards);
        add_arc(point, upwards, to);
    }

    const std::vector<ProfilePoint>& list() const { return list_; }

private:
    void add_arc(const Vec2& point, const Vec2& from, const Vec2& to)
    {
        const double turn = turn_between(from, to);
        const double start = std::atan2(from.y(), from.x());
        const double pieces = pieces_of(turn, cutter_, options_);
        for (double k = 1; k < pieces; ++k) {
            const double angle = start + turn * k / pieces;
            add(point, {std::cos(angle), std::sin(angle)});
        }
    }

    const Cutter& cutter_;
    const PolylineOffsetOptions& options_;
    std::vector<ProfilePoint> list_;
};

// The left normals of all segments.
std::vector<Vec2> left_normals(const Cutter& cutter, std::span<const Vec2> polyline)
{
    std::vector<Vec2> normals;
    for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
        const Vec2 along = (polyline[i + 1] - polyline[i]).stableNormalized();
        normals.emplace_back(-along.y(), along.x());
        if (!cutter.is_ball() && along.x() < 0)
            throw GeometryError{
                "the profile has an overhang from s = " + to_text(polyline[i].x()) +
                ", z = " + to_text(polyline[i].y()) +
                " mm, which a flat bottom cannot touch; expected s not to decrease, or a "
                "ball"};
    }
    return normals;
}

void check(std::span<const Vec2> polyline, const PolylineOffsetOptions& options)
{
    require(polyline.size() >= 2, "polyline_offset: need two points");
    require(options.arc_tolerance > 0, "polyline_offset: need 0 < arc_tolerance");
    for (std::size_t i = 0; i < polyline.size(); ++i)
        require(polyline[i].allFinite() && (i == 0 || polyline[i] != polyline[i - 1]),
                "polyline_offset: need finite points, consecutive ones different");
}

void erase_repeated(std::vector<Vec2>& points)
{
    points.erase(std::unique(points.begin(), points.end()), points.end());
}

// All contacts of the polyline in their order.
Contacts contacts_of(const Cutter& cutter, std::span<const Vec2> polyline,
                     const PolylineOffsetOptions& options)
{
    const std::vector<Vec2> normals = left_normals(cutter, polyline);
    const bool is_closed = polyline.front() == polyline.back();
    Contacts contacts{cutter, options};
    // A border is rolled around until the normal is level; an end that overhangs is not.
    if (!is_closed && options.rolls_around_corners && normals.front().y() >= 0 &&
        normals.front() != leftwards) {
        contacts.add(polyline.front(), leftwards);
        contacts.roll(polyline.front(), leftwards, normals.front());
    }
    for (std::size_t i = 0; i < normals.size(); ++i) {
        if (i > 0)
            contacts.roll(polyline[i], normals[i - 1], normals[i]);
        contacts.add(polyline[i], normals[i]);
        contacts.add(polyline[i + 1], normals[i]);
    }
    if (is_closed) {
        contacts.roll(polyline.back(), normals.back(), normals.front());
        contacts.add(polyline.front(), normals.front());
    } else if (options.rolls_around_corners && normals.back().y() >= 0 &&
               normals.back() != rightwards) {
        contacts.roll(polyline.back(), normals.back(), rightwards);
        contacts.add(polyline.back(), rightwards);
    }
    return contacts;
}

}  // namespace

PolylineOffset polyline_offset(const Cutter& cutter, std::span<const Vec2> polyline,
                               const PolylineOffsetOptions& options)
{
    check(polyline, options);
    const bool is_closed = polyline.front() == polyline.back();
    PolylineOffset offset{
        plane_offset(cutter, contacts_of(cutter, polyline, options).list()), 0, 0};
    erase_repeated(offset.points);
    // The caps at the ends of an open polyline do not count for the range.
    PolylineOffsetOptions plain = options;
    plain.rolls_around_corners = is_closed && options.rolls_around_corners;
    std::vector<Vec2> covered =
        plane_offset(cutter, contacts_of(cutter, polyline, plain).list());
    covered.insert(covered.end(), polyline.begin(), polyline.end());
    const auto by_s = [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); };
    const auto [low, high] = std::ranges::minmax_element(covered, by_s);
    offset.low_s = low->x();
    offset.high_s = high->x();
    return offset;
}

double polyline_offset_size(const Cutter& cutter, std::span<const Vec2> polyline,
                            const PolylineOffsetOptions& options)
{
    check(polyline, options);
    const std::vector<Vec2> normals = left_normals(cutter, polyline);
    // Two contacts a segment, two reference points a contact, and two arcs at the ends.
    double size = 4 * static_cast<double>(polyline.size());
    if (!options.rolls_around_corners)
        return size;
    size += 2 * pieces_of(half_turn, cutter, options);
    for (std::size_t i = 1; i < normals.size(); ++i) {
        const double turn = turn_between(normals[i - 1], normals[i]);
        if (turn < 0)
            size += 2 + pieces_of(turn, cutter, options);
    }
    return size;
}

}  // namespace endmill
