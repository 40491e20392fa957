// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "endmill/core/detail/lanes.h"
#include "endmill/visibility/detail/point_cells.h"

/// \file
/// Eight facets, projected along a direction, against many points: which points do the
/// facets cover? A facet covers a point that lies inside its outline and below its plane,
/// seen along the direction. Floats with error bounds find most answers; exact arithmetic
/// decides the rest.

namespace endmill {

/// Eight projected facets with the coefficients of their edge functions and depths.
///
/// Edge functions and depth take the difference (dx, dy, dz) of a point and the first
/// corner. They are divided by a bound of their error: a value is positive inside or
/// below, and its sign is certain if its magnitude exceeds 1.
struct alignas(32) ShadowLanes {
    std::array<std::int32_t, float_lanes> facet{};  ///< numbers of the facets
    /// [corner][axis], within [-1, 1].
    std::array<std::array<LaneFloats, 3>, 3> corner{};

    std::array<float, 2> low{};   ///< least x and y of points that may be covered
    std::array<float, 2> high{};  ///< largest x and y of points that may be covered
    float highest = 0;            ///< largest z of points that may be covered
    /// Edge functions: factors of dx, dy.
    std::array<std::array<LaneFloats, 2>, 3> side{};
    LaneFloats second_offset{};         ///< constant term of edge function 1
    std::array<LaneFloats, 3> depth{};  ///< depth: factors of dx, dy, dz
    LaneFloats low_dz{};                ///< dz is raised to this value
    LaneFloats high_dz{};               ///< dz is lowered to this value
    LaneFloats facing{};       ///< 0 or less: the sign of the normal's z is uncertain
    bool has_edge_on = false;  ///< `facing` is 0 or less for some facet
};

/// A point that a facet may cover: rounding errors may have changed the answer.
struct UncertainCover {
    std::uint32_t place;  ///< of the point in PointCells
    std::int32_t facet;   ///< number of the facet
};

/// The points found to be covered.
struct CoveredPoints {
    /// For each block: bit k is set if the point in lane k is covered.
    std::vector<std::uint8_t> covered_lanes;
    std::vector<UncertainCover> uncertain;  ///< to be decided by exact arithmetic

    /// Tests whether the point in a place is known to be covered.
    bool is_covered(std::size_t place) const
    {
        return (covered_lanes[place / PointBlock::size] >> (place % PointBlock::size) &
                1U) != 0;
    }
};

/// Computes all coefficients from the corners.
/// \param shadows with facets and corners. \param accuracy error bound of the coordinates
///         of corners and points, at least 2^-25.
void prepare_shadows(ShadowLanes& shadows, float accuracy);

/// Marks the points that certainly are covered, and lists those that may be. A facet does
/// not cover its own centroid.
/// \param shadows prepared. \param cells points.
/// \param covered has a byte for each block; results are added to it.
void mark_covered(const ShadowLanes& shadows, const PointCells& cells,
                  CoveredPoints& covered);

}  // namespace endmill
