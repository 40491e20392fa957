// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/facet_boxes.h"

#include <gtest/gtest.h>

#include "test_meshes.h"

namespace endmill {
namespace {

TEST(FacetBoxes, TestEachFacetOnceIfNoBoxIsExcluded)
{
    const TriangleMesh part = test::torus_mesh(17, 9);
    std::vector<int> asked(part.triangles().size(), 0);
    const bool any =
        FacetBoxes{part}.any([](const Vec3&, const Vec3&) { return true; },
                             [&](std::size_t facet) { return ++asked[facet] > 1; });
    EXPECT_FALSE(any);
    for (const int times : asked)
        EXPECT_EQ(times, 1);
}

// A box that excludes a point does not contain it, so that no facet with the point as a
// corner is missed.
TEST(FacetBoxes, FindTheOneFacetWithACorner)
{
    const TriangleMesh part = test::torus_mesh(17, 9);
    const FacetBoxes boxes{part};
    for (std::size_t wanted = 0; wanted < part.triangles().size(); ++wanted) {
        const Vec3 corner = part.corners(wanted)[1];
        int boxes_asked = 0;
        EXPECT_TRUE(boxes.any(
            [&](const Vec3& low, const Vec3& high) {
                ++boxes_asked;
                return (low.array() <= corner.array()).all() &&
                       (corner.array() <= high.array()).all();
            },
            [&](std::size_t facet) { return facet == wanted; }));
        EXPECT_LT(boxes_asked, 100);
    }
}

TEST(FacetBoxes, MayBeEmpty)
{
    const auto always = [](const auto&...) { return true; };
    EXPECT_FALSE(FacetBoxes{TriangleMesh{}}.any(always, always));
}

}  // namespace
}  // namespace endmill
