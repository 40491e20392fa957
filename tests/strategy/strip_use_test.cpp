// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/strip_use.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "test_meshes.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr double radius = 5;
constexpr double height = 0.5;
const double width = 2 * std::sqrt(height * (2 * radius - height));

// Passes along x over a plane of 100 by 60 mm at z = 0, at the given y, in steps of 5 mm, with
// lifted links.
ToolPath passes_at(const std::vector<double>& ys)
{
    ToolPath path;
    for (int pass = 0; pass < std::ssize(ys); ++pass)
        for (int k = 0; k <= 20; ++k)
            path.points.push_back({pass,
                                   0,
                                   k == 0 ? Move::Plunge : Move::Cut,
                                   0,
                                   {{5.0 * k, ys[pass], 0}, Vec3::UnitZ()}});
    return path;
}

Part plane()
{
    return std::vector<Surface>{test::plane(100, 60)};
}

// Half way along, a pass covers a whole strip. The next one is `share` of a strip apart.
TEST(StripUse, OnAPlaneIsTheShareOfTheStripThatIsNew)
{
    for (const double share : {0.25, 0.5, 1.0}) {
        const std::vector<double> use = strip_use(
            plane(), passes_at({20, 20 + share * width}), BallCutter{radius}, height);
        ASSERT_EQ(use.size(), 42u);
        EXPECT_NEAR(use[10], 1, 0.04);
        EXPECT_NEAR(use[31], share, 0.04);
        EXPECT_EQ(use[21], 0) << "a plunge";
    }
}

TEST(StripUse, IsZeroWhereAPassIsRepeated)
{
    const std::vector<double> use =
        strip_use(plane(), passes_at({20, 20}), BallCutter{radius}, height);
    EXPECT_NEAR(use[31], 0, 1e-12);
}

// The areas of all stretches together are what the passes cover, whatever their order.
TEST(StripUse, AddsUpToTheCoveredArea)
{
    const std::vector<double> ys{30, 26, 34, 28};
    const std::vector<double> use =
        strip_use(plane(), passes_at(ys), BallCutter{radius}, height);
    double area = 0;
    for (const double share : use)
        area += 5 * share * width;
    EXPECT_NEAR(area, 100 * (8 + width), 0.01 * 100 * (8 + width));
}

TEST(StripUse, OnAMeshIsThatOnTheSurface)
{
    const TriangleMesh mesh = test::grid_mesh(2, 1, [](int i, int j) {
        return Vec3{50.0 * i, 60.0 * j, 0};
    });
    const ToolPath path = passes_at({20, 23, 26});
    const std::vector<double> on_mesh = strip_use(mesh, path, BallCutter{radius}, height);
    const std::vector<double> use = strip_use(plane(), path, BallCutter{radius}, height);
    for (std::size_t k = 0; k < use.size(); ++k)
        EXPECT_NEAR(on_mesh[k], use[k], 0.1) << k;
}

TEST(StripUse, RefusesAHeightOfTheRadius)
{
    EXPECT_THROW(strip_use(plane(), passes_at({20}), BallCutter{radius}, radius),
                 DomainError);
    EXPECT_TRUE(strip_use(plane(), {}, BallCutter{radius}, height).empty());
}

}  // namespace
}  // namespace endmill
