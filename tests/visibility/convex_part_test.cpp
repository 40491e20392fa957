// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/convex_part.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/visibility/detail/cover_radius.h"
#include "test_meshes.h"

namespace endmill {
namespace {

constexpr double degree = std::numbers::pi / 180;

TEST(ConvexPart, HasTheNormalsOfItsFaces)
{
    const ConvexPart cube = convex_part("cube", Angle::degrees(75));
    const ConvexPart prism = convex_part("prism", Angle::degrees(78));
    ASSERT_EQ(cube.normals.size(), 5U);
    ASSERT_EQ(prism.normals.size(), 7U);
    for (std::size_t k = 1; k < 7; ++k) {
        EXPECT_NEAR(prism.normals[k].norm(), 1, 1e-15);
        EXPECT_NEAR(prism.normals[k].dot(Vec3::UnitZ()), 0, 1e-15);
    }
    EXPECT_THROW(convex_part("sphere", Angle::degrees(75)), DomainError);
    EXPECT_THROW(convex_part("cube", Angle::degrees(90)), DomainError);
}

// Two directions that lean by t from the top, to opposite sides. They reach a side whose normal
// makes the angle a with their azimuth if sin t cos a > cos(incidence): a = 45 degrees for the
// cube, and the two nearest of a = 0, 60 degrees for the prism.
TEST(ConvexPart, HasAShortestArcOfTwoLeaningDirections)
{
    const double cube = convex_part("cube", Angle::degrees(75)).shortest_arc.radians();
    const double prism = convex_part("prism", Angle::degrees(78)).shortest_arc.radians();
    EXPECT_NEAR(std::sin(cube / 2) * std::cos(45 * degree), std::cos(75 * degree), 1e-15);
    EXPECT_NEAR(std::sin(prism / 2) * std::cos(60 * degree), std::cos(78 * degree),
                1e-15);
}

// Nothing hides a face of a convex mesh, so its visibility is the cap of its normal.
TEST(CapMap, IsTheVisibilityOfABox)
{
    const SphereGrid grid = sphere_grid("hex:10");
    const ConvexPart cube = convex_part("cube", Angle::degrees(75));
    const VisibilityMap caps = cap_map(cube, grid);
    const TriangleMesh box = test::box_mesh({-1, -1, -1}, {1, 1, 1});
    const PartVisibility seen =
        part_visibility(box, grid.centres, {.incidence = Angle::degrees(75)});
    for (std::size_t face = 0; face < cube.normals.size(); ++face)
        for (std::size_t facet = 0; facet < box.triangles().size(); ++facet) {
            const auto [a, b, c] = box.corners(facet);
            if ((b - a).cross(c - a).normalized().dot(cube.normals[face]) < 0.9)
                continue;
            for (std::size_t cell = 0; cell < grid.centres.size(); ++cell)
                EXPECT_EQ(caps.is_accessible(face, cell),
                          seen.map.is_accessible(facet, cell));
        }
}

// No pair of cells is nearer than the closed form, which holds for all pairs of directions. A cell
// lies within the covering radius d of a direction whose d-neighbourhood sees the same faces. That
// direction is at most d sqrt(2) beyond the shortest arc, so the excess is below 2 d (1 + sqrt(2)).
TEST(ShortestArcOfTwo, IsNearTheClosedForm)
{
    const ConvexPart cube = convex_part("cube", Angle::degrees(75));
    for (const char* name : {"hex:5", "hex:10", "hex:20"}) {
        const SphereGrid grid = sphere_grid(name);
        const double excess =
            shortest_arc_of_two(cap_map(cube, grid), grid) - cube.shortest_arc.radians();
        EXPECT_GT(excess, 0) << name;
        EXPECT_LT(excess, 2 * (1 + std::numbers::sqrt2) * cover_radius(grid.centres))
            << name;
    }
}

TEST(ShortestArcOfTwo, OfOppositeFacesIsNearlyAHalfTurn)
{
    const SphereGrid grid = sphere_grid("hex:10");
    VisibilityMap map{2, grid.centres.size()};
    for (std::size_t cell = 0; cell < map.cells(); ++cell)
        map.column(cell)[0] = grid.centres[cell].z() > 0.95    ? 1
                              : grid.centres[cell].z() < -0.95 ? 2
                                                               : 0;
    EXPECT_GT(shortest_arc_of_two(map, grid), (180 - 2 * 18.2) * degree);
}

}  // namespace
}  // namespace endmill
