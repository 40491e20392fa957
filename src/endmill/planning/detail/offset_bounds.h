// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/surface/surface.h"

namespace endmill {

/// Bounds on the second derivatives of r and of its unit normal N over a rectangle of the
/// parameters, in mm per unit of a parameter squared, and in units of it squared.
struct OffsetBends {
    SurfacePoint low;   ///< corners of the rectangle
    SurfacePoint high;  ///< in one patch with `low`
    double r_uu;
    double r_vv;
    double n_uu;
    double n_vv;

    /// A bound in mm on the distance of the offset r + h N, over a cell of these widths
    /// in the rectangle, from the bilinear patch through the offset's corners:
    /// (a^2 |uu| + b^2 |vv|) / 8.
    double stray(double width_u, double width_v, double h) const
    {
        return (width_u * width_u * (r_uu + h * n_uu) +
                width_v * width_v * (r_vv + h * n_vv)) /
               8;
    }
};

/// Bounds on the bends of a surface's offsets, everywhere. From hulls of control points,
/// those of du x dv among them, so never too small but for rounding; infinite where a
/// patch has no normal that its pieces' hulls could bound away from zero. A collapsed
/// edge, where du x dv vanishes with one factor, is no such place. An immutable value.
class OffsetBounds {
public:
    /// Of all patches of `surface`, which is not needed any more then.
    explicit OffsetBounds(const Surface& surface);

    /// The rectangle that holds (u, v), at a border the upper one.
    const OffsetBends& at(double u, double v) const;

    /// The rectangles that the strip of that width in v crosses, patch by patch.
    std::vector<OffsetBends> across(Interval v) const;

private:
    // The equal rectangles of a patch, `count` each way, from `first` on.
    struct PatchGrid {
        std::size_t first;
        int count;
    };

    const Surface* surface_;  // outlives this
    std::vector<PatchGrid> patches_;
    std::vector<OffsetBends> rectangles_;
};

}  // namespace endmill
