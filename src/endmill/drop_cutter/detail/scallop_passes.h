// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/drop_cutter/drop_cutter.h"
#include "endmill/offset/drive_planes.h"
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

/// The scallop height that passes must keep, and where this is examined.
struct PassLimit {
    double height;          ///< mm along the normal of the part, > 0
    double level_interval;  ///< mm, > 0; pitch that leaves this height on level ground
    double allowance = 0;   ///< mm by which the given cutter is larger than the real one
    /// Number of samples over the extent along the feed, at least 2; there are more if their
    /// distance would exceed a quarter of the level interval, up to 20 times as many.
    int samples = 200;
    /// Whether passes are added beyond the extent across the feed, as far as the mesh slopes
    /// there.
    bool beyond_borders = false;
};

/// The passes that mesh_passes adds to `planes`, in the order of the gaps between planes. They
/// do not depend on the number of threads.
/// \param along the extent of the mesh in s.
/// \param limit the scallop height and the samples.
/// \throws DomainError if a number of the limit is outside its domain, or if the planes are
///     not ascending.
/// \throws LimitError if over a million passes would be needed.
std::vector<AddedPass> added_passes(const DropCutter& drop_cutter,
                                    const DrivePlanes& planes, const Interval& along,
                                    const PassLimit& limit);

}  // namespace endmill
