// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace endmill {

/// A range of azimuths about the cutter's axis.
struct AzimuthInterval {
    double from;  ///< rad, from the direction of the feed over the xy plane,
    double to;    ///< counter-clockwise seen from above; -pi <= from < to <= pi

    /// Whether both are the same range.
    friend bool operator==(const AzimuthInterval&, const AzimuthInterval&) = default;
};

/// A narrow ring of the cutter's surface and the part of it that is in the material.
struct EngagedRing {
    double latitude;  ///< rad, of its normal from straight down: 0 at the bottom, pi/2
                      ///< on the cylinder
    double radius;    ///< mm, distance from the axis
    double above;     ///< mm, from the tip
    double width;     ///< mm, along the cutter's profile
    std::vector<AzimuthInterval> engaged;  ///< rising, apart from each other
};

/// Which region of a cutter is in the material, from the tip upwards. A plain value that
/// says nothing of how it was found.
struct Engagement {
    std::vector<EngagedRing> rings;  ///< those of which some part is engaged
};

/// Area of the engaged region in mm^2, each ring taken for a strip of its width.
inline double engaged_area(const Engagement& engagement)
{
    double area = 0;
    for (const EngagedRing& ring : engagement.rings)
        for (const AzimuthInterval& interval : ring.engaged)
            area += ring.radius * (interval.to - interval.from) * ring.width;
    return area;
}

}  // namespace endmill
