// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/verification_task.h"

#include <gtest/gtest.h>

#include "endmill/verification/detail/closed_form_parts.h"

namespace endmill {
namespace {

// Of two triangles one faces +z and one -z; a third is upright.
TEST(VerificationTask, ChartsOfFiveAxesFaceOneOfTheToolAxes)
{
    const Part part = TriangleMesh{
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}},
        {Triangle{0, 1, 2}, Triangle{0, 1, 3}, Triangle{0, 2, 3}, Triangle{1, 2, 3}}};
    ToolPath path = tip_path({{0, 0, 0}, {1, 0, 0}});
    VerificationTask task{
        .path = &path, .cutter = Cutter::ball(1), .stock = Block{{0, 0, 0}, {1, 1, 1}}};
    task.judged = JudgedPart{.part = &part};
    const auto with_axis = [&](const Vec3& axis, RemovalEngine engine) {
        path.points[1].location.axis = axis;
        task.engine = engine;
        return judged_charts(task).count();
    };
    const std::uint32_t upright = with_axis({0, 0, 1}, RemovalEngine::ThreeAxis);
    EXPECT_EQ(with_axis({0, 0, 1}, RemovalEngine::FiveAxis), upright);
    EXPECT_EQ(with_axis({0, 0.6, -0.8}, RemovalEngine::FiveAxis), 4U);
}

}  // namespace
}  // namespace endmill
