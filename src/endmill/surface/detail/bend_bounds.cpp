// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/bend_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

#include "endmill/surface/detail/bernstein_net.h"

namespace endmill {
namespace {

// Bernstein coefficients of the coordinates of w r, and of w.
struct Nets {
    std::array<BernsteinNet, 3> r;
    BernsteinNet w;
};

// Coefficients of the derivative in u.
BernsteinNet du(const BernsteinNet& net)
{
    const auto degree = net.rows() - 1;
    if (degree == 0)
        return BernsteinNet::Zero(1, net.cols());
    return double(degree) * (net.bottomRows(degree) - net.topRows(degree));
}

// Coefficients of the derivative in v.
BernsteinNet dv(const BernsteinNet& net)
{
    return du(net.transpose()).transpose();
}

double greatest(const BernsteinNet& net)
{
    return net.cwiseAbs().maxCoeff();
}

// The greatest length of a control point of a derivative of r.
template <class Derive>
double longest(const Nets& nets, const Derive& derive)
{
    const BernsteinNet x = derive(nets.r[0]);
    const BernsteinNet y = derive(nets.r[1]);
    const BernsteinNet z = derive(nets.r[2]);
    return std::sqrt((x.cwiseAbs2() + y.cwiseAbs2() + z.cwiseAbs2()).maxCoeff());
}

// The coefficients relative to the first corner, so that the bounds do not depend on the
// place of the origin.
Nets from_first_corner(Nets nets)
{
    for (BernsteinNet& net : nets.r) {
        const double corner = net(0, 0) / nets.w(0, 0);
        net -= corner * nets.w;
    }
    return nets;
}

// Coefficients of u times the polynomial.
BernsteinNet times_u(const BernsteinNet& net)
{
    const auto degree = net.rows();
    BernsteinNet product = BernsteinNet::Zero(degree + 1, net.cols());
    for (Eigen::Index k = 1; k <= degree; ++k)
        product.row(k) = double(k) / double(degree) * net.row(k - 1);
    return product;
}

// Coefficients of the polynomial with a degree in u that is higher by one.
BernsteinNet elevated_in_u(const BernsteinNet& net)
{
    const auto degree = net.rows();
    BernsteinNet elevated = times_u(net);
    for (Eigen::Index k = 0; k < degree; ++k)
        elevated.row(k) += double(degree - k) / double(degree) * net.row(k);
    return elevated;
}

BernsteinNet times_v(const BernsteinNet& net)
{
    return times_u(net.transpose()).transpose();
}

BernsteinNet elevated_in_v(const BernsteinNet& net)
{
    return elevated_in_u(net.transpose()).transpose();
}

// The coefficients of w (r - l) in place of those of w r, where the function l of u and v is
// linear and near r. So r - l has the second derivatives of r, but on a small piece it and
// its first derivatives are small, and so are the terms of Leibniz' rule other than r's own.
Nets less_linear(Nets nets)
{
    const BernsteinNet w = elevated_in_u(elevated_in_v(nets.w));
    const BernsteinNet w_u = times_u(elevated_in_v(nets.w));
    const BernsteinNet w_v = times_v(elevated_in_u(nets.w));
    const auto last_u = nets.w.rows() - 1;
    const auto last_v = nets.w.cols() - 1;
    for (BernsteinNet& net : nets.r) {
        const auto corner = [&](Eigen::Index i, Eigen::Index j) {
            return net(i, j) / nets.w(i, j);
        };
        const double a = corner(0, 0);
        const double b = corner(last_u, 0);
        const double c = corner(last_u, last_v);
        const double d = corner(0, last_v);
        const double along_u = ((b - a) + (c - d)) / 2;
        const double along_v = ((d - a) + (c - b)) / 2;
        const double first = (a + b + c + d) / 4 - (along_u + along_v) / 2;
        net =
            elevated_in_u(elevated_in_v(net)) - first * w - along_u * w_u - along_v * w_v;
    }
    return nets;
}

// Bounds on one piece: the lengths of the control points of the second derivatives. With
// weights, the derivatives of r follow from those of w r and w by Leibniz' rule, where
// each term is replaced by its greatest size.
BendBounds bounds_of(const Nets& piece, bool is_rational)
{
    const Nets nets = is_rational ? less_linear(piece) : from_first_corner(piece);
    const auto duu = [](const BernsteinNet& net) { return du(du(net)); };
    const auto duv = [](const BernsteinNet& net) { return du(dv(net)); };
    const auto dvv = [](const BernsteinNet& net) { return dv(dv(net)); };
    const BendBounds h{longest(nets, duu), longest(nets, duv), longest(nets, dvv)};
    if (!is_rational)
        return h;
    // Leibniz' rule for w r, with the greatest size of each term.
    const double w = nets.w.minCoeff();
    const double w_u = greatest(du(nets.w));
    const double w_v = greatest(dv(nets.w));
    const double r = longest(nets, [](const BernsteinNet& net) { return net; }) / w;
    const double r_u = (longest(nets, du) + w_u * r) / w;
    const double r_v = (longest(nets, dv) + w_v * r) / w;
    return {(h.uu + 2 * w_u * r_u + greatest(duu(nets.w)) * r) / w,
            (h.uv + w_u * r_v + w_v * r_u + greatest(duv(nets.w)) * r) / w,
            (h.vv + 2 * w_v * r_v + greatest(dvv(nets.w)) * r) / w};
}

Nets nets_of(const BezierPatch& patch)
{
    Nets nets{{}, weight_net(patch)};
    for (int c = 0; c < 3; ++c)
        nets.r[c] = height_net(patch, Vec3::Unit(c));
    return nets;
}

std::pair<Nets, Nets> halves_of(const Nets& nets, Parameter across)
{
    std::pair<Nets, Nets> pieces;
    for (std::size_t c = 0; c < 3; ++c)
        std::tie(pieces.first.r[c], pieces.second.r[c]) = halves(nets.r[c], across);
    std::tie(pieces.first.w, pieces.second.w) = halves(nets.w, across);
    return pieces;
}

// The coefficients on the pieces that arise when the square is halved `times` times.
std::vector<Nets> divided(const Nets& nets, Parameter across, int times)
{
    std::vector<Nets> pieces{nets};
    for (int k = 0; k < times; ++k) {
        std::vector<Nets> finer;
        finer.reserve(2 * pieces.size());
        for (const Nets& piece : pieces) {
            auto [low, high] = halves_of(piece, across);
            finer.push_back(std::move(low));
            finer.push_back(std::move(high));
        }
        pieces = std::move(finer);
    }
    return pieces;
}

}  // namespace

std::vector<BendBounds> bend_bounds(const BezierPatch& patch, const Halvings& halvings)
{
    const std::vector<Nets> columns = divided(nets_of(patch), Parameter::U, halvings.u);
    std::vector<BendBounds> bounds(columns.size() << halvings.v);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const std::vector<Nets> column = divided(columns[i], Parameter::V, halvings.v);
        for (std::size_t j = 0; j < column.size(); ++j) {
            const BendBounds piece = bounds_of(column[j], patch.is_rational());
            // Converts from the parameters of the piece to those of the patch.
            bounds[j * columns.size() + i] = {
                std::ldexp(piece.uu, 2 * halvings.u),
                std::ldexp(piece.uv, halvings.u + halvings.v),
                std::ldexp(piece.vv, 2 * halvings.v)};
        }
    }
    return bounds;
}

}  // namespace endmill
