// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "endmill/cutter/cutter.h"
#include "endmill/drop_cutter/drop_cutter.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// Where a cutter comes nearest to the part, or goes deepest into it.
struct LeastGap {
    double gap;  ///< mm: 0 contact; negative, how deep a point of the part is inside
    std::size_t place;  ///< number of the cutter's place
    Vec3 point;         ///< of the part, mm
};

/// To what a gap is found unless another resolution is given, mm: a hundredth of what any
/// sampling leaves.
inline constexpr double gap_resolution = 1e-5;

/// The least gap between the cutter at any of the places `references` and smooth surfaces:
/// of a ball the distance of its centre from them less R; of others the signed distance of
/// their points from the cutter, its shank without end. Against the surfaces themselves:
/// by the hulls of their control points, halved where they leave it open. At most
/// `resolution` above the true one, and never below it but for rounding.
/// On all threads; the result does not depend on their number.
/// Source: spec of interference, section 1, min_clearance_mm.
///
/// \param references reference points (tip + r), mm, finite.
/// \return nothing without a place.
/// \throws DomainError unless there is a surface, the places are finite, 0 < resolution.
std::optional<LeastGap> least_gap(std::span<const Surface> surfaces, const Cutter& cutter,
                                  std::span<const Vec3> references,
                                  double resolution = gap_resolution);

/// The same for a mesh and its facets. \return nothing without a place or a triangle.
std::optional<LeastGap> least_gap(const DropCutter& drop_cutter,
                                  std::span<const Vec3> references,
                                  double resolution = gap_resolution);

}  // namespace endmill
