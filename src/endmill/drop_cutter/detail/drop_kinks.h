// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/drop_cutter/detail/smooth_drop.h"
#include "endmill/offset/drive_planes.h"

namespace endmill {

/// A drive plane, seen from above.
struct DriveLine {
    const DriveFrame& frame;
    double across;  ///< t in mm

    /// The cutter's x and y at s, in mm.
    Eigen::Vector2d axis(double s) const { return frame.point(s, across, 0).head<2>(); }
    /// How a height of this slope in x and y rises with s.
    double rise(const Eigen::Vector2d& slope) const
    {
        return slope.dot(frame.point(1, 0, 0).head<2>());
    }
};

/// The cutter at rest over a place of a drive plane.
struct DropRest {
    double s;             ///< mm
    PartContact contact;  ///< the highest one there
};

/// Where between two places the cutter touches twice, so that its height has a kink: the
/// contact of `low` does not go over into that of `high`, another one takes its place. Looked
/// for unless both become the same half way: places are to be close to each other, as
/// neighbouring samples are. Each is found by Newton's method on the heights over both
/// contacts, which follow the cutter over sheets, borders and corners, between bounds that
/// close in; if a third contact is higher there, on both sides of it.
/// \param finer of this drop and this thread alone.
/// \return those kinks, s rising, with one of their contacts; none if a contact goes over
///         smoothly.
std::vector<DropRest> kinks_between(const SmoothDrop& drop, const DriveLine& line,
                                    const DropRest& low, const DropRest& high,
                                    FinerPieces& finer);

}  // namespace endmill
