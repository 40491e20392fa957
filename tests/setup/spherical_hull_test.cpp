// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/spherical_hull.h"

#include <algorithm>
#include <tuple>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "direction_sets.h"
#include "endmill/core/error.h"

namespace endmill {
namespace {

using test::direction;
using test::directions;
using test::Random;
using test::up;

// The same cycle, starting at its least vertex.
std::vector<Vec3> from_least(std::vector<Vec3> hull)
{
    const auto before = [](const Vec3& a, const Vec3& b) {
        return std::tie(a.x(), a.y(), a.z()) < std::tie(b.x(), b.y(), b.z());
    };
    std::rotate(hull.begin(), std::min_element(hull.begin(), hull.end(), before),
                hull.end());
    return hull;
}

bool has(const std::vector<Vec3>& hull, const Vec3& v)
{
    return std::find(hull.begin(), hull.end(), v) != hull.end();
}

// Tests whether all points lie to the left of every edge of the hull, in the plane facing
// +Z.
void expect_inside(const std::vector<Vec3>& hull, const std::vector<Vec3>& points,
                   HullProjection projection)
{
    const auto image = [projection](const Vec3& v) {
        return projection == HullProjection::Gnomonic ? Vec3{v / v.z()}
                                                      : Vec3{v.x(), v.y(), 1};
    };
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Vec3 a = image(hull[i]);
        const Vec3 edge = image(hull[(i + 1) % hull.size()]) - a;
        for (const Vec3& v : points)
            EXPECT_GE(edge.cross(image(v) - a).z(), -1e-9 * edge.norm());
    }
}

TEST(SphericalHull, IsTheSameByTheIncrementalConstruction)
{
    Random random{7};
    for (int i = 0; i < 20000; ++i) {
        const std::vector<Vec3> points = test::random_directions(random);
        const std::vector<Vec3> hull =
            spherical_hull(up, points, HullProjection::Gnomonic);
        EXPECT_EQ(from_least(incremental_hull(up, points)), from_least(hull));
    }
}

TEST(SphericalHull, HasAllDirectionsOnTheLeftOfEachEdge)
{
    Random random{8};
    for (int i = 0; i < 500; ++i) {
        std::vector<Vec3> points = test::random_directions(random);
        points.push_back(up);
        for (const HullProjection projection :
             {HullProjection::Gnomonic, HullProjection::Orthographic}) {
            const std::vector<Vec3> hull = spherical_hull(up, points, projection);
            ASSERT_GE(hull.size(), 3U);
            expect_inside(hull, points, projection);
        }
    }
}

// A rotation of all directions must not change which of them are vertices, although the
// exact signs are those of other doubles.
TEST(SphericalHull, TurnsWithItsDirections)
{
    Random random{9};
    for (int i = 0; i < 300; ++i) {
        const std::vector<Vec3> points = test::random_directions(random);
        const Eigen::Matrix3d turn =
            Eigen::AngleAxisd{random.uniform(0, 6),
                              direction({random.uniform(0, 360), random.uniform(0, 180)})}
                .toRotationMatrix();
        std::vector<Vec3> turned;
        turned.reserve(points.size());
        for (const Vec3& v : points)
            turned.push_back(turn * v);
        for (const HullProjection projection :
             {HullProjection::Gnomonic, HullProjection::Orthographic}) {
            const auto hull = spherical_hull(up, points, projection);
            const auto turned_hull = spherical_hull(turn * up, turned, projection);
            EXPECT_EQ(hull.size(), turned_hull.size());
            for (std::size_t k = 0; k < points.size(); ++k)
                EXPECT_EQ(has(hull, points[k]), has(turned_hull, turned[k]));
        }
    }
}

TEST(SphericalHull, HasTheToolAxisAsAVertexIfAllDirectionsLieOnOneSide)
{
    const auto points = directions({{0, 30}, {40, 50}, {90, 20}});
    for (const auto& hull : {spherical_hull(up, points, HullProjection::Gnomonic),
                             spherical_hull(up, points, HullProjection::Orthographic),
                             incremental_hull(up, points)}) {
        EXPECT_EQ(hull.size(), 4U);
        EXPECT_TRUE(has(hull, up));
    }
}

TEST(SphericalHull, IsALineForDirectionsOnOneGreatCircleThroughTheToolAxis)
{
    // Exactly in the plane y = 0.
    const std::vector<Vec3> points{
        {0.1, 0, 0.9}, {0.5, 0, 0.3}, {-0.3, 0, 0.7}, {0.2, 0, 1.8}};
    for (const auto& hull : {spherical_hull(up, points, HullProjection::Gnomonic),
                             incremental_hull(up, points)}) {
        ASSERT_EQ(hull.size(), 2U);
        EXPECT_TRUE(has(hull, points[1]));
        EXPECT_TRUE(has(hull, points[2]));
    }
    const std::vector<Vec3> one_side{points[0], points[1]};
    EXPECT_TRUE(has(incremental_hull(up, one_side), up));
    EXPECT_TRUE(has(spherical_hull(up, one_side, HullProjection::Gnomonic), up));
}

TEST(SphericalHull, TakesTheFartherOfCollinearDirections)
{
    // A triangle, directions on its edges, and copies of its corners.
    const std::vector<Vec3> corners{{0.5, 0, 1}, {-0.25, 0.5, 1}, {-0.25, -0.5, 1}};
    std::vector<Vec3> points = corners;
    for (std::size_t i = 0; i < 3; ++i) {
        points.push_back((corners[i] + corners[(i + 1) % 3]) / 2);
        points.push_back(corners[i] * 2);
    }
    for (const auto& hull : {spherical_hull(up, points, HullProjection::Gnomonic),
                             incremental_hull(up, points)})
        EXPECT_EQ(hull.size(), 3U);
}

TEST(SphericalHull, KeepsItsShapeWithDuplicatesOneTrillionthApart)
{
    Random random{10};
    for (int i = 0; i < 200; ++i) {
        std::vector<Vec3> points = test::random_directions(random);
        const std::size_t count = points.size();
        for (std::size_t k = 0; k < count; ++k) {
            const Vec3 shift{random.uniform(-1, 1), random.uniform(-1, 1), 0};
            points.push_back((points[k] + 1e-12 * shift).normalized());
        }
        const std::vector<Vec3> hull =
            spherical_hull(up, points, HullProjection::Gnomonic);
        EXPECT_EQ(from_least(incremental_hull(up, points)), from_least(hull));
        expect_inside(hull, points, HullProjection::Gnomonic);
    }
}

TEST(SphericalHull, IsTheToolAxisWithoutDirections)
{
    for (const auto& hull :
         {spherical_hull(up, {}, HullProjection::Gnomonic),
          spherical_hull(up, std::vector{up}, HullProjection::Orthographic),
          incremental_hull(up, {})}) {
        ASSERT_EQ(hull.size(), 1U);
        EXPECT_EQ(hull.front(), up);
    }
}

TEST(SphericalHull, NeedsAnOpenHemisphereInTheGnomonicProjectionOnly)
{
    const Vec3 equator = Vec3::UnitX();
    for (const Vec3& low : {equator, Vec3{-up}, Vec3{0.6, 0, -0.8}}) {
        const std::vector<Vec3> points{low, direction({40, 30}), direction({140, 30})};
        EXPECT_FALSE(is_in_open_hemisphere(up, points));
        EXPECT_THROW(spherical_hull(up, points, HullProjection::Gnomonic), DomainError);
        EXPECT_THROW(incremental_hull(up, points), DomainError);
        EXPECT_FALSE(spherical_hull(up, points, HullProjection::Orthographic).empty());
    }
    EXPECT_TRUE(is_in_open_hemisphere(up, std::vector<Vec3>{{1, 0, 1e-300}}));
    EXPECT_THROW(spherical_hull(Vec3::Zero(), {}, HullProjection::Orthographic),
                 DomainError);
}

TEST(SphericalHull, UsesExactlyPerpendicularVectors)
{
    Random random{11};
    for (int i = 0; i < 100; ++i) {
        const Vec3 axis = direction({random.uniform(0, 360), random.uniform(0, 180)});
        const auto found = exact_perpendiculars(axis);
        for (const Vec3& v : found)
            EXPECT_EQ(v.dot(axis), 0);
        EXPECT_GT(found[0].cross(found[1]).norm(), 0.1);
    }
}

}  // namespace
}  // namespace endmill
