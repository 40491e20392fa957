// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/visibility.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/visibility/sphere_grid.h"
#include "random.h"
#include "teapot.h"
#include "test_meshes.h"

namespace endmill {
namespace {

constexpr double degree = std::numbers::pi / 180;

std::size_t accessible(const VisibilityMap& map)
{
    std::size_t count = 0;
    for (std::size_t cell = 0; cell < map.cells(); ++cell)
        for (const std::uint64_t word : map.column(cell))
            count += std::popcount(word);
    return count;
}

struct PrintedCount {
    double incidence_deg;
    std::size_t global;
    std::size_t local;
};

class VisibilityOfTheTeapot : public testing::TestWithParam<PrintedCount> {};

TEST_P(VisibilityOfTheTeapot, HasTheAccessibleEntriesOfTheTable)
{
    const TriangleMesh part = test::teapot();
    const SphereGrid grid = sphere_grid("hex:10");
    VisibilityOptions options{.incidence = Angle::degrees(GetParam().incidence_deg)};
    const PartVisibility global = part_visibility(part, grid.centres, options);
    EXPECT_EQ(accessible(global.map), GetParam().global);
    EXPECT_TRUE(empty_cones(global).empty());
    EXPECT_TRUE(global.dropped.empty());
    options.kind = VisibilityKind::Local;
    EXPECT_EQ(accessible(part_visibility(part, grid.centres, options).map),
              GetParam().local);
}

INSTANTIATE_TEST_SUITE_P(Section82, VisibilityOfTheTeapot,
                         testing::Values(PrintedCount{90, 148240, 172800},
                                         PrintedCount{80, 124185, 142284},
                                         PrintedCount{60, 75761, 85324}));

// A facet with the centroid `centre`, the size `size` and the normal `normal`.
TriangleMesh small_facet(const Vec3& centre, const Vec3& normal, double size)
{
    const Vec3 u = size * normal.unitOrthogonal();
    const Vec3 v = normal.normalized().cross(u);
    return {{centre + u, centre - u / 2 + v, centre - u / 2 - v}, {{0, 1, 2}}};
}

TriangleMesh quadrangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    return {{a, b, c, d}, {{0, 1, 2}, {0, 2, 3}}};
}

// The side of a prism around z, from z = 0 to `height`.
TriangleMesh wall(int sides, double radius, double first_azimuth, double height)
{
    return test::grid_mesh(sides, 1, [&](int i, int j) {
        const double azimuth = first_azimuth + 2 * std::numbers::pi * (i % sides) / sides;
        return Vec3{radius * std::cos(azimuth), radius * std::sin(azimuth), j * height};
    });
}

struct ClosedForm {
    const char* name;
    TriangleMesh part;  // the cone is that of facet 0
    double fraction;
};

std::vector<ClosedForm> closed_forms()
{
    const TriangleMesh floor = small_facet({0, 0, 0}, {0, 0, 1}, 0.01);
    const auto square = [&](double half) {
        return test::both(floor, wall(4, half * std::sqrt(2), std::numbers::pi / 4, 1));
    };
    const auto ball = [&](double distance) {
        const SphereGrid sphere = sphere_grid("ico:3");
        std::vector<Vec3> points = sphere.corners;
        for (Vec3& point : points)  // inscribed triangles are 0.0016 too close on average
            point = 1.0016 * point + Vec3{distance, 0, 1};
        return test::both(floor, {std::move(points), sphere.cells});
    };
    const auto groove = [&](double half_angle_deg) {
        const double x = std::sin(half_angle_deg * degree);
        const double z = std::cos(half_angle_deg * degree);
        TriangleMesh part = small_facet({0, 0, 1e-3}, {0, 0, 1}, 1e-5);
        for (const int side : {-1, 1})
            part = test::both(part, quadrangle({0, -1e3, 0}, {0, 1e3, 0},
                                               {side * x, 1e3, z}, {side * x, -1e3, z}));
        return part;
    };
    // A facet close to the inner edge of the planes z = 0 and x = 0.
    TriangleMesh corner = small_facet({1e-4, 0, 1e-4}, {1, 0, 1}, 1e-6);
    corner = test::both(corner, quadrangle({0, -9, 0}, {9, -9, 0}, {9, 9, 0}, {0, 9, 0}));
    corner = test::both(corner, quadrangle({0, -9, 0}, {0, 9, 0}, {0, 9, 9}, {0, -9, 9}));
    return {{"square pocket, half side 1 depth 1", square(1), 1.0 / 6},
            {"square pocket, half side 2 depth 1", square(2), 0.2951672},
            {"bore", test::both(floor, wall(360, 1, 0, 2)), 0.0527864},
            {"ball at R", ball(1), 0.3535534},
            {"ball at sqrt(3) R", ball(std::sqrt(3)), 0.4330127},
            {"V-groove, 2 g = 60", groove(30), 30.0 / 180},
            {"V-groove, 2 g = 100", groove(50), 50.0 / 180},
            {"inner edge", corner, 0.25}};
}

// The part is turned so that no plane of symmetry of a grid touches the border of a cone.
TriangleMesh turned(const TriangleMesh& part)
{
    const Eigen::AngleAxisd turn{0.4, Vec3{1, 2, 3}.normalized()};
    std::vector<Vec3> points = test::points_of(part);
    for (Vec3& point : points)
        point = turn * point;
    return {std::move(points), test::triangles_of(part)};
}

TEST(PartVisibility, HasTheConesOfClosedForms)
{
    struct Grid {
        const char* name;
        double tolerance;
    };
    for (const Grid& each :
         {Grid{"hex:10", 0.008}, {"cube:10", 0.008}, {"ico:4", 0.003}}) {
        const SphereGrid grid = sphere_grid(each.name);
        for (const ClosedForm& form : closed_forms()) {
            const PartVisibility visibility =
                part_visibility(turned(form.part), grid.centres);
            const double fraction =
                visible_fractions(visibility.map, grid.solid_angles_sr)[0];
            EXPECT_NEAR(fraction, form.fraction, each.tolerance)
                << form.name << ", " << each.name;
        }
    }
}

TEST(PartVisibility, OfAConvexPartIsLocal)
{
    const TriangleMesh part = test::box_mesh({0, 0, 0}, {1, 2, 3});
    const SphereGrid grid = sphere_grid("hex:4");
    const PartVisibility global = part_visibility(part, grid.centres);
    for (std::size_t cell = 0; cell < grid.centres.size(); ++cell)
        for (std::size_t facet = 0; facet < 12; ++facet) {
            const int axis = 2 - static_cast<int>(facet / 4);
            const double sign = facet / 2 % 2 == 0 ? -1 : 1;
            EXPECT_EQ(global.map.is_accessible(facet, cell),
                      sign * grid.centres[cell][axis] > 1e-6);
        }
}

TEST(PartVisibility, IsBlockedByBothSidesAndOnlyAbove)
{
    const TriangleMesh floor = small_facet({0, 0, 0}, {0, 0, 1}, 1);
    const std::vector<Vec3> up{{0, 0, 1}};
    const auto is_free = [&](const TriangleMesh& other) {
        return part_visibility(test::both(floor, other), up).map.is_accessible(0, 0);
    };
    EXPECT_FALSE(is_free(small_facet({0, 0, 1}, {0, 0, 1}, 1)));
    EXPECT_FALSE(is_free(small_facet({0, 0, 1}, {0, 0, -1}, 1)));
    EXPECT_FALSE(is_free(small_facet({0, 0, 1}, {0, 1, 0.001}, 1)));
    EXPECT_TRUE(is_free(small_facet({0, 0, -1e-9}, {0, 0, 1}, 1)));
    EXPECT_TRUE(is_free(small_facet({2, 0, 1}, {0, 0, 1}, 1)));
}

TEST(PartVisibility, DropsFacetsWithoutArea)
{
    const TriangleMesh part{{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, 1}, {1, 1, 2}},
                            {{3, 4, 4}, {0, 1, 2}, {3, 3, 3}}};
    const std::vector<Vec3> directions{{0, 0, 1}, {0, 0, -1}};
    const PartVisibility visibility = part_visibility(part, directions);
    EXPECT_EQ(visibility.dropped, (std::vector<std::size_t>{0, 2}));
    EXPECT_TRUE(visibility.map.is_accessible(1, 0));
    EXPECT_FALSE(visibility.map.is_accessible(1, 1));
    EXPECT_FALSE(visibility.map.is_accessible(0, 0));
    EXPECT_TRUE(empty_cones(visibility).empty());
}

TEST(PartVisibility, ListsEmptyCones)
{
    const TriangleMesh floor = small_facet({0, 0, 0}, {0, 0, 1}, 1);
    const TriangleMesh lid = small_facet({0, 0, 1e-9}, {0, 0, 1}, 1e3);
    const SphereGrid grid = sphere_grid("hex:4");
    const PartVisibility visibility =
        part_visibility(test::both(lid, floor), grid.centres);
    EXPECT_EQ(empty_cones(visibility), std::vector<std::size_t>{1});
}

TEST(PartVisibility, DoesNotDependOnTheThreads)
{
    const TriangleMesh part = test::torus_mesh(40, 20);
    const SphereGrid grid = sphere_grid("hex:4");
    std::vector<PartVisibility> answers;
    for (const int threads : {1, 8}) {
        set_thread_count(threads);
        answers.push_back(part_visibility(part, grid.centres));
    }
    for (std::size_t cell = 0; cell < grid.centres.size(); ++cell)
        EXPECT_TRUE(
            std::ranges::equal(answers[0].map.column(cell), answers[1].map.column(cell)));
}

TEST(PartVisibility, OfAShareHasTheColumnsOfItsDirections)
{
    const TriangleMesh part = test::torus_mesh(20, 10);
    const SphereGrid grid = sphere_grid("hex:3");
    for (const VisibilityKind kind : {VisibilityKind::Local, VisibilityKind::Global}) {
        const VisibilityMap whole =
            part_visibility(part, grid.centres, {.kind = kind}).map;
        const DirectionShare share{.first = 2, .step = 5};
        const VisibilityMap map =
            part_visibility(part, grid.centres, {.kind = kind, .share = share}).map;
        std::size_t own = 0;
        for (std::size_t cell = 0; cell < grid.centres.size(); ++cell)
            if (own < share.count(map.cells()) && cell == share.direction(own)) {
                EXPECT_TRUE(std::ranges::equal(map.column(cell), whole.column(cell)));
                ++own;
            } else {
                EXPECT_EQ(std::ranges::count(map.column(cell), std::uint64_t{0}),
                          std::ssize(map.column(cell)));
            }
        EXPECT_EQ(own, share.count(map.cells()));
    }
}

TEST(DirectionShare, CoversAllDirectionsOnceWithTheOtherShares)
{
    for (std::size_t directions = 0; directions < 10; ++directions) {
        std::size_t all = 0;
        for (std::size_t first = 0; first < 4; ++first) {
            const DirectionShare share{first, 4};
            const std::size_t count = share.count(directions);
            all += count;
            EXPECT_TRUE(count == 0 || share.direction(count - 1) < directions);
            EXPECT_GE(share.direction(count), directions);
        }
        EXPECT_EQ(all, directions);
    }
}

TEST(PartVisibility, ReportsTheNumberOfFinishedDirections)
{
    const SphereGrid grid = sphere_grid("hex:2");
    std::size_t last = 0;
    VisibilityOptions options;
    options.progress = [&](std::size_t done) { EXPECT_EQ(done, ++last); };
    part_visibility(test::flat_mesh(2, 2), grid.centres, options);
    EXPECT_EQ(last, grid.centres.size());
    options.progress = [](std::size_t) { throw std::runtime_error{"enough"}; };
    EXPECT_THROW(part_visibility(test::flat_mesh(2, 2), grid.centres, options),
                 std::runtime_error);
}

TEST(PartVisibility, RefusesArgumentsOutsideItsDomain)
{
    const TriangleMesh part = test::flat_mesh(1, 1);
    const std::vector<Vec3> long_one{{0, 0, 2}};
    const std::vector<Vec3> up{{0, 0, 1}};
    EXPECT_THROW(part_visibility(part, long_one), DomainError);
    for (const double incidence : {0.0, -1.0, 90.5, double(NAN)})
        EXPECT_THROW(part_visibility(part, up, {.incidence = Angle::degrees(incidence)}),
                     DomainError);
    EXPECT_EQ(part_visibility({}, up).map.facets(), 0U);
    EXPECT_EQ(part_visibility(part, {}).map.cells(), 0U);
    EXPECT_THROW(part_visibility(part, {}, {.share = {0, 0}}), DomainError);
}

TEST(VisibleFractions, AreSharesOfTheSolidAngle)
{
    VisibilityMap map{2, 3};
    map.column(0)[0] = 0b01;
    map.column(2)[0] = 0b11;
    const std::vector<double> solid_angles{1, 2, 5};
    const std::vector<double> fractions = visible_fractions(map, solid_angles);
    EXPECT_DOUBLE_EQ(fractions[0], 0.75);
    EXPECT_DOUBLE_EQ(fractions[1], 0.625);
    EXPECT_THROW(visible_fractions(map, std::vector<double>{1}), DomainError);
}

// Three facets above each other: the middle one hides the lower one, although the upper
// one comes first in the mesh, and nothing hides the upper one.
TEST(HidingFacet, IsTheFirstOneThatTheRayMeets)
{
    const TriangleMesh part = test::both(test::both(small_facet({0, 0, 9}, {0, 0, 1}, 5),
                                                    small_facet({0, 0, 0}, {0, 0, 1}, 1)),
                                         small_facet({0, 0, 4}, {0, 0.2, 1}, 5));
    EXPECT_EQ(hiding_facet(part, 1, Vec3::UnitZ()), 2U);
    EXPECT_EQ(hiding_facet(part, 2, Vec3::UnitZ()), 0U);
    EXPECT_EQ(hiding_facet(part, 2, -Vec3::UnitZ()), 1U);
    EXPECT_EQ(hiding_facet(part, 0, Vec3::UnitZ()), std::nullopt);
    EXPECT_EQ(hiding_facet(part, 1, Vec3{1, 0, 0.01}), std::nullopt);
    EXPECT_THROW(hiding_facet(part, 3, Vec3::UnitZ()), DomainError);
    EXPECT_THROW(hiding_facet(part, 0, Vec3::Zero()), DomainError);
}

}  // namespace
}  // namespace endmill
