// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of patches of any degree and with weights, and of the functions on them.
#include "endmill/surface/bezier_patch.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "elevated.h"
#include "endmill/core/error.h"
#include "endmill/surface/detail/bernstein_net.h"
#include "endmill/surface/detail/collapsed_edge.h"
#include "endmill/surface/detail/iso_line.h"
#include "endmill/surface/extent.h"
#include "endmill/surface/tool_side.h"
#include "revolved_surfaces.h"

namespace endmill {
namespace {

struct Kind {
    int degree_u, degree_v;
    bool rational;
};

constexpr Kind kinds[] = {{1, 1, false}, {1, 1, true}, {2, 2, true},  {3, 3, true},
                          {2, 5, false}, {4, 3, true}, {7, 1, false}, {25, 25, true}};

BezierPatch patch_of(const Kind& kind, unsigned seed)
{
    return test::random_patch(seed, kind.degree_u, kind.degree_v, kind.rational);
}

Surface surface_of(const Kind& kind, unsigned seed)
{
    return Surface{{-1, 3}, {2, 2.5}, {patch_of(kind, seed)}};
}

// By de Casteljau's algorithm on homogeneous points, first along u, then along v.
Vec3 de_casteljau(const BezierPatch& patch, double u, double v)
{
    const auto reduce = [](std::vector<Eigen::Vector4d> row, double t) {
        for (std::size_t left = row.size() - 1; left > 0; --left)
            for (std::size_t k = 0; k < left; ++k)
                row[k] = (1 - t) * row[k] + t * row[k + 1];
        return row.front();
    };
    std::vector<Eigen::Vector4d> column;
    for (int j = 0; j <= patch.degree(Parameter::V); ++j) {
        std::vector<Eigen::Vector4d> row;
        for (int i = 0; i <= patch.degree(Parameter::U); ++i)
            row.push_back(patch.homogeneous_point(i, j));
        column.push_back(reduce(row, u));
    }
    const Eigen::Vector4d point = reduce(column, v);
    return point.head<3>() / point[3];
}

TEST(RationalPatch, AgreesWithDeCasteljau)
{
    for (const Kind& kind : kinds)
        for (double u = 0; u <= 1; u += 0.25)
            for (double v = 0; v <= 1; v += 0.25) {
                const BezierPatch patch = patch_of(kind, 1);
                EXPECT_LT((patch.jet(u, v).point - de_casteljau(patch, u, v)).norm(),
                          1e-11);
            }
}

TEST(RationalPatch, PartialsAreTheSlopesOfThoseBelow)
{
    constexpr double h = 1e-5;
    for (const Kind& kind : kinds) {
        const BezierPatch patch = patch_of(kind, 2);
        const double scale = 10.0 * kind.degree_u * kind.degree_v;
        for (const double u : {0.2, 0.7})
            for (const double v : {0.1, 0.6}) {
                const SurfaceJet jet = patch.jet(u, v);
                const SurfaceJet after_u = patch.jet(u + h, v);
                const SurfaceJet before_u = patch.jet(u - h, v);
                const SurfaceJet after_v = patch.jet(u, v + h);
                const SurfaceJet before_v = patch.jet(u, v - h);
                const auto off = [&](const Vec3& partial, const Vec3& high,
                                     const Vec3& low) {
                    return (partial - (high - low) / (2 * h)).norm() / scale;
                };
                EXPECT_LT(off(jet.du, after_u.point, before_u.point), 1e-6);
                EXPECT_LT(off(jet.dv, after_v.point, before_v.point), 1e-6);
                EXPECT_LT(off(jet.duu, after_u.du, before_u.du), 1e-5);
                EXPECT_LT(off(jet.duv, after_v.du, before_v.du), 1e-5);
                EXPECT_LT(off(jet.dvv, after_v.dv, before_v.dv), 1e-5);
                const SurfaceTangents tangents = patch.tangents(u, v);
                EXPECT_LT((tangents.point - jet.point).norm(), 1e-11);
                EXPECT_LT((tangents.du - jet.du).norm(), 1e-9);
                EXPECT_LT((tangents.dv - jet.dv).norm(), 1e-9);
            }
    }
}

TEST(RationalPatch, QuarterTurnLiesOnTheCircle)
{
    const Surface surface = nurbs_surface(test::cylinder(7, 20, 0, std::numbers::pi / 2));
    for (double v = 0; v <= 1; v += 0.0625) {
        const Vec3 point = surface.jet(0.3, v).point;
        EXPECT_NEAR(std::hypot(point.y(), point.z()), 7, 1e-14);
    }
}

TEST(RationalPatch, TurnedAndElevatedIsTheSameSurface)
{
    for (const Kind& kind : kinds) {
        const BezierPatch patch = patch_of(kind, 3);
        const BezierPatch exchanged = transposed(patch);
        const BezierPatch reversed = reversed_in_u(patch);
        const int more = kind.degree_u == 25 ? 0 : 3;
        const BezierPatch higher =
            test::elevated(patch, kind.degree_u + more, kind.degree_v + more / 2);
        EXPECT_EQ(higher.degree(Parameter::U), kind.degree_u + more);
        EXPECT_EQ(exchanged.degree(Parameter::U), kind.degree_v);
        for (const double u : {0.0, 0.3, 1.0})
            for (const double v : {0.0, 0.4, 1.0}) {
                const Vec3 point = patch.jet(u, v).point;
                EXPECT_LT((exchanged.jet(v, u).point - point).norm(), 1e-11);
                EXPECT_LT((reversed.jet(1 - u, v).point - point).norm(), 1e-11);
                EXPECT_LT((higher.jet(u, v).point - point).norm(), 1e-11);
            }
    }
}

TEST(RationalPatch, RefusesInvalidDegreesWeightsAndSizes)
{
    const std::vector<Vec3> net(9, Vec3{1, 2, 3});
    const std::vector<double> ones(9, 1.0);
    EXPECT_NO_THROW(BezierPatch(2, 2, net, ones));
    EXPECT_THROW(BezierPatch(0, 8, net), DomainError);
    EXPECT_THROW(BezierPatch(2, 26, net), DomainError);
    EXPECT_THROW(BezierPatch(2, 3, net), DomainError);
    EXPECT_THROW(BezierPatch(2, 2, net, std::vector<double>(8, 1.0)), DomainError);
    for (const double bad : {0.0, -1.0, double(NAN), double(INFINITY)}) {
        std::vector<double> weights = ones;
        weights[4] = bad;
        EXPECT_THROW(BezierPatch(2, 2, net, weights), DomainError);
    }
}

double value(const BernsteinNet& net, double u, double v)
{
    const auto reduce = [](Eigen::VectorXd b, double t) {
        for (Eigen::Index left = b.size() - 1; left > 0; --left)
            b.head(left) = (1 - t) * b.head(left) + t * b.segment(1, left).eval();
        return b[0];
    };
    Eigen::VectorXd row{net.cols()};
    for (Eigen::Index j = 0; j < net.cols(); ++j)
        row[j] = reduce(net.col(j), u);
    return reduce(row, v);
}

TEST(RationalPatch, NormalNetIsTheCrossProductTimesTheWeightCubed)
{
    const Vec3 direction = Vec3{1, -2, 3}.normalized();
    for (const Kind& kind : kinds) {
        if (kind.degree_u > 7)
            continue;
        const BezierPatch patch = patch_of(kind, 4);
        const BernsteinNet net = normal_net(patch, direction);
        const BernsteinNet weights = weight_net(patch);
        EXPECT_EQ(net.rows(), (kind.rational ? 3 : 2) * kind.degree_u);
        EXPECT_EQ(net.cols(), (kind.rational ? 3 : 2) * kind.degree_v);
        for (const double u : {0.0, 0.35, 1.0})
            for (const double v : {0.0, 0.8, 1.0}) {
                const SurfaceJet jet = patch.jet(u, v);
                const double w = value(weights, u, v);
                const double expected = w * w * w * jet.du.cross(jet.dv).dot(direction);
                EXPECT_NEAR(value(net, u, v), expected, 1e-9);
            }
    }
}

TEST(RationalPatch, IsoLineIsTheSurfaceAlongIt)
{
    for (const Kind& kind : kinds) {
        const Surface surface = surface_of(kind, 5);
        for (const double v : {2.0, 2.2, 2.5}) {
            const IsoLine line{surface, v};
            for (const double u : {-1.0, 0.1, 3.0}) {
                const SurfaceJet jet = line.jet(u);
                const SurfaceJet expected = surface.jet(u, v);
                EXPECT_LT((line.point(u) - expected.point).norm(), 1e-11);
                EXPECT_LT((jet.point - expected.point).norm(), 1e-11);
                EXPECT_LT((jet.du - expected.du).norm(), 1e-9);
                EXPECT_LT((jet.dv - expected.dv).norm(), 1e-9);
                EXPECT_LT((jet.duu - expected.duu).norm(), 1e-7);
                EXPECT_LT((jet.duv - expected.duv).norm(), 1e-7);
                EXPECT_LT((jet.dvv - expected.dvv).norm(), 1e-6);
            }
        }
    }
}

TEST(RationalPatch, IsoLineReachesWhereADenseScanDoes)
{
    test::Random random{6};
    int reached = 0;
    for (const Kind& kind : kinds)
        for (int trial = 0; trial < 20; ++trial) {
            const Surface surface = surface_of(kind, trial);
            const IsoLine line{surface, random.uniform(2, 2.5)};
            const double from = random.uniform(-1, 2);
            const Vec3 direction =
                Vec3{random.uniform(-1, 1), random.uniform(-1, 1), 1}.normalized();
            const double distance = random.log_uniform(0.1, 10);
            const Vec3 start = line.point(from);
            const auto beyond = [&](double u) {
                return (line.point(u) - start).dot(direction) - distance;
            };
            constexpr int steps = 4000;
            const auto at = [&](int k) { return from + (3 - from) * k / steps; };
            int first = 1;
            while (first <= steps && beyond(at(first)) < 0)
                ++first;
            const auto found = line.first_reach(from, direction, distance);
            if (first > steps) {
                EXPECT_TRUE(!found || std::abs(beyond(*found)) < 1e-9);
                continue;
            }
            ++reached;
            ASSERT_TRUE(found);
            EXPECT_NEAR(beyond(*found), 0, 1e-11);
            EXPECT_LE(*found, at(first));
        }
    EXPECT_GT(reached, 40);
}

TEST(RationalPatch, BendOfAnIsoLineIsBounded)
{
    for (const Kind& kind : kinds)
        for (unsigned seed = 0; seed < 5; ++seed) {
            const Surface surface = surface_of(kind, seed);
            const IsoLine line{surface, 2.3};
            const double from = -0.5 + 0.1 * seed;
            const double bound = line.bend_bound(from, from + 0.25);
            double sampled = 0;
            for (int k = 0; k <= 50; ++k)
                sampled = std::max(sampled, line.jet(from + 0.005 * k).duu.norm());
            EXPECT_GE(bound, sampled * (1 - 1e-9));
            if (kind.degree_u < 10) {  // for high degrees the bounds are safe but wide
                EXPECT_LE(bound, 40 * (sampled + 1));
            }
        }
}

TEST(RationalPatch, ExtentOfASphereIsItsRadius)
{
    constexpr double pi = std::numbers::pi;
    const Surface cap = nurbs_surface(test::torus(0, 9, {-1, 1, 0.2, pi / 2 + 0.4, 2}));
    EXPECT_NEAR(extent(cap, Vec3::UnitZ()).high, 9, 1e-8);
    const Vec3 direction = Vec3{1, 0.3, 1}.normalized();
    EXPECT_NEAR(extent(cap, direction).high, 9, 1e-8);
}

TEST(RationalPatch, OfAPlaneIsReachedForAllWeights)
{
    const std::vector<Vec3> net{{0, 0, 0}, {9, 0, 0}, {0, 7, 0}, {9, 7, 0}};
    for (const double ratio : {1.0, 60.0, 1e2, 1e3})
        for (const double scale : {1e-150, 1.0, 3e150}) {
            const std::vector<double> weights{scale, scale / ratio, scale, scale};
            const Surface plane{{0, 1}, {0, 1}, {BezierPatch{1, 1, net, weights}}};
            EXPECT_FALSE(find_unreachable_place(plane, Vec3::UnitZ(), 1)) << ratio;
            EXPECT_TRUE(find_unreachable_place(plane, Vec3::UnitX(), 1)) << ratio;
            EXPECT_NEAR(area(plane), 63, 1e-7);
        }
}

TEST(RationalPatch, PoleOfASphereIsACollapsedEdgeThatTheToolReaches)
{
    constexpr double pi = std::numbers::pi;
    const Surface cap = nurbs_surface(test::torus(0, 9, {0, pi / 2, 0.3, pi / 2}));
    EXPECT_TRUE(is_collapsed(cap.patch(0, 0), Parameter::V, 1));
    EXPECT_FALSE(is_collapsed(cap.patch(0, 0), Parameter::V, 0));
    EXPECT_EQ(tool_side_sign(cap, Vec3::UnitZ()), 1);
    EXPECT_FALSE(find_unreachable_place(cap, Vec3::UnitZ(), 1));
    EXPECT_TRUE(find_unreachable_place(cap, Vec3::UnitZ(), -1));
    const Surface beyond = nurbs_surface(test::torus(0, 9, {0, pi / 2, -0.1, pi / 2}));
    const auto place = find_unreachable_place(beyond, Vec3::UnitZ(), 1);
    ASSERT_TRUE(place);
    EXPECT_LE(place->point.z(), 1e-9);
}

}  // namespace
}  // namespace endmill
