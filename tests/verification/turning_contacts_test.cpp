// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/turning_contacts.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/core/angle.h"
#include "endmill/core/tolerance.h"
#include "endmill/surface/nurbs.h"

namespace endmill {
namespace {

double rad(double degrees)
{
    return Angle::degrees(degrees).radians();
}

// A wall at x = 30 that faces the tool. It ends at z = 20, where the lower rim of the holder
// reaches it, so that the side of the holder above does not.
Part wall()
{
    const Nurbs plane{{1, {0, 0, 1, 1}},
                      {1, {0, 0, 1, 1}},
                      {{30, -40, 0}, {30, -40, 20}, {30, 40, 0}, {30, 40, 20}},
                      {}};
    return std::vector<Surface>{nurbs_surface(plane)};
}

// A holder of diameter 40 from 30 above the tip, which stays at the origin, leans towards
// the wall.
PartCollisions leaning_to(double degrees)
{
    const Part part = wall();
    std::vector<ToolPiece> bodies;
    const auto at = [](double angle) {
        return CutterLocation{{0, 0, 0}, {std::sin(angle), 0, std::cos(angle)}};
    };
    constexpr int steps = 20;
    for (int k = 0; k < steps; ++k)
        bodies.push_back(
            {{at(k * rad(degrees) / steps), at((k + 1) * rad(degrees) / steps)},
             CuttingBody::of_cylinder({40, 30, 70}),
             k + 1,
             k + 1});
    return turning_contacts(part_charts(part), {std::move(bodies), {{0, 0, 0}, 120}}, 1,
                            1'000'000);
}

TEST(TurningContacts, HolderTouchesTheWallBeyondTheExactAngle)
{
    const double exact = std::asin(30 / std::sqrt(1300.0)) - std::atan(2.0 / 3);
    EXPECT_NEAR(exact, rad(22.6198649), 1e-9);
    // The corner moves by 20 mm per rad or more, so 0.01 degrees are 3 um.
    const PartCollisions before = leaning_to(22.61);
    EXPECT_EQ(before.moves.count, 0U);
    EXPECT_FALSE(before.deepest);
    EXPECT_FALSE(may_be_in_part(before));
    const PartCollisions after = leaning_to(22.7);
    EXPECT_GT(after.moves.count, 0U);
    ASSERT_TRUE(after.deepest);
    EXPECT_EQ(after.deepest->move, 20U);
    EXPECT_EQ(after.moves.first, 20U);
}

TEST(TurningContacts, DepthIsWithinItsError)
{
    const PartCollisions found = leaning_to(30);
    // The far lower corner of the holder, beyond the wall.
    const double depth = 30 * std::sin(rad(30)) + 20 * std::cos(rad(30)) - 30;
    EXPECT_LE(found.moves.deepest, 20.0);
    EXPECT_GE(found.moves.deepest + found.error_mm, depth * std::cos(rad(30)) - 1e-3);
    EXPECT_LT(found.moves.first, 20U);
}

TEST(TurningContacts, WithoutBodiesThereAreNone)
{
    const Part part = wall();
    const PartCollisions found =
        turning_contacts(part_charts(part), {{}, {{0, 0, 0}, 120}}, 1, 1000);
    EXPECT_EQ(found.moves.count, 0U);
    EXPECT_EQ(found.bound_mm, 0);
}

}  // namespace
}  // namespace endmill
