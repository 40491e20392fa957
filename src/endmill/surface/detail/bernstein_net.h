// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "endmill/surface/bezier_patch.h"
#include "endmill/surface/surface_jet.h"

namespace endmill {

/// A polynomial over the unit square, given by its Bernstein coefficients; rows count u
/// and columns v. All coefficients together bound the polynomial, and those at the
/// corners are its values there, as branch and bound needs it.
using BernsteinNet = Eigen::MatrixXd;

/// The coefficients of w(u, v) r(u, v) . direction, in mm for a unit `direction`; w = 1
/// for a patch without weights.
BernsteinNet height_net(const BezierPatch& patch, const Vec3& direction);

/// The coefficients of w(u, v); all are 1 for a patch without weights.
BernsteinNet weight_net(const BezierPatch& patch);

/// The coefficients of w^3 (du x dv) . direction, in mm^2 for a unit `direction`. For a
/// patch of degrees p and q the degrees are 2p and 2q without weights, where w = 1, and
/// 3p and 3q with weights.
/// With H = w r, w^3 (du x dv) = w H_u x H_v - w_v H_u x H - w_u H x H_v.
BernsteinNet normal_net(const BezierPatch& patch, const Vec3& direction);

/// The polynomial divided by the linear factor that vanishes on an edge: u or 1 - u, v or
/// 1 - v.
/// \param net zero on that edge.
/// \param parameter constant on the edge.
/// \param edge its value there, 0 or 1.
/// \pre the coefficients on the edge are zero.
BernsteinNet divided_by_edge(const BernsteinNet& net, Parameter parameter, int edge);

/// The polynomial on the two halves of the square, each again over the unit square.
std::pair<BernsteinNet, BernsteinNet> halves(const BernsteinNet& net, Parameter across);

/// A piece of the unit square with the polynomial on it.
struct BernsteinPiece {
    BernsteinNet net;  ///< the polynomial over the piece
    SurfacePoint low;  ///< corner with the least u and v
    double width_u;    ///< in the parameters of the unit square
    double width_v;    ///< in the parameters of the unit square
};

/// The two halves of a piece, divided across its wider side.
std::pair<BernsteinPiece, BernsteinPiece> halves(const BernsteinPiece& piece);

}  // namespace endmill
