// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/drop_cutter/mesh_sections.h"
#include "endmill/surface/surface_jet.h"

namespace endmill {

/// A drive plane that is added between others, over some stretches of s.
struct AddedPass {
    double position;                  ///< t of the plane, mm
    std::vector<Interval> stretches;  ///< of s in mm, ascending, at least one
};

/// Distance in mm from the border of the mesh up to which a contact is on the border. It is far
/// above the accuracy of a contact.
inline constexpr double border_rounding = 1e-6;

/// Where passes are examined.
struct PassSampling {
    /// Number of samples over the extent along the feed, at least 2; there are more if their
    /// distance would exceed half the level interval.
    int samples;
    /// Whether passes are added beyond the extent across the feed, see MeshSectionOptions.
    bool beyond_borders = false;
};

/// The passes that mesh_passes adds to `planes`, in the order of the gaps between planes. They
/// do not depend on the number of threads.
/// \param along the extent of the mesh in s.
/// \param sampling the samples.
/// \throws DomainError if a number of the limit is outside its domain, or if the planes are
///     not ascending.
/// \throws LimitError if over a million passes would be needed.
std::vector<AddedPass> added_passes(const DropCutter& drop_cutter,
                                    const DrivePlanes& planes, const Interval& along,
                                    const ScallopLimit& limit,
                                    const PassSampling& sampling);

}  // namespace endmill
