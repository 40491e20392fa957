// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/cell_bounds.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/stock/detail/sweep_tree.h"
#include "endmill/stock/stock_history.h"
#include "random.h"
#include "test_surfaces.h"
#include "tip_path.h"

namespace endmill {
namespace {

// Compares the thickness that random sweeps leave on a cell of a curved part, sampled
// densely, with the bounds from the cell's middle and corners.
TEST(CellBounds, HoldEverywhereOnTheCell)
{
    test::Random random{31};
    const Part part = std::vector<Surface>{test::saddle(30, 4)};
    const PartCharts charts = part_charts(part);
    for (const Cutter& cutter : {Cutter::ball(5), Cutter{5, 2}, Cutter::flat(5)})
        for (int round = 0; round < 60; ++round) {
            std::vector<Vec3> tips;
            for (int i = 0; i < 8; ++i)
                tips.emplace_back(random.uniform(-5, 5), random.uniform(-5, 5),
                                  random.uniform(-0.2, 0.2));
            const std::vector<StraightSweep> sweeps =
                path_sweeps(test::tip_path(tips), cutter);
            std::vector<std::int32_t> all(sweeps.size());
            std::iota(all.begin(), all.end(), 0);
            const auto left_at = [&](const Eigen::Vector2d& at) {
                CutRay least{9, 0, -1};
                for (const std::int32_t k : all)
                    if (const auto left = cut_ray(sweeps[static_cast<std::size_t>(k)],
                                                  *charts.ray(0, at), least.thickness)) {
                        least = *left;
                        least.sweep = k;
                    }
                return least;
            };
            const double u = random.uniform(0.1, 0.8);
            const double v = random.uniform(0.1, 0.8);
            PartCell cell{0, 4, {}};
            cell.at = {Eigen::Vector2d{u, v}, Eigen::Vector2d{u + 0.02, v},
                       Eigen::Vector2d{u + 0.02, v + 0.02}, Eigen::Vector2d{u, v + 0.02}};
            const PartRay ray = *charts.ray(0, cell.centre());
            MeasuredCell measured{cell, ray, cell.reach(ray), left_at(cell.centre()),
                                  charts.curvature(0, cell.centre())};
            double most = -9;
            double least = 9;
            for (int i = 0; i <= 20; ++i)
                for (int j = 0; j <= 20; ++j) {
                    const double left = left_at({u + 0.001 * i, v + 0.001 * j}).thickness;
                    most = std::max(most, left);
                    least = std::min(least, left);
                }
            const double planes = least_left_by_planes(measured, sweeps, all);
            EXPECT_GE(least, planes - 1e-6);
            EXPECT_EQ(least_left_by_planes(measured, sweeps,
                                           sweeps_on_cell(measured, sweeps, all)),
                      planes);
            if (measured.cut.sweep < 0)
                continue;
            EXPECT_LE(most, most_left_by_slope(measured, cutter) + 1e-9);
            const auto local = local_sweeps(measured, sweeps, all);
            EXPECT_LE(most, most_left_by_corners(measured, charts, sweeps, local) + 1e-9);
        }
}

// A sharp rim touches a slope. The error of the bound by planes falls with the square of
// the cell's size, wherever in the cell the rim touches.
TEST(LeastLeftByPlanes, OfATouchingRimIsOfSecondOrder)
{
    const Part part =
        std::vector<Surface>{test::graph(test::monomial(1, 0, 0.75), {{-4, 4}, {-4, 4}})};
    const PartCharts charts = part_charts(part);
    // The feed runs downhill from the rim, and along the contour.
    const Vec3 tip{-2, 0, 0};
    for (const double length : {0.0, 3.0}) {
        const std::vector<StraightSweep> sweeps{{Cutter::flat(2),
                                                 tip - Vec3{0, length / 2, 0},
                                                 tip + Vec3{0, length / 2, 0}}};
        const std::int32_t all[] = {0};
        for (const double size : {0.02, 0.01, 0.005})
            for (const double aside : {-0.9, -0.3, 0.0, 0.5, 0.9}) {
                const Eigen::Vector2d middle{0.5 + aside * size / 2,
                                             0.5 + aside * size / 3};
                PartCell cell{0, 4, {}};
                cell.at = {middle + Eigen::Vector2d{-size, -size} / 2,
                           middle + Eigen::Vector2d{size, -size} / 2,
                           middle + Eigen::Vector2d{size, size} / 2,
                           middle + Eigen::Vector2d{-size, size} / 2};
                const PartRay ray = *charts.ray(0, cell.centre());
                const MeasuredCell measured{
                    cell, ray, cell.reach(ray), {1, 0, -1}, {0, 0}};
                const double least = least_left_by_planes(measured, sweeps, all);
                EXPECT_LE(least, 1);
                EXPECT_GE(least, -measured.reach * measured.reach / 2) << size << aside;
            }
    }
}

// One cutter is pressed into a convex part, with its deepest place anywhere on the cell.
TEST(HiddenGouge, IsNeverLessThanWhatTheCellHides)
{
    test::Random random{32};
    for (const double bend : {0.0, -0.02})
        for (const Cutter& cutter : {Cutter::ball(5), Cutter{5, 2}}) {
            const Part part = std::vector<Surface>{test::parabolic_cylinder(bend, 8, 8)};
            const PartCharts charts = part_charts(part);
            for (int round = 0; round < 100; ++round) {
                const Eigen::Vector2d deepest{random.uniform(0.3, 0.7),
                                              random.uniform(0.3, 0.7)};
                const PartRay ray = *charts.ray(0, deepest);
                const Vec3 centre =
                    ray.point + (cutter.corner_radius() - 0.1) * ray.normal;
                const Vec3 level = Vec3{ray.normal.x(), ray.normal.y(), 0};
                const Vec3 out =
                    level.norm() > 0 ? Vec3{level.normalized()} : Vec3::Zero();
                const Vec3 tip = centre + cutter.flat_radius() * out -
                                 Vec3{0, 0, cutter.corner_radius()};
                const StraightSweep sweep{cutter, tip, tip};
                const Eigen::Vector2d middle =
                    deepest + Eigen::Vector2d{random.uniform(-0.01, 0.01),
                                              random.uniform(-0.01, 0.01)};
                const PartCell cell{0,
                                    4,
                                    {middle + Eigen::Vector2d{-0.01, -0.01},
                                     middle + Eigen::Vector2d{0.01, -0.01},
                                     middle + Eigen::Vector2d{0.01, 0.01},
                                     middle + Eigen::Vector2d{-0.01, 0.01}}};
                const PartRay at = *charts.ray(0, middle);
                const MeasuredCell measured{cell, at, cell.reach(at), *cut_ray(sweep, at),
                                            charts.curvature(0, middle)};
                EXPECT_LE(measured.cut.thickness -
                              hidden_gouge(measured, cutter.corner_radius()),
                          cut_ray(sweep, ray)->thickness + 1e-6);
            }
        }
}

}  // namespace
}  // namespace endmill
