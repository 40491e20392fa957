// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "endmill/surface/surface.h"

namespace endmill {

/// The radius of the largest ball that fits a surface, with the place that limits it.
struct CutterLimit {
    double radius_mm;     ///< radius of the largest ball
    std::size_t surface;  ///< number of the surface in a part of several, from 0
    SurfacePoint at;      ///< parameters of the contact at which the ball no longer fits
    Vec3 point;           ///< mm, the contact
};

/// The extremes of normal curvature over a surface, in 1/mm, positive where convex.
struct CurvatureRange {
    double least;     ///< 1/mm
    double greatest;  ///< 1/mm
};

/// The extremes of the principal curvatures over all closed patches; curvature may jump
/// at their borders. The best of 33 by 33 samples a patch (fewer, at least 5 by 5, on
/// surfaces of more than 3600 patches) is refined to a relative error of 1e-10. Places
/// without a normal are skipped. The last thousandth of a patch next to a pole is skipped
/// too, because rounding makes the curvature inaccurate there.
/// \param surface its patches are examined one by one.
/// \param side sign of the normal, from tool_side_sign.
/// \return nothing if no sample has a normal.
std::optional<CurvatureRange> curvature_range(const Surface& surface, double side);

/// The extremes over all `surfaces`.
/// \param surfaces of a part.
/// \param sides from tool_side_signs.
std::optional<CurvatureRange> curvature_range(std::span<const Surface> surfaces,
                                              std::span<const double> sides);

/// The largest ball that fits every concavity by its curvature alone: its radius is one
/// over the greatest concave principal curvature. The relative error is below 1e-8 if the
/// most concave place is wider than a sample spacing.
/// Source: [KimChoi, section 5.1] requires "the maximum cutter radius" without a formula.
/// \param surface its patches are examined one by one.
/// \param side sign of the normal, from tool_side_sign.
/// \return nothing if no place is concave.
std::optional<CutterLimit> largest_cutter_by_curvature(const Surface& surface,
                                                       double side);

/// The largest ball by curvature for all `surfaces`.
/// \param surfaces of a part.
/// \param sides from tool_side_signs.
std::optional<CutterLimit> largest_cutter_by_curvature(std::span<const Surface> surfaces,
                                                       std::span<const double> sides);

/// The results of `curvature_range` and of `largest_cutter_by_curvature` for a part.
struct CurvatureExtremes {
    std::optional<CurvatureRange> range;  ///< nothing if no sample has a normal
    std::optional<CutterLimit> limit;     ///< nothing if no place is concave
};

/// Both at once, from the same samples.
/// \param surfaces of a part.
/// \param sides from tool_side_signs.
CurvatureExtremes curvature_extremes(std::span<const Surface> surfaces,
                                     std::span<const double> sides);

/// The largest ball that can touch the surface at every point without entering it at
/// another point. Its radius is half the least |q - p|^2 / (N_p . (q - p)) over pairs of
/// points p, q. It never exceeds the radius by curvature, which is the limit q -> p.
///
/// Pairs closer than an eighth of a patch in both parameters are not tested; the limit by
/// curvature covers them. Creases are not considered, although strictly a crease admits
/// no ball. Use `continuity` to find them. The search takes at most 15 000 samples and
/// refines the best pairs. The relative error is below 1e-8 if the limiting pair is
/// further apart than a sample spacing.
/// \param surface its patches are examined together.
/// \param side sign of the normal, from tool_side_sign.
/// \return nothing if every ball fits; pairs that limit the radius to more than 8
///         diagonals are ignored.
std::optional<CutterLimit> largest_cutter(const Surface& surface, double side);

/// The largest ball for a part of several surfaces. It enters none of them. Pairs on two
/// surfaces count as close if their distance is below an eighth of the smaller patch's
/// size.
/// \param surfaces of the part.
/// \param sides from tool_side_signs.
std::optional<CutterLimit> largest_cutter(std::span<const Surface> surfaces,
                                          std::span<const double> sides);

/// The same if the limit by curvature is known.
/// \param by_curvature from largest_cutter_by_curvature for the same part.
std::optional<CutterLimit> largest_cutter(std::span<const Surface> surfaces,
                                          std::span<const double> sides,
                                          const std::optional<CutterLimit>& by_curvature);

}  // namespace endmill
