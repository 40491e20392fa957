// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/bezier_patch.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

BezierPatch random_patch(unsigned seed)
{
    return BezierPatch{test::random_net(seed, {1, 1}, 8)};
}

// B_ij = (10 i, 10 j, i j).
std::vector<Vec3> tabulated_net()
{
    std::vector<Vec3> net;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
            net.emplace_back(10 * i, 10 * j, i * j);
    return net;
}

// The same point by de Casteljau's algorithm, first in v, then in u.
Vec3 de_casteljau(const BezierPatch& patch, double u, double v)
{
    std::array<Vec3, 4> row;
    for (int i = 0; i < 4; ++i) {
        std::array<Vec3, 4> column;
        for (int j = 0; j < 4; ++j)
            column[j] = patch.control_point(i, j);
        for (int level = 3; level > 0; --level)
            for (int j = 0; j < level; ++j)
                column[j] = (1 - v) * column[j] + v * column[j + 1];
        row[i] = column[0];
    }
    for (int level = 3; level > 0; --level)
        for (int i = 0; i < level; ++i)
            row[i] = (1 - u) * row[i] + u * row[i + 1];
    return row[0];
}

// The vectors were computed with 50 digits.
TEST(BezierPatch, EqualsTheTabulatedPoint)
{
    const SurfaceJet jet = BezierPatch{tabulated_net()}.jet(0.3, 0.7);
    EXPECT_LT((jet.point - Vec3{9, 21, 1.89}).norm(), 1e-13);
    EXPECT_LT((jet.du - Vec3{30, 0, 6.3}).norm(), 1e-13);
    EXPECT_LT((jet.dv - Vec3{0, 30, 2.7}).norm(), 1e-13);
    EXPECT_LT((jet.duv - Vec3{0, 0, 9}).norm(), 1e-12);
    EXPECT_LT(jet.duu.norm() + jet.dvv.norm(), 1e-12);
}

TEST(BezierPatch, AgreesWithDeCasteljau)
{
    test::Random random{2};
    for (unsigned seed = 0; seed < 50; ++seed) {
        const BezierPatch patch = random_patch(seed);
        const double u = random.uniform(-0.5, 1.5);
        const double v = random.uniform(-0.5, 1.5);
        EXPECT_LT((patch.jet(u, v).point - de_casteljau(patch, u, v)).norm(), 1e-12);
    }
}

TEST(BezierPatch, FirstPartialsAreTheSlopesOfItsPoints)
{
    // Differences have errors of the order h^2 and rounding / h.
    constexpr double h = 1e-5;
    const BezierPatch patch = random_patch(3);
    test::Random random{3};
    for (int k = 0; k < 100; ++k) {
        const double u = random.uniform(0, 1);
        const double v = random.uniform(0, 1);
        const auto point = [&](double s, double t) { return patch.jet(s, t).point; };
        const SurfaceJet jet = patch.jet(u, v);
        const Vec3 du = (point(u + h, v) - point(u - h, v)) / (2 * h);
        const Vec3 dv = (point(u, v + h) - point(u, v - h)) / (2 * h);
        EXPECT_LT((jet.du - du).norm(), 1e-7);
        EXPECT_LT((jet.dv - dv).norm(), 1e-7);
    }
}

TEST(BezierPatch, SecondPartialsAreTheSlopesOfTheFirst)
{
    constexpr double h = 1e-5;
    const BezierPatch patch = random_patch(4);
    test::Random random{4};
    for (int k = 0; k < 100; ++k) {
        const double u = random.uniform(0, 1);
        const double v = random.uniform(0, 1);
        const SurfaceJet jet = patch.jet(u, v);
        const SurfaceJet after_u = patch.jet(u + h, v);
        const SurfaceJet before_u = patch.jet(u - h, v);
        const SurfaceJet after_v = patch.jet(u, v + h);
        const SurfaceJet before_v = patch.jet(u, v - h);
        EXPECT_LT((jet.duu - (after_u.du - before_u.du) / (2 * h)).norm(), 1e-6);
        EXPECT_LT((jet.duv - (after_u.dv - before_u.dv) / (2 * h)).norm(), 1e-6);
        EXPECT_LT((jet.duv - (after_v.du - before_v.du) / (2 * h)).norm(), 1e-6);
        EXPECT_LT((jet.dvv - (after_v.dv - before_v.dv) / (2 * h)).norm(), 1e-6);
    }
}

TEST(BezierPatch, TangentsAreTheStartOfTheJet)
{
    const BezierPatch patch = random_patch(5);
    for (double u = -0.25; u <= 1.25; u += 0.125)
        for (double v = -0.25; v <= 1.25; v += 0.125) {
            const SurfaceTangents tangents = patch.tangents(u, v);
            const SurfaceJet jet = patch.jet(u, v);
            EXPECT_LT((tangents.point - jet.point).norm(), 1e-13);
            EXPECT_LT((tangents.du - jet.du).norm(), 1e-12);
            EXPECT_LT((tangents.dv - jet.dv).norm(), 1e-12);
        }
}

TEST(BezierPatch, PassesThroughItsCornersAlongTheNet)
{
    const BezierPatch patch = random_patch(6);
    for (const int i : {0, 3})
        for (const int j : {0, 3}) {
            const SurfaceJet jet = patch.jet(i == 0 ? 0 : 1, j == 0 ? 0 : 1);
            const int inward_i = i == 0 ? 1 : -1;
            const int inward_j = j == 0 ? 1 : -1;
            const Vec3 corner = patch.control_point(i, j);
            const Vec3 du =
                3 * inward_i * (patch.control_point(i + inward_i, j) - corner);
            const Vec3 dv =
                3 * inward_j * (patch.control_point(i, j + inward_j) - corner);
            EXPECT_EQ(jet.point, corner);
            EXPECT_LT((jet.du - du).norm(), 1e-13);
            EXPECT_LT((jet.dv - dv).norm(), 1e-13);
        }
}

TEST(BezierPatch, ContinuesItsPolynomialOutsideTheUnitSquare)
{
    const Surface bowl =
        test::graph(test::monomial(3, 3, 2) + test::monomial(1, 2, -1), {{0, 1}, {0, 1}});
    for (const double x : {-0.7, 1.9})
        for (const double y : {-0.4, 1.3}) {
            const SurfaceJet jet = bowl.patch(0, 0).jet(x, y);
            EXPECT_NEAR(jet.point.z(), 2 * std::pow(x * y, 3) - x * y * y, 1e-12);
            EXPECT_NEAR(jet.du.z(), 6 * x * x * std::pow(y, 3) - y * y, 1e-12);
            EXPECT_NEAR(jet.dvv.z(), 12 * std::pow(x, 3) * y - 2 * x, 1e-11);
        }
}

TEST(BezierPatch, TransposedExchangesTheParameters)
{
    const BezierPatch patch = random_patch(7);
    const BezierPatch turned = transposed(patch);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            EXPECT_EQ(turned.control_point(j, i), patch.control_point(i, j));
    const SurfaceJet jet = patch.jet(0.2, 0.9);
    const SurfaceJet other = turned.jet(0.9, 0.2);
    EXPECT_LT((other.point - jet.point).norm(), 1e-13);
    EXPECT_LT((other.du - jet.dv).norm(), 1e-12);
    EXPECT_LT((other.dvv - jet.duu).norm(), 1e-12);
    EXPECT_LT((other.duv - jet.duv).norm(), 1e-12);
}

void expect_grid_as_one_by_one(const BezierPatch& patch)
{
    const std::vector<double> u{0, 0.125, 0.6, 1, 1.25};
    const std::vector<double> v{0.3, 1, -0.25};
    const std::vector<SurfaceTangents> all = patch.tangents(u, v);
    const std::vector<Vec3> places = patch.places(u, v);
    ASSERT_EQ(all.size(), u.size() * v.size());
    ASSERT_EQ(places.size(), all.size());
    for (std::size_t j = 0; j < v.size(); ++j)
        for (std::size_t i = 0; i < u.size(); ++i) {
            const SurfaceTangents& found = all[j * u.size() + i];
            const SurfaceTangents expected = patch.tangents(u[i], v[j]);
            EXPECT_LT((found.point - expected.point).norm(), 1e-12);
            EXPECT_LT((places[j * u.size() + i] - expected.point).norm(), 1e-12);
            EXPECT_LT((found.du - expected.du).norm(), 1e-11);
            EXPECT_LT((found.dv - expected.dv).norm(), 1e-11);
        }
}

TEST(BezierPatch, TangentsOnAGridAreThoseOneByOne)
{
    expect_grid_as_one_by_one(random_patch(8));
    const std::vector<Vec3> net{{0, 0, 0}, {1, 0, 2}, {2, 0, 0},
                                {0, 1, 1}, {1, 1, 3}, {2, 1, 0}};
    expect_grid_as_one_by_one(BezierPatch{2, 1, net});
    expect_grid_as_one_by_one(
        BezierPatch{2, 1, net, std::vector<double>{1, 0.5, 2, 1, 3, 1}});
}

TEST(BezierPatch, TangentsOnAnEmptyGridAreNone)
{
    const std::vector<double> some{0.5};
    EXPECT_TRUE(random_patch(1).tangents({}, some).empty());
    EXPECT_TRUE(random_patch(1).tangents(some, {}).empty());
    EXPECT_TRUE(random_patch(1).places({}, some).empty());
    EXPECT_TRUE(random_patch(1).places(some, {}).empty());
}

TEST(BezierPatch, OfOnePointHasNoTangents)
{
    const BezierPatch pole{std::vector<Vec3>(16, Vec3{1, 2, 3})};
    const SurfaceJet jet = pole.jet(0.5, 0.5);
    EXPECT_LT((jet.point - Vec3{1, 2, 3}).norm(), 1e-15);
    EXPECT_LT(jet.du.norm() + jet.dv.norm() + jet.duv.norm(), 1e-14);
}

TEST(BezierPatch, RefusesANetOfTheWrongSize)
{
    for (const std::size_t size : {0, 1, 15, 17})
        EXPECT_THROW((BezierPatch{std::vector<Vec3>(size, Vec3::Zero())}), DomainError);
}

TEST(BezierPatch, RefusesPointsThatAreNotFinite)
{
    for (const double bad : {std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()}) {
        std::vector<Vec3> net = tabulated_net();
        net[7].y() = bad;
        EXPECT_THROW(BezierPatch{net}, DomainError);
    }
}

}  // namespace
}  // namespace endmill
