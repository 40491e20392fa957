// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "endmill/offset/offset_mesh.h"
#include "endmill/offset/slicer.h"
#include "endmill/trimming/trimming.h"

namespace endmill {

/// Where trimmed sections come from.
struct SectionSource {
    std::span<const Surface> surfaces;       ///< of the part
    const OffsetMesh& offset;                ///< theirs
    const DrivePlanes& planes;               ///< those that sliced it
    std::span<const PlaneSection> sections;  ///< one a plane
};

/// Trimmed curves at whose points the cutter rests on the smooth part.
struct RefinedPlanes {
    std::vector<std::vector<TrimmedCurve>> curves;  ///< one a plane
    std::size_t unrefined = 0;                      ///< points that are kept as sampled
    double greatest_shift = 0;  ///< mm, of the others: the error of the sampling there
};

/// Lets the cutter down on the smooth part at every point that is left of the sections, over
/// its s: on faces, borders, creases and corners, with whatever contact is the highest. A
/// crossing goes to where two contacts are equally high, also one that the sampling missed;
/// vertices that it has passed by are left out. Right to 1e-4 mm whatever the grid, and to
/// 1e-9 where N_z > 0.1 at the contact, but for contacts that differ by less than
/// `rest_gouge`, see smooth_drop.h. Between points the path goes straight, and errs by its
/// chords: c l^2 / 8 over a length l for a section of curvature c.
///
/// A point is kept as sampled below the envelope of its section, in a fold that a method
/// left; where the offset stands upright, at N_z = 0; and over edges and corners if the
/// offset has no BoundaryContact. On all threads; the result does not depend on their number.
/// Source: specification of the interference removal, section 6.
/// \param trimmed one a plane. \throws DomainError unless there are as many as sections.
RefinedPlanes refine_planes(const SectionSource& source,
                            std::span<const Trimmed> trimmed);

/// An estimate of the error in mm of what is left as sampled: how far refining would move a
/// point in z at most, of those that it could move.
double sampling_error(const SectionSource& source, std::span<const Trimmed> trimmed);

}  // namespace endmill
