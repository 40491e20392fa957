// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/bernstein_net.h"

#include <array>

#include <Eigen/Geometry>

namespace endmill {
namespace {

constexpr std::array<double, 3> binomial_2{1, 2, 1};
constexpr std::array<double, 4> binomial_3{1, 3, 3, 1};
constexpr std::array<double, 6> binomial_5{1, 5, 10, 10, 5, 1};

}  // namespace

BernsteinNet height_net(const BezierPatch& patch, const Vec3& direction)
{
    BernsteinNet net{4, 4};
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            net(i, j) = patch.control_point(i, j).dot(direction);
    return net;
}

BernsteinNet normal_net(const BezierPatch& patch, const Vec3& direction)
{
    BernsteinNet net = BernsteinNet::Zero(6, 6);
    const auto point = [&](int i, int j) { return patch.control_point(i, j); };
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 4; ++j) {
            const Vec3 du = 3 * (point(i + 1, j) - point(i, j));
            const Vec3 across = direction.cross(du);  // (du x dv).n = (n x du).dv
            for (int k = 0; k < 4; ++k)
                for (int l = 0; l < 3; ++l) {
                    const Vec3 dv = 3 * (point(k, l + 1) - point(k, l));
                    const double weight_u =
                        binomial_2[i] * binomial_3[k] / binomial_5[i + k];
                    const double weight_v =
                        binomial_3[j] * binomial_2[l] / binomial_5[j + l];
                    net(i + k, j + l) += weight_u * weight_v * across.dot(dv);
                }
        }
    return net;
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
    // De Casteljau's pyramid at 1/2: its left edge is the lower half, its right the
    // upper.
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
