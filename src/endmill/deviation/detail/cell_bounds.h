// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/deviation/detail/cut_ray.h"
#include "endmill/deviation/detail/half_space.h"
#include "endmill/deviation/part_charts.h"

namespace endmill {

/// A cell of the part with the measurement at its middle.
struct MeasuredCell {
    PartCell cell;
    PartRay ray;   ///< at its middle
    double reach;  ///< distance from the middle to the furthest corner, mm
    CutRay cut;    ///< ray at its middle after the moves
    PartCharts::CurvatureBounds curvature;  ///< of the part near the cell
    /// Whether the cell lies on an upright outer wall of the part, where remaining
    /// material is not judged.
    bool is_outer = false;
    /// Whether the cutter cannot reach the cell's middle, so that remaining material is not
    /// judged.
    bool is_inaccessible = false;
    /// Whether the cell lies on a facet whose remaining material is not judged.
    bool is_skipped = false;
    /// Thickness limited to the largest empty ball at the ray's point, mm; none if the
    /// ball does not limit it.
    std::optional<double> limited = {};
    /// Whether `limited` is exact; else it is a close upper bound.
    bool is_measured = true;
    double area = 0;       ///< mm^2
    CutRay in_stock = {};  ///< ray at its middle before any move

    /// Whether remaining material is judged on the cell.
    bool is_judged() const { return !is_outer && !is_inaccessible && !is_skipped; }

    /// The thickness at its middle, mm, up to the largest empty ball.
    double length() const { return limited.value_or(cut.thickness); }

    /// The thickness that counts at its middle, mm.
    double value() const { return is_judged() ? length() : std::min(length(), 0.0); }
};

/// Returns how much deeper than at the middle a gouge can be anywhere on the cell, in mm:
/// the height, over the cell's reach, of a circle whose curvature is the sum of those of
/// the corner and the part, above its tangent.
/// \param corner_radius in mm, above 0.
/// Source: paper/notes/deviation-bounds.md, eq. (a).
/// \pre the corner is round, and the part continues smoothly beyond the cell, so that the
///         depth of a sweep is stationary at its deepest place.
inline double hidden_gouge(const MeasuredCell& cell, double corner_radius)
{
    const double d = cell.reach;
    const double k = 1 / corner_radius + cell.curvature.convex;
    const double share = std::min(1.0, d * k);
    return d * share / (1 + std::sqrt((1 - share) * (1 + share)));
}

/// Returns a lower bound of the thickness on the whole cell in mm, at most 0, for any
/// cutter and at creases too. Separating planes bound the depth of each sweep. The bound
/// is minus infinity if a sweep clears the part and no plane bounds its depth.
/// Source: paper/notes/deviation-bounds.md, eq. (b).
/// \param all the sweeps by their numbers.
/// \param sweeps numbers of at least those sweeps that may clear the part on the cell.
double least_left_by_planes(const MeasuredCell& cell, std::span<const StraightSweep> all,
                            std::span<const std::int32_t> sweeps);

/// Returns a lower bound, below 0, of the thickness that a volume in the half space leaves
/// anywhere on the cell. It is infinite if the half space does not reach the cell, and
/// minus infinity if it does not bound the depth.
double least_by(const MeasuredCell& cell, const HalfSpace& half);

/// Thickness that a cutter leaves at a cell's corners, mm; minus infinity for a missing
/// fourth corner.
struct CornerValues {
    std::array<double, 4> at;  ///< mm

    /// The greatest of them, mm.
    double most() const { return *std::ranges::max_element(at); }
};

/// Returns the minimum over all convex combinations of `a` and `b` of the greatest corner
/// value. If both thicknesses are convex over the cell, their minimum is nowhere greater.
double least_of_means(const CornerValues& a, const CornerValues& b, int corners);

/// Returns the rays at the corners of a cell, drawn in by a rounding; nothing if one has
/// no normal.
std::optional<std::array<PartRay, 4>> corner_rays(const PartCell& cell,
                                                  const PartCharts& charts);

/// Returns those of `sweeps` that no separating plane keeps off the part on the cell.
std::vector<std::int32_t> sweeps_on_cell(const MeasuredCell& cell,
                                         std::span<const StraightSweep> all,
                                         std::span<const std::int32_t> sweeps);

/// A part of a cell: a point in parameters, and the largest distance of the part's points
/// from it.
struct ClearedPart {
    Eigen::Vector2d at;
    double reach;  ///< mm, from the partials at the cell's middle
};

/// Returns the part of the cell that the sweep may clear: the part inside the half space
/// which is perpendicular to the way from the cell's middle to the sweep.
/// \return nothing if the sweep clears nothing of the part on the cell.
std::optional<ClearedPart> part_cleared(const MeasuredCell& cell,
                                        const StraightSweep& sweep);

/// Returns an upper bound of the thickness on the whole cell in mm, from thickness and
/// slope at the middle and the curvatures of the cutter's corner and the part. It is
/// infinite for a sharp edge.
/// Source: paper/notes/deviation-bounds.md, eq. (s).
double most_left_by_slope(const MeasuredCell& cell, const Cutter& cutter);

/// Returns how much more than the measured thickness a sweep may leave at the cell's
/// middle and still leave the least somewhere on the cell, in mm: the reach times the
/// slopes of both sweeps, with a margin.
/// Source: paper/notes/deviation-bounds.md, "Which sweeps".
double owner_margin(const MeasuredCell& cell);

/// Returns those of `sweeps` that leave at most `owner_margin` more at the cell's middle
/// than the measured thickness, the lowest first.
std::vector<std::int32_t> local_sweeps(const MeasuredCell& cell,
                                       std::span<const StraightSweep> all,
                                       std::span<const std::int32_t> sweeps);

/// Returns an upper bound of the thickness on the whole cell in mm, from the thickness
/// that single sweeps leave at the cell's corners: the smallest bound by one of the first
/// six of `sweeps`, or by a convex combination of two of them. It is infinite if the part
/// has no normal at a corner, or if no sweep passes low over all corners.
/// Source: paper/notes/deviation-bounds.md, eq. (d), (e).
double most_left_by_corners(const MeasuredCell& cell, const PartCharts& charts,
                            std::span<const StraightSweep> all,
                            std::span<const std::int32_t> sweeps);

}  // namespace endmill
