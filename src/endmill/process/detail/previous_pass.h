// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "endmill/process/ball_engagement.h"

namespace endmill {

/// The curve on the ball along which the lower half of the previous pass borders the
/// engaged region: the intersection of the unit ball with a unit cylinder along the feed.
///
/// A point of the cylinder is given by the angle phi about its axis from its lowest line:
/// y = sin(phi) - a across the feed, w = -b - cos(phi) normal to the feed. With nu = mu +
/// pi/2 - phi and sin(nu/2) = k sin(x), the distance of the point in front of the front
/// plane is tau = reach cos(x), which is analytic in x also where the curve meets the
/// front plane. The parameter of the curve is p = tan(x/2), from `first` to 1. Lengths
/// are in radii of the ball, in the frame of BallEngagement.
/// Source: derived in paper/notes/ball-engagement.md, section 1.
struct PreviousPassCurve {
    /// \pre `engagement` is sound. Without a previous pass the curve is empty (`first` =
    ///         1).
    explicit PreviousPassCurve(const BallEngagement& engagement);

    double pick_feed;  ///< R_p; 0 without a previous pass
    double cos_mu;     ///< cosine of the slope of the pick feed
    double sin_mu;     ///< sine of the slope of the pick feed
    double across;     ///< a, horizontal component of the pick feed, along Y
    double rise;       ///< b, component of the pick feed normal to the feed, upwards
    double amplitude;  ///< k
    double reach;      ///< largest distance of the curve in front of the front plane
    double first;      ///< p at the wall of the previous pass, where the curve begins
};

/// A point of a PreviousPassCurve, with derivatives by the angle x.
struct PassPoint {
    double sine;      ///< sin(phi)
    double cosine;    ///< cos(phi)
    double tau;       ///< distance in front of the front plane
    double tau_by_x;  ///< d tau / dx
    double phi_by_x;  ///< d phi / dx
};

/// The point of `curve` at p = tan(x/2).
/// \pre There is a previous pass with a pick feed below 2.
PassPoint pass_point(const PreviousPassCurve& curve, double p);

/// Parameter p of the point of `curve` with u = tan(phi/2). A point behind the front
/// plane yields the nearer end of the curve.
double pass_parameter(const PreviousPassCurve& curve, double u);

/// The condition base + turn cos(phi) + front tau > 0 on a point of a PreviousPassCurve.
/// All coordinates of a point have this form, so conditions such as "below the stock's
/// top" do.
struct PassCondition {
    double base;   ///< constant term
    double turn;   ///< factor of cos(phi)
    double front;  ///< factor of tau
};

/// Places where a condition changes its sign along a PreviousPassCurve.
struct SignChanges {
    std::array<double, 8> at;  ///< p, ascending; the first `count` entries are valid
    int count = 0;             ///< number of changes
    bool is_positive = false;  ///< whether the condition holds before the first change
};

/// The sign changes of `condition` between the beginning of `curve` and p = 1, accurate
/// to rounding. Two changes closer than about 1e-8 may be missed.
/// Source: derived in paper/notes/ball-engagement.md, section 2.
SignChanges sign_changes(const PreviousPassCurve& curve, const PassCondition& condition);

}  // namespace endmill
