// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/closed_form_parts.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace endmill {
namespace {

const Surface& surface_of(const Part& part)
{
    return std::get<std::vector<Surface>>(part).front();
}

TEST(ClosedFormParts, PlaneAndCylinderHaveTheirPoints)
{
    const Part plane = plane_part({6, 0, 3}, {0, 4, 0});
    EXPECT_LT((surface_of(plane).tangents(0.5, 0.25).point - Vec3{3, 1, 1.5}).norm(),
              1e-14);
    const Part cylinder = cylinder_part(20, {0.3, 2.3});
    for (const double u : {0.0, 0.4, 1.0})
        for (const double v : {0.0, 0.3, 1.0}) {
            const Vec3 point = surface_of(cylinder).tangents(u, v).point;
            EXPECT_NEAR(std::hypot(point.y(), point.z()), 20, 1e-12);
            EXPECT_NEAR(point.x(), 4 * u, 1e-13);
        }
    const Vec3 last = surface_of(cylinder).tangents(0, 1).point;
    EXPECT_NEAR(std::atan2(last.z(), last.y()), 2.3, 1e-14);
}

TEST(ClosedFormParts, LevelPassesLieApartAndOverrun)
{
    const auto tips_of = [](const ToolPath& path) {
        std::vector<double> across;
        for (const PathPoint& point : path.points) {
            EXPECT_TRUE(point.location.tip.x() <= -5 || point.location.tip.x() >= 25);
            across.push_back(point.location.tip.y());
        }
        return across;
    };
    EXPECT_EQ(tips_of(level_passes(6, {})), (std::vector<double>{0, 0, 6, 6, 12, 12}));
    EXPECT_EQ(tips_of(level_passes(6, 1)), (std::vector<double>{0, 0, 12, 12}));
}

TEST(ClosedFormParts, PassesAlongTheCylinderKeepTheirDistance)
{
    const ToolPath path = passes_along_cylinder(25, 0.3, 0.07);
    for (const PathPoint& point : path.points) {
        const Vec3 centre = point.location.tip + Vec3{0, 0, 5};
        EXPECT_NEAR(std::hypot(centre.y(), centre.z()), 25, 1e-12);
    }
    const Vec3 last = path.points.back().location.tip + Vec3{0, 0, 5};
    EXPECT_GE(std::atan2(last.z(), last.y()), 2.3);
}

TEST(ClosedFormParts, LoweredPathTouchesTheLoweredPlane)
{
    const double slope = 0.5;
    const Vec3 normal{-std::sin(slope), 0, std::cos(slope)};
    for (const PathPoint& point : lowered_path(slope, 0.2).points) {
        const Vec3 centre = point.location.tip + Vec3{0, 0, 5.2};
        EXPECT_NEAR(centre.dot(normal), 5, 1e-12);
    }
}

}  // namespace
}  // namespace endmill
