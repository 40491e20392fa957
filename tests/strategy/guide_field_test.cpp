// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/guide_field.h"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "endmill/strategy/detail/covered_part.h"
#include "endmill/surface/tool_side.h"
#include "test_meshes.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr double radius = 5;
constexpr double height = 0.1;

struct Guided {
    std::vector<Surface> surfaces;
    std::vector<double> sides;
    PartSamples samples;
    std::vector<double> values;

    Guided(const Surface& surface, TravelKind distance)
        : surfaces{surface},
          sides{tool_side_signs(surfaces, Vec3::UnitZ())},
          samples{surfaces, sides, 1, 100'000},
          values{guide_field(samples, BallCutter{radius}, height, distance)}
    {
    }

    // Difference of the values per mm between two samples.
    double slope(std::int32_t a, std::int32_t b) const
    {
        return std::abs(values[b] - values[a]) /
               (samples.point(b) - samples.point(a)).norm();
    }

    // Greatest change of the values along lines of constant x or y, per mm.
    double greatest_slope(int along) const
    {
        double greatest = 0;
        for (const Triangle& triangle : samples.triangles())
            for (int k = 0; k < 3; ++k) {
                const std::int32_t a = triangle[k];
                const std::int32_t b = triangle[(k + 1) % 3];
                const Vec3 way = samples.point(b) - samples.point(a);
                if (std::abs(way[1 - along]) < 1e-9 * way.norm())
                    greatest = std::max(greatest, slope(a, b));
            }
        return greatest;
    }
};

// A hill z = -x^2 / 2b: k = 1 / b across x at the top, convex.
const Surface hill = test::parabolic_cylinder(-1.0 / 20, 6, 30);

TEST(GuideField, HasUnitSlopeOnAPlane)
{
    const Guided plane{test::plane(30, 20), TravelKind::Contact};
    double sum = 0;
    double area = 0;
    for (const Triangle& t : plane.samples.triangles()) {
        const Vec3 side = plane.samples.point(t[1]) - plane.samples.point(t[0]);
        const Vec3 other = plane.samples.point(t[2]) - plane.samples.point(t[0]);
        Eigen::Matrix2d sides;
        sides << side.x(), side.y(), other.x(), other.y();
        const Eigen::Vector2d rise{plane.values[t[1]] - plane.values[t[0]],
                                   plane.values[t[2]] - plane.values[t[0]]};
        const double weight = std::abs(sides.determinant());
        sum += weight * (sides.inverse() * rise).norm();
        area += weight;
    }
    EXPECT_NEAR(sum / area, 1, 1e-6);
}

// Contact travel is shortest around the hill, along x: f rises along y, where the strip is
// as wide as on a plane.
TEST(GuideField, LeadsContactsAroundAConvexCylinder)
{
    const Guided guided{hill, TravelKind::Contact};
    EXPECT_LT(guided.greatest_slope(0), 0.05);
    EXPECT_NEAR(guided.greatest_slope(1), 1, 0.05);
}

// Tip travel is shortest along the hill. The strip is narrower than on a plane by
// sqrt(1 + R k), so that f rises by that factor along x at the top.
TEST(GuideField, LeadsTipsAlongAConvexCylinder)
{
    const Guided guided{hill, TravelKind::Tip};
    EXPECT_LT(guided.greatest_slope(1), 0.05);
    EXPECT_NEAR(guided.greatest_slope(0), std::sqrt(1 + radius / 20), 0.05);
}

TEST(GuideField, ScalesWithLength)
{
    const Surface small = test::saddle(60, 20);
    const Surface large = test::saddle(120, 40);
    const auto values = [](const Surface& surface, double scale) {
        const std::vector<Surface> surfaces{surface};
        const std::vector<double> sides = tool_side_signs(surfaces, Vec3::UnitZ());
        const PartSamples samples{surfaces, sides, 2 * scale, 100'000};
        return guide_field(samples, BallCutter{radius * scale}, height * scale,
                           TravelKind::Contact);
    };
    const std::vector<double> one = values(small, 1);
    const std::vector<double> two = values(large, 2);
    ASSERT_EQ(one.size(), two.size());
    for (std::size_t i = 0; i < one.size(); ++i)
        EXPECT_NEAR(two[i], 2 * one[i], 1e-6 * 40);
}

// The samples on both sides of an edge of a mesh are joined by triangles without area, which
// are divided where the ball does not reach the edge.
TEST(GuideField, IsContinuousAcrossEdgesOfAMesh)
{
    const Part part{test::grid_mesh(4, 3, [](double i, double j) {
        return Vec3{6 * i, 6 * j, (i == 2 ? -2.0 : 0.0) + (j == 1 ? 0.4 : 0.0)};
    })};
    const CoveredPart covered{part, BallCutter{radius}, {0.01, height}};
    const PartSamples samples = covered.samples(1, 100'000);
    ASSERT_GT(samples.unwanted_area(), 0);
    const std::vector<double> values =
        guide_field(samples, BallCutter{radius}, height, TravelKind::Contact);
    int joined = 0;
    for (const auto& [a, b, c] : samples.triangles())
        for (const auto& [from, to] :
             {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
            ASSERT_TRUE(std::isfinite(values[from]));
            if (samples.point(from) != samples.point(to))
                continue;
            ++joined;
            ASSERT_EQ(values[from], values[to]);
        }
    EXPECT_GT(joined, 100);
}

}  // namespace
}  // namespace endmill
