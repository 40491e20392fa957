// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/setup_regions.h"

#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "test_meshes.h"

namespace endmill {
namespace {

using test::box_mesh;
using test::points_of;
using test::torus_mesh;
using testing::ElementsAre;
using testing::IsEmpty;

Vec3 unit(double x, double y, double z)
{
    return Vec3{x, y, z}.normalized();
}

Vec3 normal_of(const TriangleMesh& mesh, std::size_t facet)
{
    const auto [a, b, c] = mesh.corners(facet);
    return (b - a).cross(c - a).normalized();
}

// Whether a ray meets a triangle, by the signs of three volumes.
bool meets(const Vec3& from, const Vec3& direction, const std::array<Vec3, 3>& at)
{
    const Vec3 normal = (at[1] - at[0]).cross(at[2] - at[0]);
    const double rise = normal.dot(direction);
    if (std::abs(rise) < 1e-12 || normal.dot(at[0] - from) / rise <= 1e-9)
        return false;
    const auto side = [&](int k) {
        return (at[k] - from).cross(at[(k + 1) % 3] - from).dot(direction);
    };
    return (side(0) > 0) == (side(1) > 0) && (side(1) > 0) == (side(2) > 0);
}

// The direction of the largest n . v without an obstacle, by trying all facets.
std::optional<std::size_t> direction_by_brute_force(const TriangleMesh& mesh,
                                                    std::size_t facet,
                                                    const std::vector<Vec3>& directions)
{
    const auto [a, b, c] = mesh.corners(facet);
    std::optional<std::size_t> best;
    double most = 1e-6;
    for (std::size_t k = 0; k < directions.size(); ++k) {
        const double product = normal_of(mesh, facet).dot(directions[k]);
        bool is_hidden = false;
        for (std::size_t other = 0; other < mesh.triangles().size(); ++other)
            is_hidden =
                is_hidden || (other != facet &&
                              meets((a + b + c) / 3, directions[k], mesh.corners(other)));
        if (!is_hidden && product > most) {
            best = k;
            most = product;
        }
    }
    return best;
}

TEST(SetupRegions, AreThoseOfBruteForce)
{
    const TriangleMesh torus = torus_mesh(20, 12);
    const std::vector<Vec3> directions{unit(1, 0.2, 0.4), unit(-0.7, 0.8, 0.5),
                                       unit(-0.1, -0.9, 0.6)};
    // no region is smaller than the square of so small a cutter
    const SetupRegions regions =
        setup_regions(torus, directions, {.cutter_radius = 1e-6});
    std::vector<std::size_t> unseen;
    for (std::size_t facet = 0; facet < torus.triangles().size(); ++facet) {
        const auto expected = direction_by_brute_force(torus, facet, directions);
        EXPECT_EQ(regions.direction_of[facet], expected) << facet;
        if (!expected)
            unseen.push_back(facet);
    }
    EXPECT_EQ(regions.uncovered, unseen);
    EXPECT_FALSE(unseen.empty());
    EXPECT_EQ(regions.joined_regions, 0U);
}

TEST(SetupRegions, OfACubeNameItsBottom)
{
    const TriangleMesh cube = box_mesh({0, 0, 0}, {20, 20, 20});
    const std::vector<Vec3> directions{unit(1, 1, 1), unit(-1, -1, 1)};
    const SetupRegions regions = setup_regions(cube, directions, {.cutter_radius = 5});
    std::vector<std::size_t> bottom;
    for (std::size_t facet = 0; facet < 12; ++facet) {
        const Vec3 normal = normal_of(cube, facet);
        if (normal.z() < -0.5) {
            bottom.push_back(facet);
            continue;
        }
        // the top has equal products, and belongs to the first
        EXPECT_EQ(regions.direction_of[facet], normal.x() + normal.y() < -0.5 ? 1U : 0U);
    }
    EXPECT_EQ(regions.uncovered, bottom);
    EXPECT_EQ(regions.facets_of(0).size(), 6U);
    EXPECT_EQ(regions.facets_of(1).size(), 4U);
    const SetupRegions without = setup_regions(
        cube, directions, {.cutter_radius = 5, .skipped = std::span{bottom}});
    EXPECT_THAT(without.uncovered, IsEmpty());
    EXPECT_FALSE(without.direction_of[bottom.front()]);
}

// A roof of two planes, whose ridge is cut off: a narrow strip that faces up.
TriangleMesh roof(double half_ridge)
{
    std::vector<Vec3> points;
    for (const double y : {0.0, 40.0})
        for (const auto& [x, z] : {std::pair{-20.0, 0.0}, std::pair{-half_ridge, 20.0},
                                   std::pair{half_ridge, 20.0}, std::pair{20.0, 0.0}})
            points.emplace_back(x, y, z);
    return {std::move(points),
            {{0, 1, 4}, {1, 5, 4}, {1, 2, 5}, {2, 6, 5}, {2, 3, 6}, {3, 7, 6}}};
}

TEST(SetupRegions, JoinANeighbourIfTheyAreSmall)
{
    TriangleMesh mesh = roof(1);
    // outwards is up
    if (normal_of(mesh, 2).z() < 0) {
        std::vector<Triangle> turned;
        for (const auto& [a, b, c] : mesh.triangles())
            turned.push_back({a, c, b});
        mesh = {points_of(mesh), turned};
    }
    const std::vector<Vec3> directions{unit(-1, 0, 1), unit(0, 0, 1), unit(1, 0, 0.9)};
    // the ridge has 80 mm2
    const SetupRegions apart = setup_regions(mesh, directions, {.cutter_radius = 4.4});
    EXPECT_EQ(apart.direction_of[2], 1U);
    EXPECT_EQ(apart.joined_regions, 0U);
    const SetupRegions joined = setup_regions(mesh, directions, {.cutter_radius = 4.5});
    EXPECT_EQ(joined.joined_regions, 1U);
    // both borders are equally long: the first direction
    EXPECT_THAT(joined.facets_of(0), ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(joined.facets_of(1), IsEmpty());
    // the neighbours do not see it
    const std::vector<Vec3> low{unit(-1, 0, -0.5), unit(0, 0, 1), unit(1, 0, -0.5)};
    const SetupRegions barred = setup_regions(mesh, low, {.cutter_radius = 4.5});
    EXPECT_EQ(barred.joined_regions, 0U);
    EXPECT_EQ(barred.direction_of[2], 1U);
}

TEST(SetupRegions, NeedDirectionsAndFacetsOfThePart)
{
    const TriangleMesh cube = box_mesh({0, 0, 0}, {1, 1, 1});
    const std::vector<Vec3> up{Vec3::UnitZ()};
    const std::vector<std::size_t> beyond{12};
    EXPECT_THROW(setup_regions(cube, {}, {}), DomainError);
    EXPECT_THROW(setup_regions(cube, up, {.cutter_radius = 0}), DomainError);
    EXPECT_THROW(setup_regions(cube, std::vector<Vec3>{{0, 0, 2}}, {}), DomainError);
    EXPECT_THROW(setup_regions(cube, up, {.skipped = std::span{beyond}}), DomainError);
}

}  // namespace
}  // namespace endmill
