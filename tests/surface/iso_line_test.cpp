// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/iso_line.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "test_surfaces.h"

namespace endmill {
namespace {

// Two patches of unequal widths, so that derivatives depend on the widths.
Surface uneven_surface(unsigned seed)
{
    const Surface even = test::random_surface(seed, {2, 2});
    std::vector<BezierPatch> patches;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i)
            patches.push_back(even.patch(i, j));
    return Surface{{-1, 0.5, 4}, {2, 3, 3.25}, patches};
}

TEST(IsoLine, IsTheSurfaceAlongIt)
{
    test::Random random{1};
    for (unsigned seed = 0; seed < 5; ++seed) {
        const Surface surface = uneven_surface(seed);
        for (const double v : {1.9, 2.0, 2.3, 3.0, 3.1, 3.25, 3.3}) {
            const IsoLine line{surface, v};
            EXPECT_EQ(line.v(), v);
            EXPECT_EQ(line.range().low, -1);
            EXPECT_EQ(line.range().high, 4);
            for (const double u : {-1.2, -1.0, 0.5, 4.0, 4.2, random.uniform(-1, 4)}) {
                const SurfaceJet jet = line.jet(u);
                const SurfaceJet expected = surface.jet(u, v);
                EXPECT_LT((line.point(u) - expected.point).norm(), 1e-12);
                EXPECT_LT((jet.point - expected.point).norm(), 1e-12);
                EXPECT_LT((jet.du - expected.du).norm(), 1e-11);
                EXPECT_LT((jet.dv - expected.dv).norm(), 1e-10);
                EXPECT_LT((jet.duu - expected.duu).norm(), 1e-10);
                EXPECT_LT((jet.duv - expected.duv).norm(), 1e-9);
                EXPECT_LT((jet.dvv - expected.dvv).norm(), 1e-8);
            }
        }
    }
}

// The first u above `from` that is beyond the distance, in steps of a ten-thousandth of
// the range.
std::optional<double> scanned_reach(const IsoLine& line, double from,
                                    const Vec3& direction, double distance)
{
    constexpr int steps = 10000;
    const Vec3 start = line.point(from);
    for (int k = 1; k <= steps; ++k) {
        const double u = from + (line.range().high - from) * k / steps;
        if ((line.point(u) - start).dot(direction) >= distance)
            return u;
    }
    return std::nullopt;
}

TEST(IsoLine, FirstReachAgreesWithADenseScan)
{
    test::Random random{2};
    int reached = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        const Surface surface = test::random_surface(seed, {3, 1}, 25);
        const IsoLine line{surface, random.uniform(0, 1)};
        const double from = random.uniform(0, 2.5);
        const Vec3 direction = line.jet(from).du.normalized();
        const double distance = random.uniform(0.5, 40);
        const auto found = line.first_reach(from, direction, distance);
        const auto expected = scanned_reach(line, from, direction, distance);
        if (!expected) {
            EXPECT_FALSE(found) << seed;
            continue;
        }
        ++reached;
        ASSERT_TRUE(found) << seed;
        EXPECT_GT(*found, from);
        EXPECT_LE(*found, *expected);
        EXPECT_GT(*found, *expected - 3e-4) << "one step of the scan";
        EXPECT_NEAR((line.point(*found) - line.point(from)).dot(direction), distance,
                    1e-15 * surface.diagonal());
    }
    EXPECT_GT(reached, 15);
}

TEST(IsoLine, OnAStraightLineReachesByProportion)
{
    const Surface plane = test::plane(200, 120, {3, 2});
    const IsoLine line{plane, 0.7};
    for (const double from : {0.0, 0.4, 1.0, 2.9})
        for (const double distance : {1e-9, 1.0, 6.0})
            EXPECT_NEAR(line.first_reach(from, Vec3::UnitX(), distance).value(),
                        from + distance * 3 / 200, 1e-14);
}

TEST(IsoLine, ReachesAcrossSeveralBorders)
{
    const Surface plane = test::plane(50, 10, {5, 1});
    const IsoLine line{plane, 0};
    EXPECT_NEAR(line.first_reach(0.5, Vec3::UnitX(), 31).value(), 3.6, 1e-14);
    EXPECT_NEAR(line.first_reach(0.5, Vec3::UnitX(), 30).value(), 3.5, 1e-14);
    EXPECT_NEAR(line.first_reach(1, Vec3::UnitX(), 40).value(), 5, 1e-14);
}

TEST(IsoLine, NeverReachesBeyondItsEndNorBackwards)
{
    const Surface plane = test::plane(50, 10, {5, 1});
    const IsoLine line{plane, 0};
    EXPECT_FALSE(line.first_reach(0, Vec3::UnitX(), 50.001));
    EXPECT_FALSE(line.first_reach(0, -Vec3::UnitX(), 1));
    EXPECT_FALSE(line.first_reach(0, Vec3::UnitZ(), 1e-9));
    EXPECT_FALSE(line.first_reach(5, Vec3::UnitX(), 1e-9));
}

TEST(IsoLine, ThatTurnsBackReachesAtTheFirstPass)
{
    // x = 3 t (1 - t) rises to 3/4 and returns.
    const Surface hairpin =
        test::polynomial_surface({test::monomial(1, 0, 3) + test::monomial(2, 0, -3),
                                  test::monomial(0, 1, 1), test::monomial(1, 0, 0.1)},
                                 {{0, 1}, {0, 1}}, {2, 1});
    const IsoLine line{hairpin, 0.5};
    for (const double x : {0.1, 0.5, 0.7, 0.7499})
        EXPECT_NEAR(line.first_reach(0, Vec3::UnitX(), x).value(),
                    1 - std::sqrt(1 - 4 * x / 3), 1e-12);
    EXPECT_FALSE(line.first_reach(0, Vec3::UnitX(), 0.7501));
}

TEST(IsoLine, OfACollapsedEdgeIsAPointAndReachesNothing)
{
    const Surface fan = test::polynomial_surface(
        {test::monomial(0, 1, 1), test::monomial(1, 1, 1), test::monomial(0, 0, 0)},
        {{0, 1}, {0, 1}});
    const IsoLine line{fan, 0};
    EXPECT_EQ(line.point(0.2), line.point(0.9));
    EXPECT_EQ(line.jet(0.4).du, Vec3::Zero());
    EXPECT_FALSE(line.first_reach(0, Vec3::UnitX(), 1e-3));
}

TEST(IsoLine, ReportsThatItIsAPoint)
{
    for (const Vec3& pole : {Vec3{0, 0, 0}, {7.3, 11.1, 0.7}}) {
        const Surface fan = test::polynomial_surface(
            {test::monomial(0, 1, 1) + test::monomial(0, 0, pole.x()),
             test::monomial(1, 1, 1) + test::monomial(0, 0, pole.y()),
             test::monomial(0, 0, pole.z())},
            {{0, 1}, {0, 1}}, {3, 2});
        EXPECT_TRUE((IsoLine{fan, 0}.is_point()));
        EXPECT_FALSE((IsoLine{fan, 1e-6}.is_point()));
        EXPECT_FALSE((IsoLine{transposed(fan), 0}.is_point()));
    }
    EXPECT_FALSE((IsoLine{test::random_surface(1), 0.5}.is_point()));
}

TEST(IsoLine, BoundsTheErrorOfAChord)
{
    test::Random random{3};
    for (unsigned seed = 0; seed < 20; ++seed) {
        const IsoLine line{uneven_surface(seed), random.uniform(2, 3.2)};
        const double from = random.uniform(-1, 3);
        const double to = random.uniform(from, 4);
        const double bend = line.bend_bound(from, to);
        double greatest = 0;
        double strays = 0;
        for (int k = 0; k <= 1000; ++k) {
            const double share = k / 1000.0;
            const double u = std::lerp(from, to, share);
            greatest = std::max(greatest, line.jet(u).duu.norm());
            const Vec3 on_chord = (1 - share) * line.point(from) + share * line.point(to);
            strays = std::max(strays, (line.point(u) - on_chord).norm());
        }
        EXPECT_GE(bend, greatest * (1 - 1e-12));
        EXPECT_LE(bend, greatest * 1.01);
        if (to < 0.5 || from > 0.5) {
            EXPECT_LE(strays, (to - from) * (to - from) / 8 * bend * (1 + 1e-12))
                << "on one patch";
        }
    }
}

}  // namespace
}  // namespace endmill
