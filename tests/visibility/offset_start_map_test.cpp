// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/offset_start_map.h"

#include <gtest/gtest.h>

#include "endmill/visibility/sphere_grid.h"
#include "test_meshes.h"

namespace endmill {
namespace {

std::size_t differences(const TriangleMesh& mesh, double start)
{
    const SphereGrid grid = sphere_grid("hex:10");
    const Angle incidence = Angle::degrees(80);
    const VisibilityMap exact =
        part_visibility(mesh, grid.centres, {.incidence = incidence}).map;
    const VisibilityMap map = offset_start_map(mesh, grid.centres, incidence, start);
    std::size_t count = 0;
    for (std::size_t cell = 0; cell < map.cells(); ++cell)
        for (std::size_t facet = 0; facet < map.facets(); ++facet)
            count += map.is_accessible(facet, cell) != exact.is_accessible(facet, cell);
    return count;
}

TEST(OffsetStartMap, OfAConvexMeshIsExactWithAnyOffset)
{
    const TriangleMesh box = test::box_mesh({-1, -2, -1}, {1, 1, 3});
    EXPECT_EQ(differences(box, 1e-6), 0U);
    EXPECT_EQ(differences(box, 0.5), 0U);
}

// On a torus a ray that starts far off its facet passes over what hides the facet.
TEST(OffsetStartMap, OfATorusDiffersMoreWithALargerOffset)
{
    const TriangleMesh torus = test::torus_mesh(24, 12);
    const std::size_t near = differences(torus, 1e-9);
    EXPECT_LT(near, 10U);
    EXPECT_GT(differences(torus, 0.3), near);
}

}  // namespace
}  // namespace endmill
