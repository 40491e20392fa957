// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/interference/offset_jet.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/cutter/reference_point.h"

namespace endmill {
namespace {

// z = f(x, y) = 0.1 x^2 + 0.05 x y - 0.02 y^3 + 0.3 x as a surface over (u, v) = (x, y).
SurfaceJet graph(double x, double y)
{
    return {{x, y, 0.1 * x * x + 0.05 * x * y - 0.02 * y * y * y + 0.3 * x},
            {1, 0, 0.2 * x + 0.05 * y + 0.3},
            {0, 1, 0.05 * x - 0.06 * y * y},
            {0, 0, 0.2},
            {0, 0, 0.05},
            {0, 0, -0.12 * y}};
}

const Cutter cutters[] = {Cutter::ball(5), Cutter{5, 2}, Cutter::flat(5)};

TEST(OffsetJet, LiesWhereTheContactPutsTheCutter)
{
    for (const Cutter& cutter : cutters) {
        const SurfaceJet jet = graph(1.5, 2);
        const auto offset = offset_jet(jet, 1, cutter);
        ASSERT_TRUE(offset);
        const Vec3 normal = unit_normal({jet.point, jet.du, jet.dv});
        EXPECT_LT((offset->point - control_point(cutter, {jet.point, normal})).norm(),
                  1e-14);
    }
}

TEST(OffsetJet, PartialsAreThoseOfThePoint)
{
    constexpr double h = 1e-5;  // central differences: error about h^2 and 1e-16 / h
    for (const Cutter& cutter : cutters) {
        const auto point = [&](double x, double y) {
            return offset_jet(graph(x, y), 1, cutter)->point;
        };
        for (const auto& [x, y] : {std::pair{1.5, 2.0}, {-3.0, 1.0}, {0.2, -2.5}}) {
            const auto offset = *offset_jet(graph(x, y), 1, cutter);
            const Vec3 du = (point(x + h, y) - point(x - h, y)) / (2 * h);
            const Vec3 dv = (point(x, y + h) - point(x, y - h)) / (2 * h);
            EXPECT_LT((offset.du - du).norm(), 1e-8);
            EXPECT_LT((offset.dv - dv).norm(), 1e-8);
        }
    }
}

TEST(OffsetJet, PartialsOfATurnedNormalAreThoseOfThePoint)
{
    constexpr double h = 1e-5;
    for (const Cutter& cutter : cutters)
        for (const Parameter along : {Parameter::U, Parameter::V}) {
            const auto at = [&](double e, double angle) {
                const SurfaceJet jet = along == Parameter::U ? graph(e, 2) : graph(2, e);
                return *turned_offset_jet(jet, 1, along, angle, cutter);
            };
            const SurfaceTangents offset = at(1.2, 0.4);
            const Vec3 du = (at(1.2 + h, 0.4).point - at(1.2 - h, 0.4).point) / (2 * h);
            const Vec3 dv = (at(1.2, 0.4 + h).point - at(1.2, 0.4 - h).point) / (2 * h);
            EXPECT_LT((offset.du - du).norm(), 1e-8);
            EXPECT_LT((offset.dv - dv).norm(), 1e-8);
        }
}

TEST(OffsetJet, OfANormalThatIsNotTurnedIsTheSurfacesOwn)
{
    for (const Cutter& cutter : cutters) {
        const SurfaceJet jet = graph(1, 2);
        const auto own = *offset_jet(jet, 1, cutter);
        const auto turned = *turned_offset_jet(jet, 1, Parameter::U, 0, cutter);
        EXPECT_LT((own.point - turned.point).norm(), 1e-14);
        EXPECT_LT((own.du - turned.du).norm(), 1e-13);
    }
}

TEST(OffsetJet, OfABallStaysOneRadiusFromTheLineWhateverTheTurn)
{
    const SurfaceJet jet = graph(1, 2);
    for (const double angle : {-1.2, -0.3, 0.5, 1.4}) {
        const Vec3 centre =
            turned_offset_jet(jet, 1, Parameter::V, angle, Cutter::ball(5))->point;
        EXPECT_NEAR((centre - jet.point).norm(), 5, 1e-14);
        EXPECT_NEAR((centre - jet.point).dot(jet.dv), 0, 1e-13);
    }
}

TEST(OffsetJet, HeedsTheToolSide)
{
    const SurfaceJet jet = graph(1, 1);
    const SurfaceJet swapped{jet.point, jet.dv, jet.du, jet.dvv, jet.duv, jet.duu};
    const auto offset = *offset_jet(jet, 1, Cutter{5, 2});
    const auto other = *offset_jet(swapped, -1, Cutter{5, 2});
    EXPECT_LT((offset.point - other.point).norm(), 1e-14);
    EXPECT_LT((offset.du - other.dv).norm(), 1e-13);
}

TEST(OffsetJet, IsNoneWhereItIsNotDefined)
{
    const SurfaceJet level{{0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                           {0, 0, 1}, {0, 0, 0}, {0, 0, 1}};
    EXPECT_TRUE(offset_jet(level, 1, Cutter::ball(5)));
    EXPECT_FALSE(offset_jet(level, 1, Cutter::flat(5)));
    EXPECT_FALSE(offset_jet(level, 1, Cutter(5, 2)));
    SurfaceJet collapsed = level;
    collapsed.du.setZero();
    EXPECT_FALSE(offset_jet(collapsed, 1, Cutter::ball(5)));
}

}  // namespace
}  // namespace endmill
