// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "endmill/surface/surface.h"

namespace endmill {

/// The radius at which a ball stops fitting a surface, and where.
struct CutterLimit {
    double radius_mm;
    std::size_t surface;  ///< which of several, from 0
    SurfacePoint at;      ///< where the ball touches
    Vec3 point;           ///< mm
};

/// Extremes of normal curvature over a surface, in 1/mm, positive where convex.
struct CurvatureRange {
    double least;
    double greatest;
};

/// Extremes of the principal curvatures of every closed patch (curvature may jump at
/// borders): the best of a grid of 33 by 33 samples a patch (5 by 5 at least on surfaces
/// of over 3600 patches), refined to 1e-10 of their size. Places without a normal are
/// passed over, and next to a pole the last thousandth of its patch, where curvature loses
/// its digits.
/// \param side from tool_side_sign.
/// \return nothing if no sample has a normal.
std::optional<CurvatureRange> curvature_range(const Surface& surface, double side);

/// The same over all `surfaces`, whose signs `sides` are from tool_side_signs.
std::optional<CurvatureRange> curvature_range(std::span<const Surface> surfaces,
                                              std::span<const double> sides);

/// Largest ball that fits every concavity by its curvature alone: one over the greatest
/// concave principal curvature.
/// Source: [KimChoi, section 5.1] asks for "the maximum cutter radius" without a formula.
/// \return nothing if no place is concave. Relative error below 1e-8 where the tightest
///         place is wider than a sample spacing.
std::optional<CutterLimit> largest_cutter_by_curvature(const Surface& surface,
                                                       double side);

/// The same over all `surfaces`, whose signs `sides` are from tool_side_signs.
std::optional<CutterLimit> largest_cutter_by_curvature(std::span<const Surface> surfaces,
                                                       std::span<const double> sides);

/// Largest ball that can touch the surface anywhere without reaching into it elsewhere:
/// the least |q - p|^2 / (2 N_p . (q - p)) over pairs of points, never above the limit by
/// curvature, which is the case q -> p. Pairs nearer than an eighth of a patch in both
/// parameters are left to curvature, and so is a crease, which strictly admits no ball:
/// `continuity` tells of it.
/// \return nothing if no ball is too large; pairs that admit one of 8 diagonals count as
///         none. Sought among at most 15 000 samples and refined; relative error below 1e-8
///         where the tightest pair lies further apart than a sample spacing.
std::optional<CutterLimit> largest_cutter(const Surface& surface, double side);

/// The same for a part of several surfaces: the ball reaches into none of them. Pairs on
/// two surfaces that lie nearer than an eighth of the smaller patch's size count as near.
/// \param sides from tool_side_signs.
std::optional<CutterLimit> largest_cutter(std::span<const Surface> surfaces,
                                          std::span<const double> sides);

}  // namespace endmill
