// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "endmill/deviation/deviation.h"

namespace endmill {

/// A deviation seen along -z, sampled on squares over the xy plane.
struct DeviationRaster {
    /// The value of a square in which the part is not visible.
    static constexpr float nothing = std::numeric_limits<float>::infinity();

    Eigen::Vector2d low{0, 0};   ///< corner with the least x and y, in mm
    Eigen::Vector2d high{0, 0};  ///< corner of the part with the largest x and y, in mm
    double side = 1;             ///< side of a square, in mm
    int columns = 1;             ///< number of squares along x
    int rows = 1;                ///< number of squares along y
    /// Deviation in mm, row by row from the least y, or `nothing`.
    std::vector<float> left;

    /// The deviation of a square. \pre 0 <= column < columns, 0 <= row < rows.
    float at(int column, int row) const
    {
        return left[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                    static_cast<std::size_t>(column)];
    }
};

/// A deviation as a share of its limit: the tolerance for a gouge, else the scallop
/// limit.
double share_of_limit(double left, const DeviationLimits& limits);

/// The raster of a part. A square has the deviation of the cell with the largest share of
/// its limit, among all cells that reach half a square into it or have their centre in
/// it. If two shares are equal, the gouge counts.
/// \param squares number of squares along the longer side of the part's extent in x and
///         y.
/// \throws DomainError unless `squares` > 0, limits are positive, the deviation belongs
///         to `charts`, and all numbers are finite.
DeviationRaster deviation_raster(const PartCharts& charts, const Deviation& deviation,
                                 const DeviationLimits& limits, int squares);

}  // namespace endmill
