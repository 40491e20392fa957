// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/detail/region_mesh.h"

#include <numeric>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "test_meshes.h"

namespace endmill {
namespace {

using test::box_mesh;
using test::flat_mesh;

double area_of(const TriangleMesh& mesh)
{
    double area = 0;
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k) {
        const auto [a, b, c] = mesh.corners(k);
        area += (b - a).cross(c - a).norm() / 2;
    }
    return area;
}

double greatest_x(const TriangleMesh& mesh)
{
    double x = -1e9;
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k)
        for (const Vec3& corner : mesh.corners(k))
            x = std::max(x, corner.x());
    return x;
}

bool any_facet(std::size_t)
{
    return true;
}

// Two triangles of a square of 10 mm that share the diagonal.
TriangleMesh square()
{
    return {{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

TEST(RegionMesh, CutsAWideFacetAsFarAsTheStrip)
{
    const std::vector<std::size_t> first{0};
    // a strip along the diagonal: the triangle beyond it less a smaller one
    const double diagonal = 10 * std::sqrt(2.0);
    const double height = diagonal / 2;
    for (const double width : {0.5, 2.0, 7.0}) {
        const double rest = 50 * (1 - width / height) * (1 - width / height);
        EXPECT_NEAR(area_of(region_mesh(square(), first, {width, any_facet})), 100 - rest,
                    1e-12);
    }
    EXPECT_NEAR(area_of(region_mesh(square(), first, {7.1, any_facet})), 100, 1e-12);
    EXPECT_NEAR(area_of(region_mesh(square(), first, {0, any_facet})), 50, 1e-12);
}

TEST(RegionMesh, ReachesAcrossManyFacets)
{
    const TriangleMesh grid = flat_mesh(40, 10);
    std::vector<std::size_t> facets;
    for (std::size_t facet = 0; facet < grid.triangles().size(); ++facet) {
        const auto [a, b, c] = grid.corners(facet);
        if (std::max({a.x(), b.x(), c.x()}) <= 10)
            facets.push_back(facet);
    }
    for (const double width : {0.3, 5.5}) {
        const TriangleMesh wide = region_mesh(grid, facets, {width, any_facet});
        EXPECT_GE(greatest_x(wide), 10 + width - 1e-12);
        EXPECT_LE(greatest_x(wide), 10 + 2 * width + 1);
        for (std::size_t k = 0; k < wide.triangles().size(); ++k) {
            const auto [a, b, c] = wide.corners(k);
            EXPECT_GT((b - a).cross(c - a).z(), 0);
        }
    }
}

TEST(RegionMesh, EndsAtSharpEdgesAndBarredFacets)
{
    const TriangleMesh box = box_mesh({0, 0, 0}, {10, 10, 10});
    std::vector<std::size_t> top;
    for (std::size_t facet = 0; facet < 12; ++facet) {
        const auto [a, b, c] = box.corners(facet);
        if (a.z() + b.z() + c.z() == 30)
            top.push_back(facet);
    }
    EXPECT_NEAR(area_of(region_mesh(box, top, {3, any_facet})), 100, 1e-12);
    const std::vector<std::size_t> first{0};
    EXPECT_NEAR(
        area_of(region_mesh(square(), first, {3, [](std::size_t) { return false; }})), 50,
        1e-12);
    EXPECT_THROW(region_mesh(square(), first, {-1, any_facet}), DomainError);
}

}  // namespace
}  // namespace endmill
