// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "endmill/deviation/deviation.h"

namespace endmill {

/// A deviation seen along -z, on squares over the xy plane.
struct DeviationRaster {
    /// What a square has where the part does not show.
    static constexpr float nothing = std::numeric_limits<float>::infinity();

    Eigen::Vector2d low{0, 0};  ///< corner with the least x and y, mm
    double side = 1;            ///< of a square, mm
    int columns = 1;            ///< along x
    int rows = 1;               ///< along y
    std::vector<float> left;    ///< mm, row by row from the least y; or `nothing`

    /// \pre 0 <= column < columns, 0 <= row < rows.
    float at(int column, int row) const
    {
        return left[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                    static_cast<std::size_t>(column)];
    }
};

/// Deviation in shares of its limit: of the tolerance where too much is gone, else of the
/// scallop limit.
double share_of_limit(double left, const DeviationLimits& limits);

/// The raster of a part, `squares` along the longer side of what it covers of the xy
/// plane. A square shows, of all cells that reach half a square into it or have their
/// middle in it, the one with the largest share of its limit; of two that are equal the
/// gouge.
/// \throws DomainError unless `squares` > 0, limits are positive, `charts` are those that
///         were measured, and all numbers are finite.
DeviationRaster deviation_raster(const PartCharts& charts, const Deviation& deviation,
                                 const DeviationLimits& limits, int squares);

}  // namespace endmill
