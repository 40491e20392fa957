// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/bend_bounds.h"

#include <algorithm>
#include <cmath>

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

// Bounds on one piece: the lengths of the control points of the second derivatives. With
// weights, the derivatives of r follow from those of w r and w by Leibniz' rule, where
// each term is replaced by its greatest size.
BendBounds bounds_of(const Nets& nets, bool is_rational)
{
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

// The coefficients on the four quarters of the unit interval along one parameter.
std::array<Nets, bounded_pieces> quarters(const Nets& nets, Parameter along)
{
    std::array<Nets, bounded_pieces> pieces;
    const auto cut = [&](const BernsteinNet& net, auto&& member) {
        const auto [low, high] = halves(net, along);
        const auto [first, second] = halves(low, along);
        const auto [third, fourth] = halves(high, along);
        member(pieces[0]) = first;
        member(pieces[1]) = second;
        member(pieces[2]) = third;
        member(pieces[3]) = fourth;
    };
    for (int c = 0; c < 3; ++c)
        cut(nets.r[c], [c](Nets& piece) -> BernsteinNet& { return piece.r[c]; });
    cut(nets.w, [](Nets& piece) -> BernsteinNet& { return piece.w; });
    return pieces;
}

}  // namespace

std::array<BendBounds, bounded_pieces * bounded_pieces> bend_bounds(
    const BezierPatch& patch)
{
    std::array<BendBounds, bounded_pieces * bounded_pieces> bounds;
    // Converts from the parameters of the piece to those of the patch.
    constexpr double unit = bounded_pieces * bounded_pieces;
    const auto columns = quarters(nets_of(patch), Parameter::U);
    for (int i = 0; i < bounded_pieces; ++i) {
        const auto column = quarters(columns[i], Parameter::V);
        for (int j = 0; j < bounded_pieces; ++j) {
            const BendBounds piece =
                bounds_of(from_first_corner(column[j]), patch.is_rational());
            bounds[j * bounded_pieces + i] = {unit * piece.uu, unit * piece.uv,
                                              unit * piece.vv};
        }
    }
    return bounds;
}

}  // namespace endmill
