// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "endmill/core/tolerance.h"
#include "endmill/drop_cutter/detail/corner_touch.h"
#include "endmill/drop_cutter/detail/triangle_contact.h"

namespace endmill {

/// A point relative to the cutter's axis, mm.
template <typename Real>
struct AxisPlace {
    Real x;  ///< horizontal
    Real y;  ///< horizontal
    Real z;  ///< height
};

/// A side of the triangle. Shares count from 0 at its start to 1 at its end, in plan.
template <typename Real>
struct TriangleSide {
    const AxisPlace<Real>& from;  ///< its start
    const AxisPlace<Real>& to;    ///< its end
    Real length2;                 ///< squared length in plan
    Real rise;                    ///< from start to end, mm
    Real foot;   ///< share of the point of the whole line that is nearest to the axis
    Real away2;  ///< squared distance of that point from the axis
    Real half2;  ///< squared half length of the chord that the rim of the cutter cuts off
};

/// Lowers a cutter onto a triangle (see TriangleDrop), with the digits of Real:
/// 1. The touching point of the triangle's plane is computed. If it lies in the triangle,
///    it is the contact.
/// 2. Otherwise the contact is on a side that has the touching point on its outer side.
///    Each such side is tested, with a closed formula for a ball and for a flat cutter,
///    and by Newton's method for a bull-nose (CornerTouch).
/// 3. If the contact of a side is beyond its end, the corner counts. Every step that
///    loses digits adds to is_doubtful.
template <typename Real>
class TriangleLowering {
public:
    /// \param shape the cutter; it must outlive this object.
    /// \param least mm; contacts below it are of no interest.
    TriangleLowering(const CutterShape<Real>& shape, double least)
        : shape_{shape},
          least_{least}
    {
    }

    /// Whether rounding errors may have moved the contact by more than tip_accuracy.
    bool is_doubtful() const { return is_doubtful_; }

    /// The highest contact found.
    /// \param x of the axis, mm.
    /// \param y of the axis, mm.
    TriangleContact contact(double x, double y) const
    {
        if (!is_found_)
            return {};
        return {value_of(tip_),
                {value_of(Real{x} + at_.x), value_of(Real{y} + at_.y), value_of(at_.z)},
                kind_};
    }

    /// Lowers the cutter; to be called once.
    /// \param corners relative to the axis.
    void lower_onto(const std::array<AxisPlace<Real>, 3>& corners)
    {
        const auto& [a, b, c] = corners;
        const AxisPlace<Real> ab{b.x - a.x, b.y - a.y, b.z - a.z};
        const AxisPlace<Real> ac{c.x - a.x, c.y - a.y, c.z - a.z};
        AxisPlace<Real> normal{ab.y * ac.z - ab.z * ac.y, ab.z * ac.x - ab.x * ac.z,
                               ab.x * ac.y - ab.y * ac.x};
        const bool is_turned = normal.z < Real{0};
        if (is_turned)
            normal = {-normal.x, -normal.y, -normal.z};
        if (!(normal.z > Real{0}))
            return lower_onto_sides(corners, {true, true, true});
        doubt_plane(ab, ac, normal);
        const PlaneTouch plane = touching_point(normal, a);
        if (plane.highest < least_)
            return;
        const AxisPlace<Real>& touched = plane.point;
        std::array<bool, 3> is_beyond;
        for (int k = 0; k < 3; ++k) {
            const AxisPlace<Real>& from = corners[k];
            const AxisPlace<Real>& to = corners[(k + 1) % 3];
            const Real area = (to.x - from.x) * (touched.y - from.y) -
                              (to.y - from.y) * (touched.x - from.x);
            is_beyond[k] = is_turned ? area > Real{0} : area < Real{0};
        }
        if (is_beyond[0] || is_beyond[1] || is_beyond[2])
            return lower_onto_sides(corners, is_beyond);
        keep(plane.tip, touched, TouchKind::Facet);
    }

private:
    static constexpr double unit_rounding = std::numeric_limits<double>::epsilon();
    // Bound of the rounding errors in a height that follows from a normal or from a point
    // of a line in few operations, relative to tip_accuracy.
    static constexpr double doubt = 4 * unit_rounding / tip_accuracy;

    static double square(double number) { return number * number; }

    // Doubts the plane if the rounding error of its normal tilts it by too much over the
    // size of the triangle.
    void doubt_plane(const AxisPlace<Real>& ab, const AxisPlace<Real>& ac,
                     const AxisPlace<Real>& normal)
    {
        const auto length2 = [](const AxisPlace<Real>& v) {
            return square(value_of(v.x)) + square(value_of(v.y)) + square(value_of(v.z));
        };
        const AxisPlace<Real> bc{ac.x - ab.x, ac.y - ab.y, ac.z - ab.z};
        const double longest2 = std::max(std::max(length2(ab), length2(ac)), length2(bc));
        is_doubtful_ |=
            doubt * doubt * longest2 * longest2 * longest2 > square(value_of(normal.z));
    }

    struct PlaneTouch {
        AxisPlace<Real> point;
        Real tip;
        double highest;  // upper bound of the tip
    };

    // The point at which the cutter touches the plane through `on`.
    PlaneTouch touching_point(const AxisPlace<Real>& normal,
                              const AxisPlace<Real>& on) const
    {
        using std::sqrt;
        const Real level2 = normal.x * normal.x + normal.y * normal.y;
        const Real length = sqrt(level2 + normal.z * normal.z);
        Real out = shape_.r / length;
        if (shape_.c > Real{0} && level2 > Real{0})
            out = out + shape_.c / sqrt(level2);
        const Real x = -(normal.x * out);
        const Real y = -(normal.y * out);
        const Real slant = normal.x * (x - on.x) + normal.y * (y - on.y);
        const Real share = Real{1} / normal.z;
        const AxisPlace<Real> point{x, y, on.z - slant * share};
        const Real tip = point.z - shape_.r * (Real{1} - normal.z / length);
        // The terms of the slant may cancel, those of the point's coordinates do not.
        const double lever =
            value_of(shape_.R) + std::abs(value_of(on.x)) + std::abs(value_of(on.y));
        const double steepness = std::abs(value_of(length * share));
        return {point, tip,
                value_of(tip) + 16 * unit_rounding * lever * steepness + tip_accuracy};
    }

    void lower_onto_sides(const std::array<AxisPlace<Real>, 3>& corners,
                          const std::array<bool, 3>& which)
    {
        for (int k = 0; k < 3; ++k)
            if (which[k])
                lower_onto_side(corners[k], corners[(k + 1) % 3]);
    }

    void lower_onto_side(const AxisPlace<Real>& from, const AxisPlace<Real>& to)
    {
        using std::sqrt;
        if (std::max(value_of(from.z), value_of(to.z)) + tip_accuracy < least_)
            return;
        const Real x = to.x - from.x;
        const Real y = to.y - from.y;
        const Real length2 = x * x + y * y;
        if (!(length2 > Real{0}))  // a vertical side
            return lower_onto_corner(from.z > to.z ? from : to);
        const Real share = Real{1} / length2;
        const Real area = from.x * y - from.y * x;
        const Real away2 = area * area * share;
        const TriangleSide<Real> side{from,
                                      to,
                                      length2,
                                      to.z - from.z,
                                      -((from.x * x + from.y * y) * share),
                                      away2,
                                      shape_.R * shape_.R - away2};
        doubt_side(side);
        if (side.half2 < Real{0})
            return;
        if (!(shape_.c > Real{0}))
            touch_with_ball(side);
        else if (!(shape_.r > Real{0}))
            touch_with_disc(side);
        else
            touch_with_corner(side);
    }

    // Doubts a height along the side, and a height at the end of a chord.
    void doubt_side(const TriangleSide<Real>& side)
    {
        const double length2 = value_of(side.length2);
        const double rise2 = square(value_of(side.rise));
        const double radius2 = square(value_of(shape_.R));
        const double size2 =
            3 * doubt * doubt * ((square(value_of(side.foot)) + 1) * length2 + radius2);
        is_doubtful_ |=
            size2 * rise2 > length2 || std::abs(value_of(side.half2)) * length2 <
                                           2 * radius2 * size2 * (length2 + rise2);
    }

    void touch_with_ball(const TriangleSide<Real>& side)
    {
        using std::sqrt;
        const Real slant2 = side.length2 + side.rise * side.rise;
        const Real tilt = sqrt(side.half2 / (side.length2 * slant2));
        const Real along = side.foot + tilt * side.rise;
        if (!(along > Real{0}))
            return lower_onto_corner(side.from);
        if (!(along < Real{1}))
            return lower_onto_corner(side.to);
        const AxisPlace<Real> point = at(side, along);
        keep(point.z - shape_.R + side.length2 * tilt, point, TouchKind::Edge);
    }

    // The shares of the part of a side that is below the cutter. If there is none, `low`
    // exceeds `high`.
    struct Below {
        Real low;
        Real high;
    };
    static Below below_cutter(const TriangleSide<Real>& side)
    {
        using std::sqrt;
        const Real half = sqrt(side.half2 / side.length2);
        const Real end = side.foot + half;
        return {positive(side.foot - half), end < Real{1} ? end : Real{1}};
    }

    void touch_with_disc(const TriangleSide<Real>& side)
    {
        const Below below = below_cutter(side);
        if (below.low > below.high)
            return;
        Real along = side.rise > Real{0} ? below.high : below.low;
        if (!(side.rise < Real{0}) && !(side.rise > Real{0}))
            along = side.foot < below.low    ? below.low
                    : side.foot > below.high ? below.high
                                             : side.foot;
        keep_at(side, along, at(side, along).z);
    }

    // The bull-nose cutter: the side is followed in the direction in which it rises.
    void touch_with_corner(const TriangleSide<Real>& side)
    {
        using std::sqrt;
        const Below below = below_cutter(side);
        if (below.low > below.high)
            return;
        const Real length = sqrt(side.length2);
        const bool rises = side.rise > Real{0};
        const RisingLine<Real> line{(rises ? side.rise : -side.rise) / length, side.away2,
                                    side.from.z + side.foot * side.rise};
        const Real low =
            (rises ? below.low - side.foot : side.foot - below.high) * length;
        const Real high =
            (rises ? below.high - side.foot : side.foot - below.low) * length;
        const CornerTouch<Real> touch{shape_, line};
        const std::optional<Real> t = touch.highest(low, high, least_);
        if (!t)
            return;
        const Real share = *t / length;
        Real along = rises ? side.foot + share : side.foot - share;
        if (!(*t > low))  // at an end, with the same bits
            along = rises ? below.low : below.high;
        else if (!(*t < high))
            along = rises ? below.high : below.low;
        keep_at(side, along, at(side, along).z - touch.profile(*t));
    }

    void lower_onto_corner(const AxisPlace<Real>& corner)
    {
        using std::sqrt;
        const Real half2 = half2_of(corner);
        doubt_corner(half2);
        if (half2 < Real{0})
            return;
        const Real& r = shape_.r;
        const Real distance = sqrt(corner.x * corner.x + corner.y * corner.y);
        const Real a = positive(distance - shape_.c);
        const Real root = sqrt(shape_.c > Real{0} ? positive((r - a) * (r + a)) : half2);
        keep(corner.z - (r - root), corner, TouchKind::Vertex);
    }

    Real half2_of(const AxisPlace<Real>& corner) const
    {
        return shape_.R * shape_.R - (corner.x * corner.x + corner.y * corner.y);
    }

    // Doubts a height at the rim of the cutter.
    void doubt_corner(const Real& half2)
    {
        is_doubtful_ |=
            std::abs(value_of(half2)) < square(doubt * square(value_of(shape_.R)));
    }

    static AxisPlace<Real> at(const TriangleSide<Real>& side, const Real& along)
    {
        const AxisPlace<Real>& p = side.from;
        return {p.x + along * (side.to.x - p.x), p.y + along * (side.to.y - p.y),
                p.z + along * side.rise};
    }

    void keep_at(const TriangleSide<Real>& side, const Real& along, const Real& tip)
    {
        if (along > Real{0} && along < Real{1})
            return keep(tip, at(side, along), TouchKind::Edge);
        const AxisPlace<Real>& corner = along > Real{0} ? side.to : side.from;
        doubt_corner(half2_of(corner));
        keep(tip, corner, TouchKind::Vertex);
    }

    void keep(const Real& tip, const AxisPlace<Real>& point, TouchKind kind)
    {
        if (is_found_ && !(tip > tip_))
            return;
        is_found_ = true;
        tip_ = tip;
        at_ = point;
        kind_ = kind;
    }

    const CutterShape<Real>& shape_;
    double least_;
    bool is_doubtful_ = false;
    bool is_found_ = false;
    Real tip_{0};
    AxisPlace<Real> at_{Real{0}, Real{0}, Real{0}};
    TouchKind kind_ = TouchKind::Facet;
};

}  // namespace endmill
