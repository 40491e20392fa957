// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "endmill/surface/surface.h"

namespace endmill {

/// The line v = constant of a surface, with the surface's partials along it: four times
/// cheaper to evaluate than the surface. For lines u = constant, transpose the surface.
class IsoLine {
public:
    /// \param v beyond the surface's range the polynomials of its border patches go on.
    IsoLine(const Surface& surface, double v);

    double v() const { return v_; }  ///< the constant parameter
    Interval range() const { return {breaks_.front(), breaks_.back()}; }  ///< of u

    /// Whether the line is one point, to 1e-12 of the surface's diagonal: a pole.
    bool is_point() const { return is_point_; }

    /// Point of the line at u.
    Vec3 point(double u) const;

    /// The surface's jet at (u, v), one-sided at a border, see Surface::patch_number.
    SurfaceJet jet(double u) const;

    /// A bound on |d2r/du2| over [from, to] within the patches, in mm per unit of u
    /// squared. Attained where the surface is bicubic without weights, else from the
    /// hulls of control points.
    double bend_bound(double from, double to) const;

    /// A bound in mm on the distance of the line over [from, to] from its chord: w^2 / 8
    /// times the bend bound, w = to - from, and w / 4 times each jump of dr/du and the
    /// whole of each gap at the borders between.
    double chord_error_bound(double from, double to) const;

    /// Smallest u > `from` at which the line has gone `distance` beyond its point at
    /// `from`, measured along `direction`: (r(u) - r(from)) . direction = distance.
    /// Source: [KimChoi, eq. (3)].
    ///
    /// \param distance  in mm, positive.
    /// \param direction unit.
    /// \return u, whose residual is a few roundings of the surface's size in mm;
    ///         nothing if the line never gets there.
    std::optional<double> first_reach(double from, const Vec3& direction,
                                      double distance) const;

private:
    // A patch's line and its derivatives across, as Bezier curves in u by their
    // homogeneous control points.
    struct Piece {
        bool is_rational;
        // A row a control point; columns of the curve, of its first, of its second
        // derivative across, in that order: x, y, z and, if rational, w of each.
        Eigen::MatrixXd nets;

        bool is_cubic() const { return nets.rows() == 4 && !is_rational; }
    };

    // What first_reach looks for.
    struct Reach {
        Vec3 start;
        Vec3 direction;
        double distance;
    };

    int piece_number(double u) const;
    static SurfaceJet jet_of(const Piece& piece, double t, double slope);
    static std::optional<double> first_reach_on(const Piece& piece, double from,
                                                const Reach& reach);
    double bend_bound_of(int piece, double low, double high) const;

    double v_;
    bool is_point_;
    std::vector<double> breaks_;
    std::vector<Piece> pieces_;
};

}  // namespace endmill
