// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/turning_tile.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/deviation/detail/part_tiles.h"
#include "turning_paths.h"

namespace endmill {
namespace {

// A tile of a plane below passes of a ball whose lead changes.
struct PlaneTile {
    PlaneTile(const Cutter& cutter, double apart, int points = 41)
        : path{test::plane_passes(
              cutter, {.apart = apart, .lead = {0.1, 0.5}, .points = points})},
          pieces{pieces_of(path, CuttingBody{cutter}), {{0, 0, 0}, 100}},
          charts{part_charts(part)},
          distance{charts, 0.01},
          tiles{part_tiles(charts, options.pitch, 1000)},
          measured{
              charts, pieces, initial, options, distance, false, cutter.corner_radius()}
    {
    }

    static std::vector<ToolPiece> pieces_of(const ToolPath& path, const CuttingBody& body)
    {
        std::vector<ToolPiece> pieces;
        for (std::size_t k = 1; k < path.points.size(); ++k)
            pieces.push_back({{path.points[k - 1].location, path.points[k].location},
                              body,
                              static_cast<std::int32_t>(k),
                              static_cast<std::int32_t>(k)});
        return pieces;
    }

    Part part = std::vector<Surface>{
        nurbs_surface({{1, {0, 0, 1, 1}},
                       {1, {0, 0, 1, 1}},
                       {{9, 0, 0}, {11, 0, 0}, {9, 2, 0}, {11, 2, 0}},
                       {}})};
    ToolPath path;
    ToolPieces pieces;
    PartCharts charts;
    InitialRay initial = [](const PartRay&) { return CutRay{5, 0, -1}; };
    DeviationOptions options = [] {
        DeviationOptions some;
        some.limits = {0.01, 0.05};
        some.pitch = 0.25;
        return some;
    }();
    PartDistance distance;
    std::vector<PartTile> tiles;
    TurningMeasured measured;
};

TEST(TurningTile, RaysHaveTheBallsHeightBetweenTheirBounds)
{
    const PlaneTile plane{Cutter::ball(5), 2};
    for (const PartTile& tile : plane.tiles) {
        const TurningTile found{plane.measured, tile};
        for (const BoundedCell& bounded : found.cells()) {
            const double y = bounded.cell.ray.point.y();
            const double away = std::min(y, 2 - y);
            const double exact = 5 - std::sqrt(25 - away * away);
            EXPECT_LE(bounded.ray.low, exact + 1e-9);
            EXPECT_GE(bounded.ray.high, exact - 1e-9);
        }
    }
}

TEST(TurningTile, BoundsContainFinerRays)
{
    for (const Cutter& cutter : {Cutter::ball(5), Cutter{5, 1}, Cutter::flat(5)}) {
        const PlaneTile plane{cutter, 2};
        for (const PartTile& tile : plane.tiles) {
            const TurningTile found{plane.measured, tile};
            const Extremes coarse = found.extremes();
            const Extremes fine = found.refined({0.001, -0.0005});
            EXPECT_GE(coarse.upper, fine.highest.left);
            EXPECT_LE(coarse.lower, fine.deepest.left);
            EXPECT_GE(fine.upper, fine.highest.left);
            EXPECT_LE(fine.upper, coarse.upper + 1e-9);
            EXPECT_GT(fine.rays, coarse.rays);
        }
    }
}

// A ball with an even feed of its centre only touches the plane, however coarse its moves.
// Halved pieces show it at the border of the part too, where half spaces are used.
TEST(TurningTile, RefinedBoundsOfAGougeAreCloseWhereABallTouchesThePlane)
{
    PlaneTile plane{Cutter::ball(5), 2, 3};
    plane.options.limits = {0.001, 0.05};
    for (const PartTile& tile : plane.tiles) {
        const TurningTile measure{plane.measured, tile};
        const Extremes found = measure.refined({1e9, -0.002});
        EXPECT_GE(found.lower, -0.002);
    }
}

TEST(TurningTile, GapIsBelowTheDistanceOfTheCutter)
{
    const PlaneTile plane{Cutter::ball(5), 2};
    EXPECT_LE((TurningTile{plane.measured, plane.tiles.front()}.gap()), 1e-6);
}

}  // namespace
}  // namespace endmill
