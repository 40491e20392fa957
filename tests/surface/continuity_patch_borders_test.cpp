// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/continuity.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/surface/largest_cutter.h"
#include "endmill/surface/nurbs.h"
#include "endmill/surface/tool_side.h"
#include "revolved_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

// The patches of a surface as separate surfaces, every second one transposed and every
// third one reversed, so that their borders run in all directions.
std::vector<Surface> taken_apart(const Surface& surface)
{
    std::vector<Surface> parts;
    int number = 0;
    for (int j = 0; j < surface.patches(Parameter::V); ++j)
        for (int i = 0; i < surface.patches(Parameter::U); ++i) {
            Surface part{{0, 1}, {0, 1}, {surface.patch(i, j)}};
            if (number % 2 == 1)
                part = transposed(part);
            if (number % 3 == 2)
                part = reversed_in_u(part);
            parts.push_back(part);
            ++number;
        }
    return parts;
}

TEST(PatchBorders, OfASurfaceTakenApartAreItsOwn)
{
    for (unsigned seed = 0; seed < 4; ++seed) {
        const Surface whole = test::random_surface(seed, {3, 2});
        const SurfaceContinuity expected = continuity(whole);
        const SurfaceContinuity found = continuity(taken_apart(whole));
        ASSERT_EQ(expected.continuity, Continuity::G0);
        EXPECT_EQ(found.continuity, Continuity::G0);
        EXPECT_NEAR(found.worst.normals.radians(), expected.worst.normals.radians(),
                    1e-6);
        EXPECT_LT((found.worst.point - expected.worst.point).norm(), 1e-6);
    }
}

TEST(PatchBorders, OfAFoldedRoofAreG0AtItsAngle)
{
    const double slope = std::tan(std::numbers::pi / 6);
    const SurfaceContinuity found = continuity(taken_apart(test::valley(20, 30, slope)));
    EXPECT_EQ(found.continuity, Continuity::G0);
    EXPECT_NEAR(found.worst.normals.degrees(), 60, 1e-9);
}

TEST(PatchBorders, OfASheetFoldedBackAreG0AtAHalfTurn)
{
    const Surface sheet = test::plane(10, 20);
    const Surface above = test::graph(
        test::monomial(0, 0, 3) + test::monomial(1, 0, -0.3), {{0, 10}, {0, 20}});
    const SurfaceContinuity fold = continuity(std::vector{sheet, above});
    EXPECT_EQ(fold.continuity, Continuity::G0);
    EXPECT_NEAR(fold.worst.normals.degrees(),
                180 - std::atan(0.3) * 180 / std::numbers::pi, 1e-9);
}

TEST(PatchBorders, OfASphereInPiecesOfOtherParametersAreG1)
{
    // two pieces that share an arc and have parameters of different lengths
    const std::vector<Surface> pieces{
        nurbs_surface(test::torus(0, 10, {0, 1, 0.2, 1.2})),
        nurbs_surface(test::torus(0, 10, {1, 1.7, 0.2, 1.2}))};
    const SurfaceContinuity found = continuity(pieces);
    EXPECT_EQ(found.continuity, Continuity::G1);
    EXPECT_LT(found.worst.gap_mm, 1e-12);
}

TEST(PatchBorders, PatchesThatDoNotMeetHaveNone)
{
    const Surface plane = test::plane(10, 10);
    const Surface away = test::graph(test::monomial(0, 0, 5), {{0, 10}, {0, 10}});
    const SurfaceContinuity found = continuity(std::vector{plane, away});
    EXPECT_EQ(found.continuity, Continuity::G1);
    EXPECT_EQ(found.worst.normals.radians(), 0);
}

TEST(PatchBorders, LargestBallOfASurfaceTakenApartIsItsOwn)
{
    const Surface whole = test::saddle(25, 20, {3, 2});
    const auto apart = taken_apart(whole);
    const auto sides = tool_side_signs(apart, Vec3::UnitZ());
    const auto expected = largest_cutter(whole, 1);
    const auto found = largest_cutter(apart, sides);
    ASSERT_TRUE(expected);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->radius_mm, expected->radius_mm, 1e-6);
}

TEST(PatchBorders, LargestBallBetweenTwoWallsTouchesBoth)
{
    // two sheets that lean towards each other at 45 degrees, with their feet 20 mm apart
    const std::vector<Surface> walls{
        test::graph(test::monomial(1, 0, -1), {{-30, -10}, {0, 30}}),
        test::graph(test::monomial(1, 0, 1), {{10, 30}, {0, 30}})};
    const auto found = largest_cutter(walls, tool_side_signs(walls, Vec3::UnitZ()));
    ASSERT_TRUE(found);
    // the ball touches the foot of one wall and passes through the foot of the other
    EXPECT_NEAR(found->radius_mm, 20 * std::numbers::sqrt2 / 2, 1e-6);
}

}  // namespace
}  // namespace endmill
