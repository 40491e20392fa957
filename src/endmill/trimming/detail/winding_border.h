// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "endmill/trimming/detail/plane_points.h"

namespace endmill {

/// A place on the segments of a plane. Segments and vertices are denoted by their numbers
/// in the plane's row of points.
struct BorderPlace {
    TrimmedKind kind;  ///< Vertex, Crossing or Link
    std::int32_t on;   ///< for a Vertex the vertex, otherwise the segment
    std::int32_t
        /// for a Crossing the other segment; for a Link the vertex above or below
        across;

    /// The place of a vertex.
    static BorderPlace vertex(std::int32_t number)
    {
        return {TrimmedKind::Vertex, number, number};
    }
};

/// A connected part of a border, with the kept region on its left. A closed one does not
/// repeat its first place. It has no places if a single segment carries all of it.
struct WindingBorder {
    std::vector<BorderPlace> places;  ///< in their order
    bool is_closed;                   ///< whether it has no ends
};

/// The borders of the region that method `winding` keeps (see winding_trimming.h). Their
/// order has no meaning but does not vary. Exact, by an arrangement of CGAL.
/// \pre `plane` was made from `curves`.
std::vector<WindingBorder> winding_borders(const PlanePoints& plane,
                                           std::span<const SectionCurve> curves);

}  // namespace endmill
