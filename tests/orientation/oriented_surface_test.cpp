// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/detail/oriented_surface.h"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

namespace endmill {
namespace {

// The surface z = (a x^2 + b y^2) / 2 over [-15, 15] x [-10, 10], exact as a patch of degree 2.
Surface paraboloid(double a, double b)
{
    std::vector<Vec3> net;
    for (const double j : {-1.0, 0.0, 1.0})
        for (const double i : {-1.0, 0.0, 1.0})
            net.emplace_back(
                15 * i, 10 * j,
                (a * 225 * (i == 0 ? -1 : 1) + b * 100 * (j == 0 ? -1 : 1)) / 2);
    return Surface{{0, 1}, {0, 1}, {BezierPatch{2, 2, net}}};
}

TEST(OrientedSurface, PlaceHasTheCurvaturesOfAParaboloid)
{
    const Surface surface = paraboloid(-0.02, 0.03);
    const OrientedOptions options;
    const Cutter cutter{5, 1};
    const OrientedSurface oriented{surface, 1, 0, cutter, options};
    const PassPlace top = oriented.place(0.5, {0.5, false});
    EXPECT_NEAR((top.feed - Vec3{-1, 0, 0}).norm(), 0, 1e-12);
    EXPECT_NEAR(top.curvature.along, 0.02, 1e-12);
    EXPECT_NEAR(top.curvature.across, -0.03, 1e-12);
    EXPECT_NEAR(top.curvature.mixed, 0, 1e-12);
    EXPECT_NEAR(top.across, 20, 1e-9);
}

TEST(OrientedSurface, LinesCoverTheSurfaceAndRowsReachItsEnds)
{
    const Surface surface = paraboloid(-0.02, -0.01);
    OrientedOptions options;
    options.inclination.lead = Angle::degrees(8);
    const Cutter cutter{5, 1};
    const OrientedSurface oriented{surface, 1, 0, cutter, options};
    double covered = 0;
    for (const PassLine& line : oriented.passes()) {
        EXPECT_LE(line.across - line.covered, covered + 1e-12);
        covered = line.across + line.covered;
        const auto rows = oriented.rows(line);
        EXPECT_NEAR(rows.front().place.at.u, line.is_forward ? 0 : 1, 1e-12);
        EXPECT_NEAR(rows.back().place.at.u, line.is_forward ? 1 : 0, 1e-12);
        for (const PassPose& row : rows) {
            // the strip is at least as wide as the pass needs
            const RuledContact ruled = oriented.ruled(row.place, line);
            EXPECT_GE(row.strip_mm, ruled.needed_strip_mm);
            EXPECT_NEAR(ruled.wanted_strip_mm, row.strip_mm, 1e-12);
        }
    }
    EXPECT_GE(covered, 1 - 1e-12);
}

TEST(OrientedSurface, PosesByAxisAndByInclinationAreTheSame)
{
    const Surface surface = paraboloid(-0.02, -0.01);
    const OrientedOptions options;
    const Cutter cutter{5, 1};
    const OrientedSurface oriented{surface, 1, 0, cutter, options};
    const PassPlace place = oriented.place(0.3, {0.8});
    const PassPose first =
        oriented.posed(place, Inclination{Angle::degrees(12), Angle::degrees(-4)});
    const PassPose second = oriented.posed(place, first.location.axis);
    EXPECT_NEAR((first.location.tip - second.location.tip).norm(), 0, 1e-12);
    EXPECT_NEAR(second.inclination.tilt.degrees(), -4, 1e-10);
    EXPECT_NEAR(second.strip_mm, first.strip_mm, 1e-10);
    EXPECT_NEAR(contact_way(first, second), 0, 0);
}

TEST(OrientedSurface, FieldsWantALeadOfAtLeastOneDegreeForCuttersThatAreNoBalls)
{
    const Surface dome = paraboloid(-0.02, -0.01);
    OrientedOptions options;
    options.mode = AxisMode::Field;
    const Cutter ball = Cutter::ball(5);
    const Cutter bull{5, 1};
    const auto wanted = [&](const Cutter& cutter) {
        const OrientedSurface oriented{dome, 1, 0, cutter, options};
        return oriented.inclination_at(oriented.place(0.3, {0.8})).lead.degrees();
    };
    EXPECT_NEAR(wanted(ball), 0, 1e-12);
    EXPECT_NEAR(wanted(bull), 1, 1e-12);
    // in a bowl the heel needs more
    const Surface bowl = paraboloid(0.03, 0.03);
    EXPECT_NEAR((OrientedSurface{bowl, 1, 0, bull, options}.rear_lead().degrees()),
                std::asin(4 / (1 / 0.03 - 1)) * 180 / std::acos(-1.0), 0.01);
}

}  // namespace
}  // namespace endmill
