// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/polygon_fan.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "random.h"

namespace endmill {
namespace {

using Polygon = std::vector<Vec3>;

Vec3 triangle_area(const Vec3& a, const Vec3& b, const Vec3& c)
{
    return (b - a).cross(c - a) / 2;
}

// Area by the shoelace formula, projected along z.
double signed_area(const Polygon& polygon)
{
    double area = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3& a = polygon[i];
        const Vec3& b = polygon[(i + 1) % polygon.size()];
        area += (a.x() * b.y() - b.x() * a.y()) / 2;
    }
    return area;
}

TEST(FanCorner, IsTheFirstOfAConvexPolygon)
{
    EXPECT_EQ(fan_corner(Polygon{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), 0U);
    Polygon circle;
    for (int i = 0; i < 50; ++i)
        circle.emplace_back(std::cos(i * std::numbers::pi / 25), 3,
                            std::sin(i * std::numbers::pi / 25));
    EXPECT_EQ(fan_corner(circle), 0U);
}

// A quadrangle with a reflex corner is covered only from that corner or the opposite one.
TEST(FanCorner, AvoidsTheDiagonalOutsideAQuadrangle)
{
    EXPECT_EQ(fan_corner(Polygon{{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {1, 3, 0}}), 1U);
    EXPECT_EQ(fan_corner(Polygon{{1, 1, 0}, {2, 0, 0}, {1, 3, 0}, {0, 0, 0}}), 0U);
}

TEST(FanCorner, AvoidsTrianglesWithoutAnAreaWhereItCan)
{
    EXPECT_EQ(fan_corner(Polygon{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 2, 0}}), 1U);
    const Polygon pole{{0, 0, 1}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_EQ(fan_corner(pole), 0U);
    const Polygon line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
    EXPECT_EQ(fan_corner(line), 0U);
}

TEST(FanCorner, DoesNotExistForPolygonsThatAreFoldedOrFarFromConvex)
{
    const Polygon bow_tie{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_EQ(fan_corner(bow_tie), std::nullopt);
    const Polygon comb{{0, 0, 0}, {5, 0, 0}, {5, 3, 0}, {4, 3, 0}, {4, 1, 0}, {3, 1, 0},
                       {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
    EXPECT_EQ(fan_corner(comb), std::nullopt);
}

// The triangles of a fan cover the polygon once if all areas are positive and sum to the
// area of the polygon.
TEST(FanCorner, TheFanCoversAStarShapedPolygonOnce)
{
    test::Random random{7};
    int found = 0;
    for (int trial = 0; trial < 200; ++trial) {
        Polygon polygon;
        const int corners = 4 + trial % 5;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2 * std::numbers::pi * i / corners;
            const double radius = random.uniform(0.5, 2);
            polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
        }
        const auto hub = fan_corner(polygon);
        found += hub ? 1 : 0;
        double covered = 0;
        for (int i = 2; hub && i < corners; ++i) {
            const double area =
                triangle_area(polygon[*hub], polygon[(*hub + i - 1) % corners],
                              polygon[(*hub + i) % corners])
                    .z();
            EXPECT_GT(area, 0);
            covered += area;
        }
        EXPECT_NEAR(covered, hub ? signed_area(polygon) : 0, 1e-12);
        EXPECT_TRUE(hub || corners > 4);  // every quadrangle has such a diagonal
    }
    EXPECT_GT(found, 100);
}

TEST(FanCorner, TakesTimeInProportionToThePolygon)
{
    Polygon zigzag;
    for (int i = 0; i < 200000; ++i)
        zigzag.emplace_back(i, i % 2, 0);
    for (int i = 200000; i-- > 0;)
        zigzag.emplace_back(i, 10 + i % 2, 0);
    EXPECT_EQ(fan_corner(zigzag), std::nullopt);
}

TEST(OutOfPlane, IsHalfTheHeightOfASkewSquare)
{
    for (const double height : {0.0, 0.5, 3.0})
        EXPECT_NEAR(
            out_of_plane(Polygon{{0, 0, 0}, {1, 0, height}, {1, 1, 0}, {0, 1, height}}),
            height / 2, 1e-15);
    EXPECT_EQ(out_of_plane(Polygon{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), 0);
}

}  // namespace
}  // namespace endmill
