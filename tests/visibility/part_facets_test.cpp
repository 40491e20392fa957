// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/part_facets.h"

#include <gtest/gtest.h>

#include "test_meshes.h"

namespace endmill {
namespace {

TEST(PartFacets, HaveOutwardUnitNormals)
{
    const PartFacets facets = part_facets(test::box_mesh({0, 0, 0}, {1, 2, 3}));
    const std::vector<Vec3> normals{{0, 0, -1}, {0, 0, 1},  {0, -1, 0},
                                    {0, 1, 0},  {-1, 0, 0}, {1, 0, 0}};
    ASSERT_EQ(facets.normals.size(), 12U);
    for (std::size_t facet = 0; facet < 12; ++facet)
        EXPECT_LT((facets.normals[facet] - normals[facet / 2]).norm(), 1e-15);
    EXPECT_TRUE(facets.dropped.empty());
    const Vec3 first = (Vec3{0, 0, 0} + Vec3{0, 2, 0} + Vec3{1, 2, 0}) / 3;
    EXPECT_LT((facets.centroids[0] - first).norm(), 1e-15);
}

TEST(PartFacets, DropThoseWithoutAreaAndKeepTheirNumbers)
{
    const TriangleMesh part{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {1, 0, 0}},
                            {{0, 1, 2}, {0, 1, 3}, {0, 0, 3}, {1, 2, 3}}};
    const PartFacets facets = part_facets(part);
    EXPECT_EQ(facets.dropped, (std::vector<std::size_t>{0, 2}));
    EXPECT_FALSE(facets.has_area(0));
    EXPECT_TRUE(facets.has_area(1));
    EXPECT_FALSE(facets.has_area(2));
    EXPECT_TRUE(facets.has_area(3));
}

// The sides are parallel up to rounding. The exact cross product is (0, 0, -6 * 2^-50).
TEST(PartFacets, KeepSliversWhoseRoundedNormalIsZero)
{
    const TriangleMesh part{{{0, 0, 0}, {7, 7 + 0x1p-50, 0}, {1, 1, 0}}, {{0, 1, 2}}};
    const PartFacets facets = part_facets(part);
    EXPECT_TRUE(facets.has_area(0));
    EXPECT_EQ(facets.normals[0], -Vec3::UnitZ());
}

TEST(PartFacets, AreAccurateForAnySize)
{
    for (const double size : {1e-100, 1e-30, 1e30}) {
        const TriangleMesh part{{{0, 0, 0}, {3 * size, 0, 0}, {0, size, size}},
                                {{0, 1, 2}}};
        const Vec3 normal = part_facets(part).normals[0];
        EXPECT_LT((normal - Vec3{0, -1, 1}.normalized()).norm(), 1e-15);
    }
}

}  // namespace
}  // namespace endmill
