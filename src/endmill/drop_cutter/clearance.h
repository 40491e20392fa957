// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include "endmill/cutter/cutter.h"
#include "endmill/drop_cutter/drop_cutter.h"
#include "endmill/offset/section_curve.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// The place at which a cutter is nearest to the part, or deepest in it.
struct LeastGap {
    double gap;  ///< mm; 0: contact; negative: depth of a part point inside the cutter
    std::size_t place;  ///< number of the cutter's position
    Vec3 point;         ///< the point of the part, mm
};

/// The default resolution of a gap in mm. The sampling error of a path is usually a
/// hundred times as large.
inline constexpr double gap_resolution = 1e-5;

/// How precisely a gap is measured, and who hears of the progress.
struct GapOptions {
    double resolution = gap_resolution;  ///< in mm
    /// If set, it is called with the finished share, 0 to 1, by any thread.
    std::function<void(double share)> progress = {};
};

/// The smallest gap between the cutter at any of the positions `references` and smooth
/// surfaces. For a ball it is the distance of its centre from the surfaces minus R. For
/// other cutters it is the signed distance of the surfaces' points from the cutter, whose
/// shank has no upper end. The surfaces are not sampled: convex hulls of their control
/// points give bounds, and pieces are halved where a bound is not sufficient. The result
/// exceeds the exact gap by at most `options.resolution` and is below it by rounding errors only.
/// Runs on all threads; the result does not depend on their number.
/// Source: docs/methods/interference.md, section 1 (min_clearance_mm).
///
/// \param surfaces the part.
/// \param cutter the cutter.
/// \param references reference points (tip + r) in mm, finite.
/// \param options resolution and progress.
/// \return nothing if there is no position.
/// \throws DomainError unless there is a surface, the positions are finite and 0 <
///     options.resolution.
std::optional<LeastGap> least_gap(std::span<const Surface> surfaces, const Cutter& cutter,
                                  std::span<const Vec3> references,
                                  const GapOptions& options = {});

/// The same for the facets of a mesh.
/// \param drop_cutter the mesh and the cutter.
/// \param references reference points (tip + r) in mm, finite.
/// \param options resolution and progress.
/// \return nothing if there is no position or no triangle.
/// \throws DomainError unless the positions are finite and 0 <
///     options.resolution.
std::optional<LeastGap> least_gap(const DropCutter& drop_cutter,
                                  std::span<const Vec3> references,
                                  const GapOptions& options = {});

/// The smallest gap between a cutter and curves of its own plane, such as the profiles of
/// which trimmed curves are the offset. The curves are taken as the sections of prisms
/// across the plane.
/// \param profiles curves as (s, z) in mm.
/// \param cutter the cutter.
/// \param references reference points as (s, z) in mm, finite.
/// \param options resolution and progress.
/// \return the gap, with its point as (s, 0, z); nothing if there is no position or no
///     segment.
/// \throws DomainError as DropCutter, and unless the positions are finite and 0 <
///     options.resolution.
std::optional<LeastGap> profile_gap(std::span<const SectionCurve> profiles,
                                    const Cutter& cutter,
                                    std::span<const SectionPoint> references,
                                    const GapOptions& options = {});

/// The greatest rise in mm of the mesh into the cutter, measured along the axis, at any of the
/// positions, and its place: the height at which the cutter rests there minus its own height.
/// It is 0 or below for a position that does not gouge, and never less than the depth of a
/// gouge. It takes a few microseconds for each position, far less than least_gap on positions
/// that touch the mesh. The contact is the point of the LeastGap, and minus the rise its gap.
/// \param drop_cutter the mesh and the cutter.
/// \param references reference points (tip + r) in mm, finite.
/// \param progress if set, is called with the finished share, 0 to 1.
/// \return nothing if no position is over the mesh.
/// \throws DomainError unless the positions are finite.
std::optional<LeastGap> greatest_rise(
    const DropCutter& drop_cutter, std::span<const Vec3> references,
    const std::function<void(double share)>& progress = {});

/// Whether a cutter can come within `distance` of a point of a mesh: placed such that it would
/// touch the point, and moved away from it by the distance along the normal, it is clear of the
/// mesh. A gouge up to `rest_gouge` counts as clear. On a level place a cutter with a flat
/// bottom may touch with any point of the bottom. The place is inaccessible only if the
/// mesh bars all these positions. Where it takes positions closer together than about the
/// distance, or more than a thousand, to know that, the place counts as accessible.
/// \param drop_cutter the mesh and the cutter.
/// \param contact the point and the unit normal of the part there; a normal that points
///     downwards is never accessible.
/// \param distance in mm, >= 0.
/// \throws DomainError unless the point is finite, the normal is a unit vector and the
///     distance is finite and not negative.
bool is_accessible(const DropCutter& drop_cutter, const CutterContact& contact,
                   double distance);

}  // namespace endmill
