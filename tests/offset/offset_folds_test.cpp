// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/detail/offset_folds.h"

#include <cmath>

#include <gtest/gtest.h>

#include "grid_mesh.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr double bend = 0.2;       // 1/mm, curvature of the trough at its bottom
constexpr double half_width = 10;  // mm
constexpr int lines = 41;

OffsetMesh trough_offset(double radius)
{
    const std::vector part{test::parabolic_cylinder(bend, half_width, 20)};
    return offset_mesh(part, Cutter::ball(radius),
                       {.grid_lines = lines, .boundary = BoundaryContact::None});
}

// x of line `i` of the grid.
double at(int i)
{
    return half_width * (2.0 * i / (lines - 1) - 1);
}

// The x of the ball's centre over the trough z = bend x^2 / 2.
double centre_over(double x, double radius)
{
    return x - radius * bend * x / std::sqrt(1 + bend * bend * x * x);
}

// The curvature of the parabola is bend / (1 + bend^2 x^2)^(3/2).
std::size_t lines_in_the_bottom(double radius)
{
    std::size_t count = 0;
    for (int i = 0; i < lines; ++i)
        count += bend / std::pow(1 + std::pow(bend * at(i), 2), 1.5) > 1 / radius ? 1 : 0;
    return count;
}

// The lines of the grid are straight, so that both triangles of a cell face down exactly
// where the ball's centre moves backwards.
std::size_t cells_with_a_step_back(double radius)
{
    std::size_t count = 0;
    for (int i = 1; i < lines; ++i)
        count += centre_over(at(i), radius) < centre_over(at(i - 1), radius) ? 1 : 0;
    return count;
}

TEST(OffsetFolds, OfATroughAreWhereTheBallIsTooLarge)
{
    for (const double radius : {3.0, 5.5, 8.0, 12.0}) {
        const std::vector part{test::parabolic_cylinder(bend, half_width, 20)};
        const OffsetMesh offset = trough_offset(radius);
        EXPECT_EQ(too_concave_contacts(offset, part), lines * lines_in_the_bottom(radius))
            << radius;
        EXPECT_EQ(folded_triangles(offset.mesh),
                  2 * (lines - 1) * cells_with_a_step_back(radius))
            << radius;
    }
}

TEST(OffsetFolds, AreNoneUnderABallThatFits)
{
    const std::vector part{test::parabolic_cylinder(bend, half_width, 20)};
    const OffsetMesh offset = trough_offset(4.9);
    EXPECT_EQ(too_concave_contacts(offset, part), 0U);
    EXPECT_EQ(folded_triangles(offset.mesh), 0U);
}

// Where both principal radii of a bowl are below the ball's, the offset is turned over
// twice and faces up again.
TEST(OffsetFolds, AreNoneWhereBothCurvaturesAreTooConcave)
{
    const std::vector part{
        test::graph(test::monomial(2, 0, bend / 2) + test::monomial(0, 2, bend / 2),
                    {{-0.5, 0.5}, {-0.5, 0.5}})};
    const OffsetMesh offset = offset_mesh(
        part, Cutter::ball(20), {.grid_lines = 9, .boundary = BoundaryContact::None});
    EXPECT_EQ(too_concave_contacts(offset, part), 0U);
    EXPECT_EQ(folded_triangles(offset.mesh), 0U);
}

TEST(OffsetFolds, OfAMeshTurnedOverAreAllItsTriangles)
{
    const TriangleMesh turned = test::grid_mesh(4, 3, [](int i, int j) {
        return Vec3{-1.0 * i, 1.0 * j, 0.1 * i * j};
    });
    EXPECT_EQ(folded_triangles(turned), turned.triangles().size());
}

}  // namespace
}  // namespace endmill
