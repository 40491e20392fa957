// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/bernstein_net.h"

#include <Eigen/Geometry>

namespace endmill {
namespace {

// The binomial coefficients C(degree, k) for k from 0 to degree.
Eigen::VectorXd binomials(Eigen::Index degree)
{
    Eigen::VectorXd binomial = Eigen::VectorXd::Ones(degree + 1);
    for (Eigen::Index k = 1; k <= degree; ++k)
        binomial[k] = binomial[k - 1] * double(degree - k + 1) / double(k);
    return binomial;
}

// The coefficients multiplied by C(p, i) C(q, j). In this form the product of two
// polynomials is a convolution.
BernsteinNet scaled(const BernsteinNet& net)
{
    return binomials(net.rows() - 1).asDiagonal() * net *
           binomials(net.cols() - 1).asDiagonal();
}

BernsteinNet unscaled(const BernsteinNet& net)
{
    return binomials(net.rows() - 1).cwiseInverse().asDiagonal() * net *
           binomials(net.cols() - 1).cwiseInverse().asDiagonal();
}

// The product of two polynomials in scaled form.
BernsteinNet scaled_product(const BernsteinNet& one, const BernsteinNet& other)
{
    BernsteinNet product =
        BernsteinNet::Zero(one.rows() + other.rows() - 1, one.cols() + other.cols() - 1);
    for (Eigen::Index j = 0; j < one.cols(); ++j)
        for (Eigen::Index i = 0; i < one.rows(); ++i)
            product.block(i, j, other.rows(), other.cols()) += one(i, j) * other;
    return product;
}

// A polynomial and its partial derivatives, in scaled form.
struct Derived {
    explicit Derived(const BernsteinNet& net)
        : value{scaled(net)},
          du{scaled(double(net.rows() - 1) *
                    (net.bottomRows(net.rows() - 1) - net.topRows(net.rows() - 1)))},
          dv{scaled(double(net.cols() - 1) *
                    (net.rightCols(net.cols() - 1) - net.leftCols(net.cols() - 1)))}
    {
    }

    BernsteinNet value;
    BernsteinNet du;
    BernsteinNet dv;
};

}  // namespace

BernsteinNet height_net(const BezierPatch& patch, const Vec3& direction)
{
    BernsteinNet net{patch.degree(Parameter::U) + 1, patch.degree(Parameter::V) + 1};
    for (int j = 0; j < net.cols(); ++j)
        for (int i = 0; i < net.rows(); ++i)
            net(i, j) = patch.homogeneous_point(i, j).head<3>().dot(direction);
    return net;
}

BernsteinNet weight_net(const BezierPatch& patch)
{
    BernsteinNet net{patch.degree(Parameter::U) + 1, patch.degree(Parameter::V) + 1};
    for (int j = 0; j < net.cols(); ++j)
        for (int i = 0; i < net.rows(); ++i)
            net(i, j) = patch.homogeneous_point(i, j)[3];
    return net;
}

BernsteinNet normal_net(const BezierPatch& patch, const Vec3& direction)
{
    // With coordinates x and y across the direction n, (a x b) . n = a_x b_y - a_y b_x.
    // They are measured from a corner, so that the result does not depend on the place of
    // the origin.
    const Vec3 across = direction.unitOrthogonal();
    const Vec3 corner = patch.control_point(0, 0);
    const BernsteinNet weights = weight_net(patch);
    const auto coordinate = [&](const Vec3& along) {
        return Derived{height_net(patch, along) - corner.dot(along) * weights};
    };
    const Derived x = coordinate(across);
    const Derived y = coordinate(direction.cross(across));
    const BernsteinNet du_dv = scaled_product(x.du, y.dv) - scaled_product(y.du, x.dv);
    if (!patch.is_rational())
        return unscaled(du_dv);
    const Derived w{weights};
    const BernsteinNet du_r =
        scaled_product(x.du, y.value) - scaled_product(y.du, x.value);
    const BernsteinNet r_dv =
        scaled_product(x.value, y.dv) - scaled_product(y.value, x.dv);
    return unscaled(scaled_product(w.value, du_dv) - scaled_product(w.dv, du_r) -
                    scaled_product(w.du, r_dv));
}

BernsteinNet divided_by_edge(const BernsteinNet& net, Parameter parameter, int edge)
{
    if (parameter == Parameter::V)
        return divided_by_edge(net.transpose(), Parameter::U, edge).transpose();
    // C(n,k) t^k = t n/k C(n-1,k-1) t^(k-1), and the same from the other end.
    const auto degree = net.rows() - 1;
    const BernsteinNet rest = edge == 0 ? net.bottomRows(degree) : net.topRows(degree);
    BernsteinNet quotient = rest;
    for (Eigen::Index k = 0; k < degree; ++k) {
        const auto power = edge == 0 ? k + 1 : degree - k;
        quotient.row(k) *= static_cast<double>(degree) / static_cast<double>(power);
    }
    return quotient;
}

std::pair<BernsteinNet, BernsteinNet> halves(const BernsteinNet& net, Parameter across)
{
    if (across == Parameter::V) {
        auto [low, high] = halves(BernsteinNet{net.transpose()}, Parameter::U);
        return {low.transpose(), high.transpose()};
    }
    // De Casteljau's algorithm at 1/2: the left edge of the triangle is the lower half,
    // the right edge the upper half.
    BernsteinNet low = net;
    BernsteinNet high = net;
    const auto degree = net.rows() - 1;
    for (Eigen::Index level = 1; level <= degree; ++level) {
        for (Eigen::Index row = 0; row <= degree - level; ++row)
            high.row(row) = (high.row(row) + high.row(row + 1)) / 2;
        low.row(level) = high.row(0);
    }
    return {low, high};
}

std::pair<BernsteinPiece, BernsteinPiece> halves(const BernsteinPiece& piece)
{
    const auto& [net, low, width_u, width_v] = piece;
    if (width_u >= width_v) {
        auto [first, second] = halves(net, Parameter::U);
        const double half = width_u / 2;
        return {{std::move(first), low, half, width_v},
                {std::move(second), {low.u + half, low.v}, half, width_v}};
    }
    auto [first, second] = halves(net, Parameter::V);
    const double half = width_v / 2;
    return {{std::move(first), low, width_u, half},
            {std::move(second), {low.u, low.v + half}, width_u, half}};
}

}  // namespace endmill
