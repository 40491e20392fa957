// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/visibility.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/visibility/detail/cylinder_contact.h"
#include "endmill/visibility/sphere_grid.h"
#include "teapot.h"
#include "test_meshes.h"

namespace endmill {
namespace {

const std::vector<ToolCylinder> slender{{0.1, 0.3, 2}, {0.4, 2, 3}};

TEST(KeepReachable, KeepsDirectionsWithoutAContact)
{
    const TriangleMesh part = test::torus_mesh(16, 10);
    const std::vector<Vec3> directions = sphere_grid("hex:3").centres;
    const PartVisibility before = part_visibility(part, directions);
    PartVisibility after = before;
    keep_reachable(after, part, directions, slender);
    int kept = 0;
    int lost = 0;
    for (std::size_t cell = 0; cell < directions.size(); ++cell)
        for (std::size_t facet = 0; facet < part.triangles().size(); ++facet) {
            bool expected = before.map.is_accessible(facet, cell);
            const auto [a, b, c] = part.corners(facet);
            for (const ToolCylinder& each : slender)
                for (std::size_t other = 0; expected && other < part.triangles().size();
                     ++other)
                    expected = !meets({(a + b + c) / 3, directions[cell],
                                       each.diameter / 2, each.from, each.to},
                                      part.corners(other));
            EXPECT_EQ(after.map.is_accessible(facet, cell), expected);
            kept += expected;
            lost += before.map.is_accessible(facet, cell) && !expected;
        }
    EXPECT_GT(kept, 1000);
    EXPECT_GT(lost, 100);
}

// The tool stands upright on the floor of a pocket with walls of height h at the distance
// w. A cylinder of radius r fits if r < w; a cylinder that begins at the height h always
// fits.
TEST(KeepReachable, FitsAnUprightToolIntoAPocket)
{
    TriangleMesh part{{{-0.1, -0.1, 0}, {0.2, -0.1, 0}, {-0.1, 0.2, 0}}, {{0, 1, 2}}};
    const double w = 3;
    for (const double sign : {-1.0, 1.0}) {
        part = test::both(
            part,
            {{{sign * w, -w, 0}, {sign * w, w, 0}, {sign * w, w, 5}, {sign * w, -w, 5}},
             {{0, 1, 2}, {0, 2, 3}}});
        part = test::both(
            part,
            {{{-w, sign * w, 0}, {w, sign * w, 0}, {w, sign * w, 5}, {-w, sign * w, 5}},
             {{0, 1, 2}, {0, 2, 3}}});
    }
    const std::vector<Vec3> up{{0, 0, 1}};
    const auto fits = [&](const std::vector<ToolCylinder>& body) {
        PartVisibility visibility = part_visibility(part, up);
        EXPECT_TRUE(visibility.map.is_accessible(0, 0));
        keep_reachable(visibility, part, up, body);
        return visibility.map.is_accessible(0, 0);
    };
    EXPECT_TRUE(fits({}));
    EXPECT_TRUE(fits({{5.99, 1, 9}}));
    EXPECT_FALSE(fits({{6.01, 1, 9}}));
    EXPECT_FALSE(fits({{6.01, 4.99, 9}}));
    EXPECT_TRUE(fits({{6.01, 5.01, 9}}));
    EXPECT_TRUE(fits({{2, 1, 9}, {60, 5.01, 9}}));
    EXPECT_FALSE(fits({{2, 1, 9}, {60, 4.99, 9}}));
    EXPECT_FALSE(fits({{2, 0, 9}}));  // this cylinder touches the facet of the tip
}

// An obstacle at the distance L from the tip, where a cylinder of radius r has begun,
// meets it if the angle from the axis is below asin(r / L).
TEST(KeepReachable, KeepsAwayFromAFarPointByItsRadius)
{
    const double far = 100;
    const TriangleMesh part{{{-0.1, -0.1, 0},
                             {0.2, -0.1, 0},
                             {-0.1, 0.2, 0},
                             {0, 0, far},
                             {0, 1e-6, far + 1e-6},
                             {0, -1e-6, far + 1e-6}},
                            {{0, 1, 2}, {3, 4, 5}}};
    const std::vector<ToolCylinder> body{{10, 50, 150}};
    const double limit = std::asin(5 / far);
    for (const double angle : {0.9 * limit, 0.999 * limit, 1.001 * limit, 1.1 * limit}) {
        const std::vector<Vec3> directions{{std::sin(angle), 0, std::cos(angle)}};
        PartVisibility visibility = part_visibility(part, directions);
        keep_reachable(visibility, part, directions, body);
        EXPECT_EQ(visibility.map.is_accessible(0, 0), angle > limit) << angle / limit;
    }
}

TEST(KeepReachable, OnlyRemovesAndDoesNotDependOnThreads)
{
    const TriangleMesh part = test::teapot();
    const std::vector<Vec3> directions = sphere_grid("hex:4").centres;
    const PartVisibility before = part_visibility(part, directions);
    std::vector<PartVisibility> after{before, before};
    set_thread_count(1);
    keep_reachable(after[0], part, directions, slender);
    set_thread_count(8);
    std::size_t last = 0;
    keep_reachable(after[1], part, directions, slender,
                   [&](std::size_t done) { EXPECT_EQ(done, ++last); });
    EXPECT_EQ(last, directions.size());
    for (std::size_t cell = 0; cell < directions.size(); ++cell) {
        EXPECT_TRUE(
            std::ranges::equal(after[0].map.column(cell), after[1].map.column(cell)));
        for (std::size_t word = 0; word < before.map.words(); ++word)
            EXPECT_EQ(after[0].map.column(cell)[word] & ~before.map.column(cell)[word],
                      0U);
    }
}

TEST(KeepReachable, RefusesArgumentsOutsideItsDomain)
{
    const TriangleMesh part = test::flat_mesh(1, 1);
    const std::vector<Vec3> up{{0, 0, 1}};
    PartVisibility visibility = part_visibility(part, up);
    const auto keep = [&](const std::vector<ToolCylinder>& body) {
        keep_reachable(visibility, part, up, body);
    };
    EXPECT_THROW(keep({{0, 1, 2}}), DomainError);
    EXPECT_THROW(keep({{1, 2, 2}}), DomainError);
    EXPECT_THROW(keep({{1, -1, 2}}), DomainError);
    EXPECT_THROW(keep({{1, 1, double(INFINITY)}}), DomainError);
    EXPECT_THROW(keep({{double(NAN), 1, 2}}), DomainError);
    EXPECT_THROW(keep_reachable(visibility, test::flat_mesh(2, 1), up, slender),
                 DomainError);
    EXPECT_THROW(keep_reachable(visibility, part, {}, slender), DomainError);
}

}  // namespace
}  // namespace endmill
