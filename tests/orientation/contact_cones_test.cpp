// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/detail/contact_cones.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/visibility/sphere_grid.h"
#include "random.h"

namespace endmill {
namespace {

constexpr double height = 30;
constexpr double distance = 8;
constexpr double offset = 0.01;

// Level ground at z = 0, and a wall at y = `distance`, 30 mm high and as good as endless.
TriangleMesh floor_and_wall()
{
    const double far = 1e4;
    return {{{-far, -far, 0},
             {far, -far, 0},
             {far, distance, 0},
             {-far, distance, 0},
             {far, distance, height},
             {-far, distance, height}},
            {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {3, 4, 5}}};
}

// Whether a ray from the origin meets the wall, by its plane.
bool meets_wall(const Vec3& direction)
{
    return direction.y() > 0 &&
           offset + direction.z() * distance / direction.y() <= height;
}

// Beside a wall the eroded cone is that of all cells, tested one by one against the plane of the
// wall.
TEST(ContactCones, AreThoseOfBruteForceBesideAWall)
{
    const TriangleMesh mesh = floor_and_wall();
    const ContactCones cones{mesh, offset};
    const CutterContact contact{{0, 0, 0}, Vec3::UnitZ()};
    const double lean = Angle::degrees(60).radians();
    const ContactCones::Hidden hidden = cones.hidden(contact, lean);
    const SphereGrid grid = sphere_grid("hex:10");
    const double near = std::cos(cones.cell_radius());
    test::Random random{7};
    int seen = 0;
    int tests = 0;
    while (tests < 400) {
        const Vec3 axis =
            Vec3{random.uniform(-1, 1), random.uniform(-1, 1), 1}.normalized();
        if (std::acos(axis.z()) > lean)
            continue;
        bool is_hidden = false;
        for (const Vec3& centre : grid.centres)
            is_hidden = is_hidden || (centre.dot(axis) > near &&
                                      (centre.z() <= 0 || meets_wall(centre)));
        EXPECT_EQ(cones.is_seen(hidden, axis), !is_hidden);
        // an axis that is seen is not in the wall
        if (!is_hidden) {
            EXPECT_FALSE(meets_wall(axis));
        }
        seen += is_hidden ? 0 : 1;
        ++tests;
    }
    EXPECT_GT(seen, 50);
    EXPECT_LT(seen, 350);
}

// Below a wide roof a contact is seen from one side only.
TEST(ContactCones, OfAContactBelowARoofSeeItsOpenSide)
{
    const TriangleMesh mesh{{{-50, -50, 0},
                             {50, -50, 0},
                             {50, 50, 0},
                             {-50, 50, 0},
                             {-50, -2, 10},
                             {50, -2, 10},
                             {50, 50, 10},
                             {-50, 50, 10}},
                            {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}}};
    const ContactCones cones{mesh, offset};
    const CutterContact contact{{0, 0, 0}, Vec3::UnitZ()};
    const auto hidden = cones.hidden(contact, Angle::degrees(60).radians());
    const auto leaning = [](double degrees) {
        const double angle = degrees * std::numbers::pi / 180;
        return Vec3{0, -std::sin(angle), std::cos(angle)};
    };
    // the border of the roof is at atan(2 / 10) = 11.3 degrees from the normal
    const double radius = Angle::radians(cones.cell_radius()).degrees();
    EXPECT_FALSE(cones.is_seen(hidden, leaning(0)));
    EXPECT_FALSE(cones.is_seen(hidden, leaning(11)));
    EXPECT_TRUE(cones.is_seen(hidden, leaning(12 + radius)));
    EXPECT_TRUE(cones.is_seen(hidden, leaning(45)));
}

TEST(ContactCones, AreWholeOnAPlane)
{
    const TriangleMesh mesh{{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}, {{0, 1, 2}}};
    const ContactCones cones{mesh, offset};
    EXPECT_TRUE(cones
                    .hidden({{0, 0, 0}, Vec3::UnitZ()},
                            std::numbers::pi / 2 - 1.01 * cones.cell_radius())
                    .empty());
    EXPECT_THROW((ContactCones{mesh, 0}), DomainError);
}

}  // namespace
}  // namespace endmill
