// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/surface/surface.h"

namespace endmill {

/// Bounds on the second derivatives of the surface r and of its unit normal N over a
/// rectangle of parameters. Those of r are in mm per squared unit of the parameter, those
/// of N in 1 per squared unit.
struct OffsetBends {
    SurfacePoint low;   ///< lower corner of the rectangle
    SurfacePoint high;  ///< upper corner, in the same patch as `low`
    double r_uu;        ///< of |r_uu|
    double r_vv;        ///< of |r_vv|
    double n_uu;        ///< of |N_uu|
    double n_vv;        ///< of |N_vv|

    /// Upper bound in mm of the distance between the offset r + h N over a cell and the
    /// bilinear patch through the offset's corners: (a^2 |uu| + b^2 |vv|) / 8.
    /// \param width_u a, width in u of a cell inside the rectangle.
    /// \param width_v b, width in v.
    /// \param h       height of the offset in mm, not negative; for offsets to the other
    ///                side pass the absolute value.
    double deviation(double width_u, double width_v, double h) const
    {
        return (width_u * width_u * (r_uu + h * n_uu) +
                width_v * width_v * (r_vv + h * n_vv)) /
               8;
    }
};

/// Bounds on the second derivatives of a surface and of its normal, over all of the
/// surface. They come from convex hulls of control points, those of du x dv included, and
/// are never too small except for rounding. They are infinite in a patch whose normal the
/// hulls cannot separate from zero. On a collapsed edge they are finite, because the
/// factor by which du x dv vanishes there is divided out. An immutable value.
class OffsetBounds {
public:
    /// \param surface must outlive this.
    explicit OffsetBounds(const Surface& surface);

    /// The rectangle that contains (u, v); on a border between two, the upper one.
    const OffsetBends& at(double u, double v) const;

    /// The rectangles that meet the inside of the strip `v`, patch by patch.
    std::vector<OffsetBends> across(Interval v) const;

private:
    // The equal rectangles of a patch: count by count of them from number `first` on.
    struct PatchGrid {
        std::size_t first;
        int count;
    };

    const Surface* surface_;
    std::vector<PatchGrid> patches_;
    std::vector<OffsetBends> rectangles_;
};

}  // namespace endmill
