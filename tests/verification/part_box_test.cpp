// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/part_box.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/verification/detail/closed_form_parts.h"

namespace endmill {
namespace {

TEST(PartBox, HoldsASurfaceTightly)
{
    const Block box = bounding_box(plane_part({4, 0, 1}, {0, 2, -3}));
    EXPECT_EQ(box.low, (Vec3{0, 0, -3}));
    EXPECT_EQ(box.high, (Vec3{4, 2, 1}));
}

TEST(PartBox, IgnoresUnusedPointsOfAMesh)
{
    const Part mesh = TriangleMesh{{{0, 0, 0}, {1, 0, 0}, {0, 2, 3}, {99, 99, 99}},
                                   {Triangle{0, 1, 2}}};
    const Block box = bounding_box(mesh);
    EXPECT_EQ(box.low, (Vec3{0, 0, 0}));
    EXPECT_EQ(box.high, (Vec3{1, 2, 3}));
}

TEST(PartBox, OfNothingIsInfinite)
{
    EXPECT_FALSE(std::isfinite(bounding_box(Part{TriangleMesh{}}).low.x()));
}

}  // namespace
}  // namespace endmill
