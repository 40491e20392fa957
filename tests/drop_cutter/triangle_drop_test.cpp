// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/triangle_drop.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

using Corners = std::array<Vec3, 3>;
using Real = long double;

const std::array cutters{Cutter::ball(5), Cutter::flat(5), Cutter{5, 2}, Cutter{5, 0.1},
                         Cutter{5, 4.9}};

constexpr double promised = 1e-9;  // mm

// The tip that a point of the triangle allows. Beyond the rim it is continued so steeply
// that no triangle of the test compensates it, and such that it stays concave.
Real lifted_tip(const Cutter& cutter, Real x, Real y, Real z)
{
    const Real R = cutter.radius();
    const Real r = cutter.corner_radius();
    const Real distance = std::hypot(x, y);
    const Real a = std::clamp<Real>(distance - (R - r), 0, r);
    const Real beyond = std::max<Real>(0, distance - R);
    return z - (r - std::sqrt((r - a) * (r + a))) - 1e9L * beyond;
}

template <typename Function>
Real greatest(const Function& function)
{
    const Real golden = std::numbers::phi_v<Real> - 1;
    Real low = 0;
    Real high = 1;
    Real a = high - golden;
    Real b = low + golden;
    Real at_a = function(a);
    Real at_b = function(b);
    for (int k = 0; k < 90; ++k) {
        if (at_a < at_b) {
            low = a;
            a = b;
            at_a = at_b;
            b = low + golden * (high - low);
            at_b = function(b);
        } else {
            high = b;
            b = a;
            at_b = at_a;
            a = high - golden * (high - low);
            at_a = function(a);
        }
    }
    return std::max({at_a, at_b, function(0), function(1)});
}

// Second route: a search for the maximum over the whole triangle, without facets and
// sides.
Real searched_tip(const Cutter& cutter, const Corners& corners, double x, double y)
{
    const auto tip_at = [&](Real u, Real v) {
        std::array<Real, 3> p;
        for (int k = 0; k < 3; ++k)
            p[k] = (1 - u) * Real{corners[0][k]} +
                   u * ((1 - v) * Real{corners[1][k]} + v * Real{corners[2][k]});
        return lifted_tip(cutter, p[0] - Real{x}, p[1] - Real{y}, p[2]);
    };
    return greatest(
        [&](Real u) { return greatest([&](Real v) { return tip_at(u, v); }); });
}

bool is_in_reach(const Cutter& cutter, Real tip, const Corners& corners)
{
    double lowest = corners[0].z();
    for (const Vec3& corner : corners)
        lowest = std::min(lowest, corner.z());
    return tip >= lowest - cutter.radius();
}

Corners random_corners(test::Random& random, double size, double height)
{
    Corners corners;
    for (Vec3& corner : corners)
        corner = {random.uniform(-size, size), random.uniform(-size, size),
                  random.uniform(-height, height)};
    return corners;
}

void expect_searched(const Corners& corners, double x, double y)
{
    for (const Cutter& cutter : cutters) {
        const TriangleContact found = TriangleDrop{cutter}(corners, x, y);
        const Real expected = searched_tip(cutter, corners, x, y);
        if (!is_in_reach(cutter, expected, corners)) {
            EXPECT_EQ(found.tip_z, -std::numeric_limits<double>::infinity());
            continue;
        }
        EXPECT_NEAR(found.tip_z, double(expected), promised) << cutter_word(cutter);
        const Vec3 away = found.point - Vec3{x, y, 0};
        EXPECT_NEAR(double(lifted_tip(cutter, away.x(), away.y(), away.z())), found.tip_z,
                    1e-5);  // 1e9 times the rounding of its position
    }
}

TEST(TriangleDrop, FindsTheHighestOfAllPoints)
{
    test::Random random{1};
    for (int k = 0; k < 60; ++k)
        expect_searched(random_corners(random, 8, 4), random.uniform(-4, 4),
                        random.uniform(-4, 4));
}

TEST(TriangleDrop, FindsTheHighestPointOfSmallAndOfSteepTriangles)
{
    test::Random random{2};
    for (int k = 0; k < 30; ++k) {
        const Vec3 place{random.uniform(-4, 4), random.uniform(-4, 4), 0};
        for (const double height : {0.05, 3.0, 300.0}) {
            Corners corners = random_corners(random, 0.1, height);
            for (Vec3& corner : corners)
                corner += place;
            expect_searched(corners, 0, 0);
        }
    }
}

TEST(TriangleDrop, FindsTheHighestPointOfNeedles)
{
    test::Random random{3};
    for (int k = 0; k < 30; ++k) {
        Corners corners = random_corners(random, 30, 10);
        const double width = random.log_uniform(1e-12, 1e-2);
        corners[2] = corners[0] + random.uniform(0, 1) * (corners[1] - corners[0]) +
                     width * Vec3{random.uniform(-1, 1), random.uniform(-1, 1),
                                  random.uniform(-1, 1)};
        const Vec3 near = corners[0] + random.uniform(0, 1) * (corners[1] - corners[0]);
        expect_searched(corners, near.x() + random.uniform(-3, 3),
                        near.y() + random.uniform(-3, 3));
    }
}

// On a plane z = x tan(phi): R - r down the slope, and r sin(phi) further.
TEST(TriangleDrop, TouchesASlopeWhereItsCornerIsTangent)
{
    const double big = 100;
    for (const double degrees : {0.0, 1e-6, 10.0, 45.0, 80.0, 89.9}) {
        const double phi = degrees * std::numbers::pi / 180;
        const double slope = std::tan(phi);
        const Corners corners{Vec3{-big, -big, -big * slope},
                              Vec3{big, -big, big * slope}, Vec3{0, big, 0}};
        for (const Cutter& cutter : cutters) {
            const double r = cutter.corner_radius();
            const double c = cutter.flat_radius();
            const double tip = 2 * slope + c * slope + r * (1 / std::cos(phi) - 1);
            const TriangleContact found = TriangleDrop{cutter}(corners, 2, -3);
            EXPECT_NEAR(found.tip_z, tip, 1e-9) << degrees;
            EXPECT_EQ(found.kind, TouchKind::Facet);
            if (degrees > 1e-6) {
                EXPECT_NEAR(found.point.x(), 2 + c + r * std::sin(phi), 1e-9);
                EXPECT_NEAR(found.point.y(), -3, 1e-9);
            }
        }
    }
}

// A level ridge at a distance e: the profile of the cutter itself.
TEST(TriangleDrop, RestsOnARidge)
{
    const Corners corners{Vec3{-50, 3, 7}, Vec3{50, 3, 7}, Vec3{0, 5, -400}};
    for (const Cutter& cutter : cutters) {
        const TriangleContact found = TriangleDrop{cutter}(corners, 0.5, 0);
        EXPECT_NEAR(found.tip_z, 7 - cutter.profile(3), 1e-14);
        EXPECT_EQ(found.kind, TouchKind::Edge);
        EXPECT_NEAR((found.point - Vec3{0.5, 3, 7}).norm(), 0, 1e-9);
    }
}

TEST(TriangleDrop, RestsOnACorner)
{
    const Corners corners{Vec3{1, 2, 7}, Vec3{1.1, 2.2, -400}, Vec3{1.3, 2.1, -400}};
    for (const Cutter& cutter : cutters) {
        const TriangleContact found = TriangleDrop{cutter}(corners, 0, 0);
        EXPECT_NEAR(found.tip_z, 7 - cutter.profile(std::sqrt(5)), 1e-14);
        EXPECT_EQ(found.kind, TouchKind::Vertex);
        EXPECT_EQ(found.point, corners[0]);
    }
}

// 3, 4 and 5 are exact: such a corner lies on the rim, which belongs to the cutter.
TEST(TriangleDrop, TouchesACornerAtItsVeryRim)
{
    const Corners corners{Vec3{3, 4, 7}, Vec3{4, 5, 7}, Vec3{3, 5, 7}};
    for (const Cutter& cutter : cutters) {
        const TriangleDrop drop{cutter};
        EXPECT_NEAR(drop(corners, 0, 0).tip_z, 7 - cutter.corner_radius(), promised);
        EXPECT_EQ(drop(corners, -1e-13, 0).tip_z,
                  -std::numeric_limits<double>::infinity());
        const double inside = 1e-13;
        const Real gap = 5 - std::hypot(Real{3} - Real{inside}, Real{4});
        const Real r = cutter.corner_radius();
        const Real root = r > 0 ? std::sqrt(gap * (2 * r - gap)) : 0;
        EXPECT_NEAR(drop(corners, inside, 0).tip_z, double(7 - r + root), promised);
    }
}

// A line of slope m at a distance e just below R: the chord below the cutter is short.
TEST(TriangleDrop, TouchesASideThatItsRimGrazes)
{
    const double m = 2;
    for (const double gap : {0.0, 1e-15, 1e-12, 1e-9, 1e-6}) {
        const double e = 5 - gap;
        const Corners corners{Vec3{-50, e, -50 * m}, Vec3{50, e, 50 * m},
                              Vec3{0, 60, -1e4}};
        const Real half = std::sqrt((5 - Real{e}) * (5 + Real{e}));
        EXPECT_NEAR(TriangleDrop{Cutter::ball(5)}(corners, 0, 0).tip_z,
                    double(half * std::sqrt(Real{5}) - 5), promised);
        EXPECT_NEAR(TriangleDrop{Cutter::flat(5)}(corners, 0, 0).tip_z, double(m * half),
                    promised);
    }
}

TEST(TriangleDrop, RestsOnAVerticalWall)
{
    const Corners wall{Vec3{-20, 4, 0}, Vec3{20, 4, 0}, Vec3{20, 4, 9}};
    expect_searched(wall, 1, 0);
    const Corners flagpole{Vec3{4, 0, 0}, Vec3{4, 0, 9}, Vec3{4, 0, 3}};
    for (const Cutter& cutter : cutters) {
        EXPECT_NEAR(TriangleDrop{cutter}(flagpole, 0, 0).tip_z, 9 - cutter.profile(4),
                    1e-14);
    }
}

TEST(TriangleDrop, TakesATriangleWithoutAreaForItsSides)
{
    const Vec3 p{1, 0, 3};
    for (const Cutter& cutter : cutters) {
        const TriangleDrop drop{cutter};
        EXPECT_NEAR(drop({p, p, p}, 0, 0).tip_z, 3 - cutter.profile(1), 1e-14);
        const Corners line{Vec3{-9, 1, 3}, Vec3{0, 1, 3}, Vec3{9, 1, 3}};
        EXPECT_NEAR(drop(line, 0, 0).tip_z, 3 - cutter.profile(1), 1e-14);
    }
}

TEST(TriangleDrop, DoesNotDependOnTheOrientationOfATriangle)
{
    test::Random random{4};
    for (int k = 0; k < 200; ++k) {
        const Corners c = random_corners(random, 6, 3);
        for (const Cutter& cutter : cutters) {
            const TriangleDrop drop{cutter};
            const double tip = drop(c, 0, 0).tip_z;
            for (const Corners& turned :
                 {Corners{c[0], c[2], c[1]}, Corners{c[1], c[2], c[0]}}) {
                const double other = drop(turned, 0, 0).tip_z;
                EXPECT_TRUE(other == tip || std::abs(other - tip) < 1e-12);
            }
        }
    }
}

// Far from the origin only the rounding of the coordinates is lost.
TEST(TriangleDrop, IsAccurateFarFromTheOrigin)
{
    test::Random random{5};
    const Vec3 far{4096, -8192, 512};  // exact, and so are sums with sixteenths
    for (int k = 0; k < 100; ++k) {
        Corners corners = random_corners(random, 6, 3);
        for (Vec3& corner : corners)
            corner = (corner * 16).array().round() / 16;
        Corners moved = corners;
        for (Vec3& corner : moved)
            corner += far;
        for (const Cutter& cutter : cutters) {
            const double here = TriangleDrop{cutter}(corners, 0.25, 0.5).tip_z;
            const double there =
                TriangleDrop{cutter}(moved, far.x() + 0.25, far.y() + 0.5).tip_z;
            EXPECT_TRUE(here + far.z() == there ||
                        std::abs(here + far.z() - there) < promised);
        }
    }
}

TEST(TriangleDrop, SkipsOnlyTrianglesBelowTheLimit)
{
    test::Random random{6};
    for (int k = 0; k < 300; ++k) {
        const Corners corners = random_corners(random, 6, 3);
        for (const Cutter& cutter : cutters) {
            const TriangleDrop drop{cutter};
            const double tip = drop(corners, 0, 0).tip_z;
            EXPECT_EQ(drop(corners, 0, 0, tip).tip_z, tip);
            EXPECT_LE(drop(corners, 0, 0, tip + 1).tip_z, tip);
        }
    }
}

}  // namespace
}  // namespace endmill
