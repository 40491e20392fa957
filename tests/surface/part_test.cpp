// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/part.h"

#include <gtest/gtest.h>

#include "test_surfaces.h"

namespace endmill {
namespace {

TEST(Part, IsSurfacesOrAMesh)
{
    EXPECT_TRUE(std::holds_alternative<std::vector<Surface>>(
        Part{std::vector{test::plane(1, 1)}}));
    EXPECT_TRUE(std::holds_alternative<TriangleMesh>(Part{TriangleMesh{}}));
}

}  // namespace
}  // namespace endmill
