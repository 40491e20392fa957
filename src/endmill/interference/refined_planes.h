// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "endmill/interference/offset_mesh.h"
#include "endmill/interference/slicer.h"
#include "endmill/interference/trimming.h"

namespace endmill {

/// Where trimmed sections come from.
struct SectionSource {
    std::span<const Surface> surfaces;       ///< of the part
    const OffsetMesh& offset;                ///< theirs
    int grid_lines;                          ///< as OffsetOptions had them
    const DrivePlanes& planes;               ///< those that sliced it
    std::span<const PlaneSection> sections;  ///< one a plane
};

/// Trimmed curves whose points lie on the smooth offset.
struct RefinedPlanes {
    std::vector<std::vector<TrimmedCurve>> curves;  ///< one a plane
    std::size_t unrefined = 0;                      ///< points that are kept as sampled
    double greatest_shift = 0;  ///< mm, of the others: the error of the sampling there
};

/// How deep in mm the cutter may enter the part at a refined point: below what is asked of
/// its height, 1e-4 mm, and above what Newton's method leaves.
inline constexpr double refined_gouge = 1e-5;

/// Puts what is left of the sections on the smooth offset by Newton's method: a crossing by
/// its two contacts at once, any other point over its s, right to 1e-9 mm. A point is kept
/// as sampled where the search does not converge within the neighbouring cells, over
/// corners of the part and level places of a flat bottom, and where the cutter would enter
/// the part elsewhere by more than `refined_gouge`. Points that a crossing has passed by
/// are left out. On all threads; the result does not depend on their number.
/// Source: specification of the interference removal, section 6.
/// \param trimmed one a plane. \throws DomainError unless there are as many as sections.
RefinedPlanes refine_planes(const SectionSource& source,
                            std::span<const Trimmed> trimmed);

/// An estimate of the error in mm of what is left as sampled: how far refining would move a
/// point at most, of those that it could move.
double sampling_error(const SectionSource& source, std::span<const Trimmed> trimmed);

}  // namespace endmill
