// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "endmill/surface/bezier_patch.h"
#include "endmill/surface/surface_jet.h"

namespace endmill {

/// A polynomial over the unit square by its Bernstein coefficients, the row counting u
/// and the column v. The coefficients bound the polynomial, and those in the corners are
/// its values there: what branch and bound needs.
using BernsteinNet = Eigen::MatrixXd;

/// Coefficients of w(u, v) r(u, v) . direction, in mm for a unit `direction`; of a patch
/// without weights w = 1.
BernsteinNet height_net(const BezierPatch& patch, const Vec3& direction);

/// Coefficients of w(u, v); of a patch without weights all are 1.
BernsteinNet weight_net(const BezierPatch& patch);

/// Coefficients of w^3 (du x dv) . direction, in mm^2 for a unit `direction`: 2p by 2q of
/// a patch of degrees p and q without weights, where w = 1, else 3p by 3q.
/// Source: with H = w r, w^3 (du x dv) = w H_u x H_v - w_v H_u x H - w_u H x H_v.
BernsteinNet normal_net(const BezierPatch& patch, const Vec3& direction);

/// The polynomial p(u, v) divided by u, by 1 - u, by v or by 1 - v: that linear factor
/// which vanishes on the edge `edge` of `parameter` (0 or 1), where p is zero.
/// \pre the coefficients on that edge are zero.
BernsteinNet divided_by_edge(const BernsteinNet& net, Parameter parameter, int edge);

/// The polynomial on the two halves of the square, each again over a unit square.
std::pair<BernsteinNet, BernsteinNet> halves(const BernsteinNet& net, Parameter across);

/// A piece of the unit square, with the polynomial there.
struct BernsteinPiece {
    BernsteinNet net;
    SurfacePoint low;  ///< its corner with the least u and v
    double width_u;
    double width_v;
};

/// The halves of `piece` across its wider side.
std::pair<BernsteinPiece, BernsteinPiece> halves(const BernsteinPiece& piece);

}  // namespace endmill
