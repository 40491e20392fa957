// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/continuum_travel.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/planning/path_interval.h"
#include "endmill/surface/nurbs.h"
#include "revolved_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

const ScallopRequest request{BallCutter{5}, 0.1};

TEST(ContinuumTravel, OnAPlaneIsAreaOverInterval)
{
    const Surface plane = test::plane(30, 20);
    const double interval = 2 * std::sqrt(2 * 5 * 0.1 - 0.01);
    for (const Parameter direction : {Parameter::U, Parameter::V}) {
        const ContinuumTravel travel = continuum_travel(plane, request, direction, 10);
        EXPECT_NEAR(travel.iso, 600 / interval, 1e-9);
        EXPECT_NEAR(travel.local, 600 / interval, 1e-9);
        EXPECT_NEAR(travel.best_direction, 600 / interval, 1e-9);
    }
}

TEST(PlanarExtremes, OnAPlaneAreTheSameInEveryDirection)
{
    const PlanarExtremes planes = planar_extremes(test::plane(30, 30), request, 4, 40);
    const double travel = 900 / (2 * std::sqrt(2 * 5 * 0.1 - 0.01));
    EXPECT_NEAR(planes.least, travel, 1e-8);
    EXPECT_NEAR(planes.greatest, travel, 1e-8);
}

// On a convex cylinder of radius 20, passes along the axis have the interval of a circle; passes
// around it have that of a plane, which is larger.
TEST(ContinuumTravel, OnACylinderIsLeastAroundIt)
{
    const Surface cylinder = nurbs_surface(test::cylinder(20, 10, 1, 2));
    const double area = 20 * 1 * 10;
    const double along = path_interval(request.ball, 1 / 20.0, 0.1).chord;
    const double around = path_interval(request.ball, 0, 0.1).chord;
    ASSERT_LT(along, around);
    const ContinuumTravel u = continuum_travel(cylinder, request, Parameter::U, 60);
    const ContinuumTravel v = continuum_travel(cylinder, request, Parameter::V, 60);
    EXPECT_NEAR(u.local / (area / along), 1, 1e-3);
    EXPECT_NEAR(v.local / (area / around), 1, 1e-3);
    EXPECT_NEAR(u.best_direction / (area / around), 1, 1e-3);
    EXPECT_NEAR(v.best_direction / (area / around), 1, 1e-3);
    EXPECT_NEAR(u.iso / (area / along), 1, 1e-3);
}

// The narrowest place governs a pass, and one direction is at best as good as each place's own.
TEST(ContinuumTravel, IsOrderedOnASaddle)
{
    const Surface saddle = test::saddle(60, 20);
    const ContinuumTravel travel = continuum_travel(saddle, request, Parameter::U, 40);
    EXPECT_GE(travel.iso, travel.local);
    EXPECT_GE(travel.local, travel.best_direction);
    const PlanarExtremes planes = planar_extremes(saddle, request, 12, 60);
    EXPECT_LE(planes.least, planes.greatest);
    EXPECT_GE(planes.least, 0.99 * travel.best_direction);
}

}  // namespace
}  // namespace endmill
