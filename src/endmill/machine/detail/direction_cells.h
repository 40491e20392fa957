// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

/// \file
/// Unions of patches on the sphere, for their solid angle and border. Azimuths and
/// latitudes refer to one axis.

namespace endmill {

/// The directions between two meridians and two parallels.
struct DirectionPatch {
    double from;   ///< rad, azimuth
    double width;  ///< rad, from 0 to 2 pi, counter-clockwise
    double low;    ///< rad, latitude
    double high;   ///< rad
};

/// A piece of meridian (one azimuth) or parallel (one latitude), in rad.
struct DirectionEdge {
    double from_azimuth;
    double to_azimuth;
    double from_latitude;
    double to_latitude;
};

/// A union of patches.
///
/// All meridians and parallels of the patches divide the sphere into cells. A cell lies
/// completely inside or outside of each patch, so that overlaps count once, and the
/// border consists of the cell sides between inside and outside. Meridians or parallels
/// closer than 1e-12 rad are merged; thinner patches vanish.
class DirectionCells {
public:
    /// \param patches any number, in any position.
    explicit DirectionCells(std::span<const DirectionPatch> patches);

    /// Solid angle of the union in sr. Absolute error below 1e-13.
    double solid_angle() const;

    /// The border of the union. Collinear neighbouring sides are joined to one edge.
    std::vector<DirectionEdge> border() const;

private:
    std::size_t columns() const { return azimuths_.size(); }
    std::size_t rows() const { return latitudes_.size() - 1; }
    bool is_in(std::size_t column, std::size_t row) const
    {
        return is_in_[column * rows() + row] != 0;
    }
    double end_azimuth(std::size_t column) const;
    void add_meridians(std::vector<DirectionEdge>& edges) const;
    void add_parallels(std::vector<DirectionEdge>& edges) const;

    std::vector<double> azimuths_;   // begins of the columns, ascending, at least one
    std::vector<double> latitudes_;  // begins of the rows and the end, ascending
    std::vector<char> is_in_;        // 1 for cells of the union, column by column
};

}  // namespace endmill
