// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "endmill/setup/detail/pole_points.h"

namespace endmill {

/// Two opposite sectors about a tool axis that contain given directions: what a machine
/// of family C,A reaches when C turns by `width`.
/// Source: [KangSuh, eq. (6)–(11), (13)].
struct SectorCandidate {
    double from;   ///< rad: azimuth at which the first sector begins
    double width;  ///< rad, within [0, 2 pi): the first sector is [from, from + width]
    double polar;  ///< rad: largest polar angle in the first sector
    double opposite_polar;  ///< rad: largest polar angle of the other directions

    /// rad^2, the paper's F.
    double area() const { return (polar + opposite_polar) * width; }
};

/// Directions about a pole, sorted by azimuth and listed twice: the second time 360
/// degrees on. Directions along the pole or opposite to it have every azimuth and are not
/// listed.
class DirectionFan {
public:
    /// O(n log n).
    explicit DirectionFan(const PolePoints& points);

    std::size_t size() const { return polars_.size() / 2; }  ///< directions listed

    /// Largest polar angle of all directions, listed or not, rad.
    double largest_polar() const { return largest_; }

    /// rad, ascending in i. \pre i < 2 size().
    double azimuth(std::size_t i) const { return azimuths_[i]; }
    /// rad. \pre i < 2 size().
    double polar(std::size_t i) const { return polars_[i]; }

    /// A candidate. A direction opposite to the pole counts in the sector with the larger
    /// polar angle.
    /// \param from, width of the first sector, rad. \param polar, other largest polar
    ///        angles of the listed directions in the first sector and opposite to it, rad.
    SectorCandidate candidate(double from, double width, double polar,
                              double other) const;

private:
    std::vector<double> azimuths_;
    std::vector<double> polars_;
    double opposite_ = 0;
    double largest_ = 0;
};

/// Largest polar angles of runs of a fan. Both ends of the run may only grow from one call
/// to the next, so that all calls together take O(n).
class RunMaximum {
public:
    /// \param fan must outlive this object.
    explicit RunMaximum(const DirectionFan& fan) : fan_{&fan} {}

    /// Largest polar angle of the directions begin ... end - 1; 0 if there is none.
    /// \pre neither argument is less than in the previous call; end <= 2 fan.size().
    double of(std::size_t begin, std::size_t end);

private:
    const DirectionFan* fan_;
    std::size_t next_ = 0;              // the first direction not yet read
    std::size_t head_ = 0;              // index into `falling_`
    std::vector<std::size_t> falling_;  // directions higher than all later ones
};

}  // namespace endmill
