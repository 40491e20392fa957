// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "endmill/core/vec.h"
#include "endmill/surface/surface_jet.h"

namespace endmill {

/// The place of the part that the cutter touches when its reference point is at a vertex
/// of an offset mesh.
enum class ContactKind : std::uint8_t {
    /// The inside of a surface or a point of its border, with the surface's own normal.
    Face,
    ConvexCrease,   ///< an edge at which the part is convex
    ConcaveCrease,  ///< an edge at which the part is concave
    Border,         ///< the border of the part; the normal is rotated outwards about it
};

/// The contact of a vertex of an offset mesh. Its position is contact_point(offset,
/// vertex).
struct OffsetContact {
    /// Leaves all members uninitialised, because arrays of millions of contacts are
    /// filled after their allocation.
    OffsetContact() {}
    /// Sets all members.
    OffsetContact(const SurfacePoint& place, const Vec3& unit_normal,
                  std::int32_t surface_number, ContactKind touched)
        : at{place},
          normal{unit_normal},
          surface{surface_number},
          kind{touched}
    {
    }

    /// Parameters of the contact on its surface.
    SurfacePoint at;
    /// Unit, N_z >= 0; on an edge or a corner a normal between those of its neighbours.
    Vec3 normal;
    std::int32_t surface;  ///< number of the surface
    /// The place that the cutter touches.
    ContactKind kind;
};

}  // namespace endmill
