// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/shadow_raster.h"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/tolerance.h"
#include "endmill/visibility/detail/ray_blocking.h"
#include "endmill/visibility/sphere_grid.h"
#include "random.h"
#include "teapot.h"
#include "test_meshes.h"

namespace endmill {
namespace {

bool is_blocked(const TriangleMesh& part, const PartFacets& facets, std::size_t facet,
                const Vec3& direction)
{
    for (std::size_t other = 0; other < part.triangles().size(); ++other)
        if (other != facet && facets.has_area(other) &&
            blocks_ray(part.corners(facet), direction, part.corners(other)))
            return true;
    return false;
}

// Compares the raster with exact tests of all pairs of facets, for all facets in question
// and all directions. Each direction comes twice, because the raster knows more about the
// facets the second time.
void expect_same_shadows(const TriangleMesh& part, const std::vector<Vec3>& directions)
{
    const PartFacets facets = part_facets(part);
    std::vector<std::vector<bool>> is_hidden;
    for (const Vec3& direction : directions) {
        std::vector<bool>& here = is_hidden.emplace_back();
        for (std::size_t facet = 0; facet < part.triangles().size(); ++facet)
            here.push_back(!facets.has_area(facet) ||
                           is_blocked(part, facets, facet, direction));
    }
    const FacetGroups groups = facet_groups(part, facets);
    for (const double least : {-2.0, least_facing_cosine, 0.5}) {
        ShadowRaster raster{part, facets, groups, BorderWalls{part}};
        int disagreements = 0;
        for (std::size_t k = 0; k < 2 * directions.size(); ++k) {
            const Vec3& direction = directions[k % directions.size()];
            std::vector<std::uint64_t> column((part.triangles().size() + 63) / 64);
            raster.mark_seen(direction, least, column);
            for (std::size_t facet = 0; facet < part.triangles().size(); ++facet) {
                const bool is_seen = (column[facet / 64] >> (facet % 64) & 1) != 0;
                const bool expected = !is_hidden[k % directions.size()][facet] &&
                                      facets.normals[facet].dot(direction) > least;
                disagreements += is_seen != expected;
            }
        }
        EXPECT_EQ(disagreements, 0);
    }
}

std::vector<Vec3> some_directions()
{
    std::vector<Vec3> directions = sphere_grid("hex:1").centres;
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0})
            directions.emplace_back(sign * Vec3::Unit(axis));
    directions.emplace_back(Vec3{1, 1, 0}.normalized());
    directions.emplace_back(Vec3{0.6, 0, 0.8});
    return directions;
}

template <typename Next>
TriangleMesh soup(int count, double size, const Next& next)
{
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    for (int k = 0; k < count; ++k) {
        const Vec3 middle{next(), next(), next()};
        for (int corner = 0; corner < 3; ++corner)
            points.emplace_back(middle + size * Vec3{next(), next(), next()});
        triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
    }
    return {std::move(points), std::move(triangles)};
}

TEST(ShadowRaster, FindsTheShadowsOfRandomTriangles)
{
    test::Random random{5};
    const auto next = [&] { return random.uniform(-1, 1); };
    for (const double size : {1.0, 0.2, 0.01})
        expect_same_shadows(soup(300, size, next), some_directions());
}

TEST(ShadowRaster, FindsTheShadowsOfTrianglesThatTouchAndShareTheirPlanes)
{
    test::Random random{6};
    const auto next = [&] { return std::round(random.uniform(-3, 3)); };
    expect_same_shadows(soup(300, 1, next), some_directions());
}

TEST(ShadowRaster, FindsTheShadowsOfNeedles)
{
    test::Random random{7};
    const auto next = [&] {
        const double value = random.uniform(-1, 1);
        return std::copysign(std::pow(std::abs(value), 12.0), value);
    };
    expect_same_shadows(soup(300, 1, next), some_directions());
}

TEST(ShadowRaster, FindsTheShadowsOfParts)
{
    expect_same_shadows(test::teapot(), some_directions());
    expect_same_shadows(test::torus_mesh(20, 12), some_directions());
    expect_same_shadows(test::flat_mesh(9, 9), some_directions());
    expect_same_shadows(test::box_mesh({0, 0, 0}, {1, 2, 3}), some_directions());
    expect_same_shadows({}, some_directions());
}

// A wave with a border: rays pass over the border and below it.
TriangleMesh wave(double slope)
{
    return test::grid_mesh(18, 17, [&](int i, int j) {
        return Vec3{double(i), double(j),
                    0.8 * std::sin(1.1 * i) * std::cos(0.9 * j) + slope * i};
    });
}

template <typename Choose>
TriangleMesh without(const TriangleMesh& mesh, const Choose& choose)
{
    std::vector<Triangle> triangles;
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k)
        if (!choose(k))
            triangles.push_back(mesh.triangles()[k]);
    return {test::points_of(mesh), std::move(triangles)};
}

TriangleMesh apart(const TriangleMesh& mesh)
{
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k) {
        for (const Vec3& corner : mesh.corners(k))
            points.push_back(corner);
        const auto last = static_cast<std::int32_t>(points.size()) - 1;
        triangles.push_back({last - 2, last - 1, last});
    }
    return {std::move(points), std::move(triangles)};
}

TEST(ShadowRaster, FindsTheShadowsOfOpenParts)
{
    expect_same_shadows(wave(0), some_directions());
    expect_same_shadows(wave(0.7), some_directions());
    const TriangleMesh torus = test::torus_mesh(20, 12);
    expect_same_shadows(without(torus, [](std::size_t k) { return k < 9; }),
                        some_directions());
    // A tube has two borders.
    expect_same_shadows(without(torus, [](std::size_t k) { return k < 96; }),
                        some_directions());
    // No facet shares a point with another.
    expect_same_shadows(apart(wave(0.3)), some_directions());
}

TEST(ShadowRaster, FindsTheShadowsOfPartsThatBoundNoSimpleSolid)
{
    const TriangleMesh torus = test::torus_mesh(20, 12);
    const auto all = [](std::size_t) { return true; };
    const TriangleMesh inside_out = test::with_turned(torus, all);
    expect_same_shadows(inside_out, some_directions());
    expect_same_shadows(test::both(torus, test::box_mesh({0, 0, -1}, {20, 3, 1})),
                        some_directions());
    const TriangleMesh around = test::box_mesh({-30, -30, -30}, {30, 30, 30});
    expect_same_shadows(test::both(around, torus), some_directions());
    expect_same_shadows(test::both(around, inside_out), some_directions());
    expect_same_shadows(
        test::with_turned(torus, [](std::size_t k) { return k % 67 == 0; }),
        some_directions());
}

// A facet sees nothing along the first direction, so that it lies outside. Along the second,
// its ray enters the solid above it through a sliver, whose sides are parallel up to
// rounding, and leaves it through a facet that faces the viewer.
TEST(ShadowRaster, CastsTheShadowsOfSlivers)
{
    constexpr double step = 0x1p-50;
    const std::vector<Vec3> points{{0, 0, 0},
                                   {1, 1, 0},
                                   {7, 7 + step, 0},
                                   {8, 0, 0},
                                   {0, 8, 0},
                                   {3, 4, 3},
                                   {5, 0.5 + 1.625 * step, -5},
                                   {6, 6, -5},
                                   {1, 5.5, -5},
                                   {4, 4, -9}};
    const TriangleMesh part{points,
                            {{0, 2, 1},
                             {0, 1, 3},
                             {3, 1, 2},
                             {0, 4, 2},
                             {0, 3, 5},
                             {3, 2, 5},
                             {2, 4, 5},
                             {4, 0, 5},
                             {6, 7, 8},
                             {7, 6, 9},
                             {8, 7, 9},
                             {6, 8, 9}}};
    ASSERT_TRUE(part_facets(part).dropped.empty());
    ASSERT_EQ(BorderWalls{part}.count(), 0U);
    expect_same_shadows(
        part, {Vec3{0.8, 0, 0.6}, Vec3::UnitZ(), Vec3{0, 0.8, 0.6}, -Vec3::UnitZ()});
}

TEST(ShadowRaster, IsExactForAnyPositionAndSizeOfThePart)
{
    const TriangleMesh torus = test::torus_mesh(6, 4);
    for (const auto& [size, shift] :
         {std::pair{1.0, 1e5}, {1.0, 1e9}, {1e-30, 0.0}, {1e-3, 1e9}, {1e30, 0.0}}) {
        std::vector<Vec3> points = test::points_of(torus);
        for (Vec3& point : points)
            point = size * point + Vec3::Constant(shift);
        expect_same_shadows({std::move(points), test::triangles_of(torus)},
                            some_directions());
    }
}

}  // namespace
}  // namespace endmill
