// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/shadow_raster.h"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "endmill/visibility/detail/ray_blocking.h"
#include "endmill/visibility/sphere_grid.h"
#include "random.h"
#include "teapot.h"
#include "test_meshes.h"

namespace endmill {
namespace {

std::vector<std::uint64_t> all_of(const TriangleMesh& part, const PartFacets& facets)
{
    std::vector<std::uint64_t> column((part.triangles().size() + 63) / 64);
    for (std::size_t facet = 0; facet < part.triangles().size(); ++facet)
        if (facets.has_area(facet))
            column[facet / 64] |= std::uint64_t{1} << (facet % 64);
    return column;
}

bool is_blocked(const TriangleMesh& part, const PartFacets& facets, std::size_t facet,
                const Vec3& direction)
{
    for (std::size_t other = 0; other < part.triangles().size(); ++other)
        if (other != facet && facets.has_area(other) &&
            blocks_ray(part.corners(facet), direction, part.corners(other)))
            return true;
    return false;
}

// Compares the raster with exact tests of all pairs of facets, for all facets and
// directions.
void expect_same_shadows(const TriangleMesh& part, const std::vector<Vec3>& directions)
{
    const PartFacets facets = part_facets(part);
    const FacetGroups groups = facet_groups(part, facets);
    ShadowRaster raster{part, groups};
    int disagreements = 0;
    for (const Vec3& direction : directions) {
        std::vector<std::uint64_t> column = all_of(part, facets);
        raster.clear_blocked(direction, column);
        for (std::size_t facet = 0; facet < part.triangles().size(); ++facet) {
            const bool is_free = (column[facet / 64] >> (facet % 64) & 1) != 0;
            const bool expected =
                facets.has_area(facet) && !is_blocked(part, facets, facet, direction);
            disagreements += is_free != expected;
        }
    }
    EXPECT_EQ(disagreements, 0);
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
