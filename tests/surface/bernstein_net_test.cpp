// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/bernstein_net.h"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "test_surfaces.h"

namespace endmill {
namespace {

BezierPatch random_patch(unsigned seed)
{
    return BezierPatch{test::random_net(seed, {1, 1}, 8)};
}

// The Bernstein polynomials of `degree` at t in one row, by the binomial formula.
Eigen::RowVectorXd bernstein(Eigen::Index degree, double t)
{
    Eigen::RowVectorXd basis{degree + 1};
    double binomial = 1;
    for (Eigen::Index i = 0; i <= degree; ++i) {
        basis[i] =
            binomial * std::pow(t, double(i)) * std::pow(1 - t, double(degree - i));
        binomial = binomial * double(degree - i) / double(i + 1);
    }
    return basis;
}

double value(const BernsteinNet& net, double u, double v)
{
    return bernstein(net.rows() - 1, u) * net * bernstein(net.cols() - 1, v).transpose();
}

const Vec3 direction = Vec3{1, -2, 3}.normalized();

TEST(BernsteinNet, HeightNetIsThePointAlongTheDirection)
{
    const BezierPatch patch = random_patch(1);
    const BernsteinNet net = height_net(patch, direction);
    for (double u = 0; u <= 1; u += 0.125)
        for (double v = 0; v <= 1; v += 0.125)
            EXPECT_NEAR(value(net, u, v), patch.jet(u, v).point.dot(direction), 1e-13);
}

TEST(BernsteinNet, NormalNetIsTheCrossProductOfThePartials)
{
    for (unsigned seed = 0; seed < 10; ++seed) {
        const BezierPatch patch = random_patch(seed);
        const BernsteinNet net = normal_net(patch, direction);
        ASSERT_EQ(net.rows(), 6);
        ASSERT_EQ(net.cols(), 6);
        for (double u = 0; u <= 1; u += 0.25)
            for (double v = 0; v <= 1; v += 0.25) {
                const SurfaceJet jet = patch.jet(u, v);
                EXPECT_NEAR(value(net, u, v), jet.du.cross(jet.dv).dot(direction), 1e-10);
            }
    }
}

TEST(BernsteinNet, CoefficientsBoundThePolynomialAndCornersAttainIt)
{
    const BezierPatch patch = random_patch(2);
    const BernsteinNet net = normal_net(patch, direction);
    for (double u = 0; u <= 1; u += 0.0625)
        for (double v = 0; v <= 1; v += 0.0625) {
            EXPECT_LE(value(net, u, v), net.maxCoeff());
            EXPECT_GE(value(net, u, v), net.minCoeff());
        }
    for (const int i : {0, 1})
        for (const int j : {0, 1})
            EXPECT_NEAR(net(5 * i, 5 * j), value(net, i, j), 1e-10);
}

TEST(BernsteinNet, HalvesAreThePolynomialOnEitherHalf)
{
    const BernsteinNet net = normal_net(random_patch(3), direction);
    const auto [left, right] = halves(net, Parameter::U);
    const auto [below, above] = halves(net, Parameter::V);
    for (double s = 0; s <= 1; s += 0.125)
        for (double t = 0; t <= 1; t += 0.125) {
            EXPECT_NEAR(value(left, s, t), value(net, s / 2, t), 1e-10);
            EXPECT_NEAR(value(right, s, t), value(net, (1 + s) / 2, t), 1e-10);
            EXPECT_NEAR(value(below, s, t), value(net, s, t / 2), 1e-10);
            EXPECT_NEAR(value(above, s, t), value(net, s, (1 + t) / 2), 1e-10);
        }
}

TEST(BernsteinNet, HalvesOfAConstantAreThatConstantToTheBit)
{
    const BernsteinNet constant = BernsteinNet::Constant(4, 4, 0.1);
    const auto [low, high] = halves(constant, Parameter::V);
    EXPECT_EQ(low, constant);
    EXPECT_EQ(high, constant);
}

TEST(BernsteinPiece, IsHalvedAcrossItsWiderSide)
{
    const BernsteinNet net = height_net(random_patch(4), direction);
    const auto [left, right] = halves(BernsteinPiece{net, {0, 0}, 1, 1});
    EXPECT_EQ(left.width_u, 0.5);
    EXPECT_EQ(left.width_v, 1);
    EXPECT_EQ(right.low.u, 0.5);
    EXPECT_EQ(right.low.v, 0);
    const auto [below, above] = halves(right);
    EXPECT_EQ(below.width_u, 0.5);
    EXPECT_EQ(below.width_v, 0.5);
    EXPECT_EQ(above.low.u, 0.5);
    EXPECT_EQ(above.low.v, 0.5);
}

TEST(BernsteinPiece, AfterManyHalvingsIsStillThePolynomialThere)
{
    const BernsteinNet net = normal_net(random_patch(5), direction);
    test::Random random{5};
    for (int trial = 0; trial < 20; ++trial) {
        BernsteinPiece piece{net, {0, 0}, 1, 1};
        for (int k = 0; k < 20; ++k) {
            auto [low, high] = halves(piece);
            piece = random.uniform(0, 1) < 0.5 ? low : high;
        }
        EXPECT_NEAR(piece.net(0, 0), value(net, piece.low.u, piece.low.v), 1e-10);
        EXPECT_NEAR(piece.net(5, 5),
                    value(net, piece.low.u + piece.width_u, piece.low.v + piece.width_v),
                    1e-10);
    }
}

TEST(BernsteinNet, DividedByAnEdgeIsThePolynomialOverItsDistanceFromTheEdge)
{
    for (const Parameter parameter : {Parameter::U, Parameter::V})
        for (const int edge : {0, 1}) {
            BernsteinNet net = normal_net(random_patch(6), direction);
            if (parameter == Parameter::U)
                net.row(5 * edge).setZero();
            else
                net.col(5 * edge).setZero();
            const BernsteinNet divided = divided_by_edge(net, parameter, edge);
            for (const double u : {0.1, 0.4, 0.9})
                for (const double v : {0.2, 0.5, 0.7}) {
                    const double t = parameter == Parameter::U ? u : v;
                    const double factor = edge == 0 ? t : 1 - t;
                    EXPECT_NEAR(value(divided, u, v) * factor, value(net, u, v), 1e-10);
                }
        }
}

}  // namespace
}  // namespace endmill
