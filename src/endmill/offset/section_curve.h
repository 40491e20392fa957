// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace endmill {

/// A point of a section of an offset: s along the feed and z, both in mm, of the cutter's
/// reference point.
using SectionPoint = Eigen::Vector2d;

/// A connected curve of the section of an offset mesh by a drive plane, with its folds
/// and loops. An open curve begins at its end of smaller s, and the tool is on its left.
/// A closed curve keeps its direction, begins at its point of smallest s (and smallest z
/// among those), and repeats that point at its end. A curve has at least two points, and
/// consecutive points are different.
struct SectionCurve {
    std::vector<SectionPoint> points;  ///< in their order
    bool is_closed = false;            ///< the last point repeats the first
};

/// An edge of a mesh that a plane t = c crosses, directed from the vertex with t <= c to
/// the vertex with t > c.
struct CrossedEdge {
    std::int32_t below;  ///< number of the vertex with t <= c
    std::int32_t above;  ///< number of the vertex with t > c
    friend bool operator==(const CrossedEdge&, const CrossedEdge&) = default;
};

/// Brings curves into the form of SectionCurve, and into the order of their smallest s
/// and, among equal ones, of z there. An open curve whose ends have equal s keeps its
/// direction.
/// \param curves curves with at least two points each; the last point of a closed one
///     equals its first.
std::vector<SectionCurve> arranged(std::vector<SectionCurve> curves);

/// Numbers of the points of a polyline that remain if it is thinned: chords replace runs of
/// points. Every point of the thinned polyline lies within `tolerance` of the given one, and
/// every point of the given one within `tolerance` of the thinned one. The first and the last
/// point remain. Each chord is the longest that a cone of directions from its beginning
/// allows; the time is linear in the number of points.
///
/// A cutter that is moved by a distance d goes at most d deeper into a part. Therefore the
/// gouge of a thinned path exceeds that of the given one by at most the tolerance, and so does
/// the remaining stock.
/// Source: docs/methods/interference.md, section 1 (thinned paths).
/// \param points in their order, any number.
/// \param tolerance in mm; 0: all points remain.
/// \throws DomainError unless 0 <= tolerance and it is finite.
std::vector<std::size_t> thinned(std::span<const SectionPoint> points, double tolerance);

}  // namespace endmill
