// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include <Eigen/Core>

#include "endmill/visibility/detail/box_heights.h"
#include "endmill/visibility/detail/point_cells.h"

/// \file
/// Rays against unbounded walls, eight walls at a time. Which walls do the rays meet?
///
/// The frame of the walls has the axes *across*, *along* and *depth*. A wall goes from a
/// segment in the sense of rising *along*, with constant depth. Rays run in the sense of
/// rising depth. So a ray meets a wall if it starts between the ends of the segment across,
/// farther along than the segment, and at a smaller depth.

namespace endmill {

/// Eight walls. In lanes without a wall, `first` is 8 and `last` -8.
struct alignas(32) WallLanes {
    LaneFloats first{};        ///< least place across
    LaneFloats last{};         ///< largest place across
    LaneFloats along{};        ///< of the segment at `first`
    LaneFloats along_slope{};  ///< per length across
    LaneFloats along_doubt{};  ///< error bound
    LaneFloats depth{};        ///< of the segment at `first`
    LaneFloats depth_slope{};  ///< per length across
    LaneFloats depth_doubt{};  ///< error bound
    /// The walls through which a ray leaves a solid; it enters the solid through the others.
    unsigned leaving = 0;
};

/// Walls in strips of equal width across.
struct WallStrips {
    std::span<const std::uint32_t> begin;  ///< first block of each strip, and the end
    std::span<const WallLanes> blocks;
    float low = 0;  ///< where the first strip begins
    float strips_per_length = 0;
    float doubt = 0;  ///< error bound across

    /// Number of the strip at a place across, or of the nearest one.
    std::uint32_t strip_at(float across) const
    {
        const auto most = static_cast<float>(begin.size() - 2);
        return static_cast<std::uint32_t>(
            smaller(larger((across - low) * strips_per_length, 0), most));
    }
};

/// Answers for eight rays; no answer is certain for the lanes that are in neither set.
struct ExitLanes {
    unsigned none = 0;  ///< the ray leaves as often as it enters
    unsigned some = 0;  ///< it does not
};

/// Which rays leave a solid through walls more or less often than they enter it.
/// \param places where the rays start. \param frame maps them to the frame of the walls.
/// \param asked the lanes of the rays; the others get no answer.
ExitLanes ray_exits(const WallStrips& walls, const PlaceLanes& places,
                    const Eigen::Matrix3f& frame, unsigned asked);

/// The number of times that each ray that starts in a box leaves through walls, less the
/// times that it enters; nothing if that is uncertain, or not the same for all.
/// \param box in the frame of the walls.
std::optional<int> box_exits(const WallStrips& walls, const ProjectedBox& box);

}  // namespace endmill
