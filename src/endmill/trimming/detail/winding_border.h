// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "endmill/trimming/detail/plane_points.h"

namespace endmill {

/// A place on the segments of a plane, which, and its vertices, go by their numbers in the
/// plane's row of points.
struct BorderPlace {
    TrimmedKind kind;  ///< no End
    std::int32_t on;   ///< a vertex, of a Vertex; else a segment
    std::int32_t
        across;  ///< a segment, of a Crossing; a vertex above or below, of a Link

    static BorderPlace vertex(std::int32_t number)
    {
        return {TrimmedKind::Vertex, number, number};
    }
};

/// A stretch of a border, what is kept on its left. A closed one does not repeat its first
/// place. There can be none, where one segment carries all of it.
struct WindingBorder {
    std::vector<BorderPlace> places;
    bool is_closed;
};

/// The borders of what method `winding` keeps, as winding_trimming.h tells, in no order
/// that means anything, but always the same. Exact: CGAL's arrangement, which stays inside.
/// \pre `plane` is that of `curves`.
std::vector<WindingBorder> winding_borders(const PlanePoints& plane,
                                           std::span<const SectionCurve> curves);

}  // namespace endmill
