// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/drop_cutter/detail/smooth_drop.h"
#include "endmill/offset/drive_planes.h"

namespace endmill {

/// A drive plane in plan.
struct DriveLine {
    /// The direction of the plane.
    const DriveFrame& frame;
    double across;  ///< t in mm

    /// x and y of the cutter's axis at s, in mm.
    Eigen::Vector2d axis(double s) const { return frame.point(s, across, 0).head<2>(); }
    /// The derivative by s of a height with the given slope in x and y.
    double rise(const Eigen::Vector2d& slope) const
    {
        return slope.dot(frame.point(1, 0, 0).head<2>());
    }
};

/// The cutter at rest over a position of a drive plane.
struct DropRest {
    double s;             ///< mm
    PartContact contact;  ///< the highest contact there
};

/// The positions between two given ones at which the cutter touches the part twice, so
/// that its height has a kink: one contact is replaced by another as the highest. The
/// search assumes that there is no kink if both contacts become the same halfway, so that
/// the positions should be as near to each other as neighbouring samples are. A kink is
/// found by Newton's method on the heights of both contacts, which are followed over
/// surfaces, borders and corners, within a bracket. If a third contact is higher there,
/// the search continues on both sides of it.
/// \param drop the part and the cutter.
/// \param line the drive plane.
/// \param low the cutter at rest at the smaller s.
/// \param high the cutter at rest at the larger s.
/// \param finer belongs to `drop` and to this thread alone.
/// \return the kinks, ordered by s, each with one of its two contacts.
std::vector<DropRest> kinks_between(const SmoothDrop& drop, const DriveLine& line,
                                    const DropRest& low, const DropRest& high,
                                    FinerPieces& finer);

}  // namespace endmill
