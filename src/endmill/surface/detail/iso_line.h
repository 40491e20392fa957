// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "endmill/surface/surface.h"

namespace endmill {

/// The line v = constant of a surface, with the partial derivatives of the surface along
/// it. It is evaluated four times faster than the surface. For lines u = constant,
/// transpose the surface.
class IsoLine {
public:
    /// \param surface not needed afterwards.
    /// \param v beyond the surface's range the polynomials of the border patches are
    ///         continued.
    IsoLine(const Surface& surface, double v);

    double v() const { return v_; }  ///< the constant parameter v
    Interval range() const { return {breaks_.front(), breaks_.back()}; }  ///< range of u

    /// Whether the line is a single point, a pole, up to `same_point_share` of the
    /// surface's diagonal.
    bool is_point() const { return is_point_; }

    /// The point of the line at u.
    Vec3 point(double u) const;

    /// The jet of the surface at (u, v). It is one-sided at a border; see
    /// Surface::patch_number.
    SurfaceJet jet(double u) const;

    /// Upper bound of |d2r/du2| over [from, to] within the patches, in mm per squared
    /// unit of u. For a bicubic surface without weights it is attained; otherwise it
    /// comes from convex hulls of control points.
    double bend_bound(double from, double to) const;

    /// Upper bound in mm of the distance between the line over [from, to] and its chord:
    /// w^2 / 8 times the bend bound, where w = to - from, plus w / 4 times each jump of
    /// dr/du and the length of each gap at the borders between.
    double chord_error_bound(double from, double to) const;

    /// The smallest u > `from` at which the line is `distance` beyond its point at
    /// `from`, measured along `direction`: (r(u) - r(from)) . direction = distance.
    /// Source: [KimChoi, eq. (3)].
    ///
    /// \param from start of the search.
    /// \param direction unit.
    /// \param distance in mm, positive.
    /// \return u, with a residual of a few roundings of the surface's size; nothing if
    ///         the line does not reach that distance.
    std::optional<double> first_reach(double from, const Vec3& direction,
                                      double distance) const;

private:
    // The line on one patch and its derivatives across, as Bezier curves in u with
    // homogeneous control points.
    struct Piece {
        bool is_rational;
        // One row for each control point. The columns belong to the curve, to its first
        // and to its second derivative across; for each they are x, y, z and, if
        // rational, w.
        Eigen::MatrixXd nets;

        bool is_cubic() const { return nets.rows() == 4 && !is_rational; }
    };

    // The query of first_reach.
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
