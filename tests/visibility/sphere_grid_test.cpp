// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/sphere_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/visibility/detail/cover_radius.h"

namespace endmill {
namespace {

constexpr double degree = std::numbers::pi / 180;

struct PrintedGrid {
    const char* name;
    std::size_t cells;
    double area_ratio;
    double cover_radius_deg;
};

class SphereGridOfTheTable : public testing::TestWithParam<PrintedGrid> {};

TEST_P(SphereGridOfTheTable, HasItsCellsRatioOfAreasAndCoverRadius)
{
    const SphereGrid grid = sphere_grid(GetParam().name);
    EXPECT_EQ(grid.name, GetParam().name);
    EXPECT_EQ(grid.cells.size(), GetParam().cells);
    EXPECT_EQ(sphere_grid_cells(GetParam().name), GetParam().cells);
    const auto [least, most] = std::ranges::minmax(grid.solid_angles_sr);
    EXPECT_NEAR(most / least, GetParam().area_ratio, 0.005);
    EXPECT_NEAR(cover_radius(grid.centres) / degree, GetParam().cover_radius_deg, 0.006);
}

TEST_P(SphereGridOfTheTable, CoversTheSphereOnceCounterClockwise)
{
    const SphereGrid grid = sphere_grid(GetParam().name);
    ASSERT_EQ(grid.centres.size(), grid.cells.size());
    ASSERT_EQ(grid.solid_angles_sr.size(), grid.cells.size());
    const double sum =
        std::accumulate(grid.solid_angles_sr.begin(), grid.solid_angles_sr.end(), 0.0);
    EXPECT_NEAR(sum, 4 * std::numbers::pi, 1e-12);
    std::set<std::pair<int, int>> edges;
    for (std::size_t k = 0; k < grid.cells.size(); ++k) {
        const auto& [a, b, c] = grid.cells[k];
        EXPECT_GT(grid.solid_angles_sr[k], 0);
        EXPECT_NEAR(grid.centres[k].norm(), 1, 1e-15);
        const Vec3 middle = grid.corners[a] + grid.corners[b] + grid.corners[c];
        EXPECT_LT((middle.normalized() - grid.centres[k]).norm(), 1e-15);
        for (const auto& edge : {std::pair{a, b}, {b, c}, {c, a}})
            EXPECT_TRUE(edges.insert(edge).second);
    }
    for (const auto& [from, to] : edges)
        EXPECT_TRUE(edges.contains({to, from}));
    EXPECT_EQ(grid.corners.size(), grid.cells.size() / 2 + 2);  // Euler
}

INSTANTIATE_TEST_SUITE_P(Section81, SphereGridOfTheTable,
                         testing::Values(PrintedGrid{"latlong:40x16", 1200, 5.16, 7.48},
                                         PrintedGrid{"latlong:30x21", 1200, 6.76, 5.69},
                                         PrintedGrid{"latlong:24x26", 1200, 8.44, 5.65},
                                         PrintedGrid{"latlong:60x11", 1200, 3.52, 10.91},
                                         PrintedGrid{"hex:10", 1200, 1.69, 5.58},
                                         PrintedGrid{"cube:10", 1200, 1.43, 4.92},
                                         PrintedGrid{"ico:3", 1280, 1.29, 5.32},
                                         PrintedGrid{"ico:4", 5120, 1.30, 2.72}));

TEST(SphereGrid, OrdersTheCellsOfTheBipyramid)
{
    const SphereGrid grid = sphere_grid("hex:10");
    std::size_t number = 0;
    const auto point = [](int k, int s, int i) {
        const double polar = 9 * k * degree;
        const double azimuth = k == 0 ? 0 : 60 * (s + double(i) / k) * degree;
        return Vec3{std::sin(polar) * std::cos(azimuth),
                    std::sin(polar) * std::sin(azimuth), std::cos(polar)};
    };
    const auto expect_next = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        const Vec3 centre = (a + b + c).normalized();
        EXPECT_LT((grid.centres[number] - centre).norm(), 2e-15);
        const Vec3 south{centre.x(), centre.y(), -centre.z()};
        EXPECT_LT((grid.centres[number + 600] - south).norm(), 2e-15);
        ++number;
    };
    for (int k = 0; k < 10; ++k)
        for (int s = 0; s < 6; ++s)
            for (int i = 0; i <= k; ++i) {
                expect_next(point(k, s, i), point(k + 1, s, i), point(k + 1, s, i + 1));
                if (i < k)
                    expect_next(point(k, s, i), point(k + 1, s, i + 1),
                                point(k, s, i + 1));
            }
    EXPECT_EQ(number, 600U);
}

TEST(SphereGrid, OrdersTheCellsOfTheCubeByFaces)
{
    const SphereGrid grid = sphere_grid("cube:10");
    const auto corner = [](int axis, int sign, int a, int b) {
        Vec3 point;
        point[axis] = sign;
        point[(axis + 1) % 3] = std::tan(45 * (2 * a / 10.0 - 1) * degree);
        point[(axis + 2) % 3] = std::tan(45 * (2 * b / 10.0 - 1) * degree);
        return point.normalized();
    };
    for (int number = 0; number < 1200; ++number) {
        const int axis = number / 400;
        const int sign = number / 200 % 2 == 0 ? -1 : 1;
        const int i = number % 200 / 20;
        const int j = number % 20 / 2;
        Vec3 sum = corner(axis, sign, i, j) + corner(axis, sign, i + 1, j + 1);
        sum +=
            number % 2 == 0 ? corner(axis, sign, i + 1, j) : corner(axis, sign, i, j + 1);
        EXPECT_LT((grid.centres[number] - sum.normalized()).norm(), 1e-15) << number;
    }
}

TEST(SphereGrid, OrdersBandsFromTheNorthPole)
{
    const SphereGrid grid = sphere_grid("latlong:4x3");
    ASSERT_EQ(grid.cells.size(), 16U);
    for (int j = 0; j < 4; ++j) {
        EXPECT_GT(grid.centres[j].z(), 0.8);
        EXPECT_LT(grid.centres[4 + 2 * j].z(), -0.15);
        EXPECT_GT(grid.centres[5 + 2 * j].z(), 0.15);
        EXPECT_LT(grid.centres[12 + j].z(), -0.8);
        // Two corners at one azimuth and one at the next, or a pole and two corners.
        const double turned = 45 - std::atan(0.5) / degree;
        for (const int number : {j, 4 + 2 * j, 5 + 2 * j, 12 + j}) {
            const double azimuth =
                std::atan2(grid.centres[number].y(), grid.centres[number].x()) / degree;
            const double off = number == j || number == 12 + j ? 0 : turned;
            EXPECT_NEAR(std::abs(std::remainder(azimuth - 90 * j - 45, 360)), off, 1e-12)
                << number;
        }
    }
}

TEST(SphereGrid, RefusesOtherNames)
{
    for (const char* name : {"",
                             "hex",
                             "hex:",
                             "hex:0",
                             "hex:-1",
                             "hex:10 ",
                             "hex:1e1",
                             "hex:913",
                             "cube:913",
                             "ico:-1",
                             "ico:10",
                             "ico:99999999999",
                             "latlong:2x5",
                             "latlong:5x1",
                             "latlong:5",
                             "latlong:5x",
                             "latlong:4000x4000",
                             "octa:3",
                             ":",
                             "Hex:10"})
        EXPECT_THROW(sphere_grid_cells(name), DomainError) << name;
    EXPECT_THROW(sphere_grid("hex:913"), DomainError);
    EXPECT_EQ(sphere_grid("ico:0").cells.size(), 20U);
    EXPECT_EQ(sphere_grid("hex:1").cells.size(), 12U);
    EXPECT_EQ(sphere_grid("latlong:3x2").cells.size(), 6U);
}

}  // namespace
}  // namespace endmill
