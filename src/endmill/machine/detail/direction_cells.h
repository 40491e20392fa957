// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace endmill {

/// All directions between two meridians and two parallels of one axis.
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

/// The union of patches, cut into cells by all their meridians and parallels. Cuts closer than
/// 1e-12 are one: what is thinner is not there.
class DirectionCells {
public:
    explicit DirectionCells(std::span<const DirectionPatch> patches);

    /// Of the union, in sr. Absolute error below 1e-13.
    double solid_angle() const;

    /// The border of the union in pieces as long as they go straight.
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

    std::vector<double> azimuths_;   // where columns begin, rising, at least one
    std::vector<double> latitudes_;  // where rows begin and end, rising
    std::vector<char> is_in_;
};

}  // namespace endmill
