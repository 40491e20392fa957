// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "endmill/core/vec.h"
#include "endmill/cutter/cutter.h"
#include "endmill/cutter/tool.h"

/// \file
/// The cutting part of a tool as a convex body: its signed distance, and the least signed
/// distance along a segment. Places are given in the tool's frame: the tip is the origin,
/// the axis is +z.

namespace endmill {

/// The cutting part of a tool: a cutter up to a length above the tip. An immutable value.
class CuttingBody {
public:
    /// \param cutter the shape.
    /// \param length from the tip to the upper end, mm; infinity for an endless cutter.
    /// \throws DomainError unless the length is at least the corner radius, and positive.
    explicit CuttingBody(const Cutter& cutter,
                         double length = std::numeric_limits<double>::infinity());

    /// A cylinder of shank or holder, which is a flat cutter that begins above the tip.
    /// \throws DomainError unless 0 < diameter and 0 <= from < to.
    static CuttingBody of_cylinder(const ToolCylinder& cylinder);

    const Cutter& cutter() const { return cutter_; }  ///< the shape
    double base() const { return base_; }             ///< mm above the tip, lower end
    double length() const { return length_; }         ///< mm above the tip, upper end

    /// Signed distance of a place and its gradient there.
    struct Distance {
        double value;   ///< mm; negative inside
        Vec3 gradient;  ///< a subgradient, of length at most 1
    };

    /// Returns the signed distance of `place`. It is convex and changes by at most the
    /// distance between two places. Absolute error below 1e-15 times the coordinates.
    /// With the height h = z - r, the distance d from the axis and c = R - r it is
    ///
    ///     max(d - c, -h) - r              for d <= c, h >= 0,
    ///     d - c - r                       for d > c, h >= 0,
    ///     -h - r                          for d <= c, h < 0,
    ///     sqrt((d - c)^2 + h^2) - r       else,
    ///
    /// or z - length, if that is larger. The lower end of a cylinder is its base instead.
    /// Source: docs/methods/five-axis-removal.md, section 1.
    Distance distance(const Vec3& place) const;

    /// The least signed distance along a segment, with a proof that it is not less.
    struct Least {
        double value;  ///< mm, signed distance at `at`
        double at;     ///< parameter on the segment, 0 to 1
        /// mm; no place of the segment has a smaller distance. It is at most 1e-8 below
        /// `value`, unless the search ended early.
        double lower;
        /// If the segment moves by a vector m, no place of it gets a smaller distance than
        /// lower + gradient . m.
        Vec3 gradient;
    };

    /// Returns the least signed distance on the segment between two places. A ball has a
    /// closed form; other cutters need a search with two tangents.
    /// \param enough mm; the search ends as soon as no place has a smaller distance.
    Least least_on_segment(const Vec3& from, const Vec3& to,
                           double enough = std::numeric_limits<double>::infinity()) const;

    /// A stretch of a line, by its parameter.
    struct Stretch {
        double from;  ///< parameter of its begin
        double to;    ///< parameter of its end
    };

    /// Returns a stretch of the line start + s direction outside which every place is farther
    /// than `within` from the body. For a ball it is the shortest one but for rounding; for
    /// another cutter that of the cylinder around it.
    /// \param within mm, not negative. \param direction of any length.
    /// \return nothing if the whole line is farther. Without an end, the parameter there is
    ///         infinite.
    std::optional<Stretch> near_stretch(const Vec3& start, const Vec3& direction,
                                        double within) const;

    /// Returns the least w . y over all places y of the body, for a unit vector w; minus
    /// infinity for an endless cutter if w.z < 0.
    double support(const Vec3& direction) const;

private:
    Distance endless_distance(const Vec3& place) const;
    Least searched(const Vec3& from, const Vec3& to, double enough) const;

    Cutter cutter_;
    double base_ = 0;
    double length_;
};

// In the header, because removal asks this a billion times.
inline CuttingBody::Least CuttingBody::least_on_segment(const Vec3& from, const Vec3& to,
                                                        double enough) const
{
    if (!cutter_.is_ball())
        return searched(from, to, enough);
    // The squared distance from the half line z >= R on the axis is convex and piecewise
    // quadratic, with a break where z = R. On a segment along the axis it falls only below.
    const Vec3 way = to - from;
    const double radius = cutter_.radius();
    const double h = from.z() - radius;
    const double along = from.x() * way.x() + from.y() * way.y();
    const double square = way.x() * way.x() + way.y() * way.y();
    const bool is_below = way.z() == 0 ? h < 0 : along * way.z() >= h * square;
    const double steep = is_below ? square + way.z() * way.z() : square;
    const double slope = is_below ? along + h * way.z() : along;
    const double u = steep > 0 ? std::clamp(-slope / steep, 0.0, 1.0) : 0.0;
    const Vec3 place = from + u * way;
    const double below = std::min(place.z() - radius, 0.0);
    const double length =
        std::sqrt(place.x() * place.x() + place.y() * place.y() + below * below);
    const double value = length - radius;
    if (place.z() - length_ > value)
        return searched(from, to, enough);
    const double share = length > 0 ? 1 / length : 0;
    return {value, u, value, Vec3{share * place.x(), share * place.y(), share * below}};
}

}  // namespace endmill
