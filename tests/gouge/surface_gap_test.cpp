// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/gouge/detail/surface_gap.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "endmill/surface/surface.h"

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// A half cylinder z = sqrt(25 - x^2) seen from above, as two rational quarters.
Surface cylinder()
{
    const double w = std::sqrt(0.5);
    std::vector<BezierPatch> patches;
    for (const double side : {-1.0, 1.0}) {
        std::vector<Eigen::Vector4d> net;
        for (const double y : {-20.0, 20.0}) {
            const std::array<Eigen::Vector4d, 3> arc{
                Eigen::Vector4d{-5, y, 0, 1}, Eigen::Vector4d{-5 * w, y * w, 5 * w, w},
                Eigen::Vector4d{0, y, 5, 1}};
            for (int k = 0; k < 3; ++k) {
                Eigen::Vector4d point = side < 0 ? arc[k] : arc[2 - k];
                point.x() *= -side;
                net.push_back(point);
            }
        }
        patches.push_back(BezierPatch::from_homogeneous(2, 1, net, true));
    }
    return {{0, 1, 2}, {0, 1}, std::move(patches)};
}

TEST(SurfaceGap, ToACylinderIsTheDistanceOfItsAxis)
{
    const std::vector<Surface> surfaces{cylinder()};
    const PieceTree tree{surfaces, 1};
    FinerPieces finer;
    for (const double h : {6.0, 7.5, 9.0}) {
        const Vec3 centre{0.6 * h, 1, 0.8 * h};
        const auto ball =
            surface_gap(tree, CutterCore{Cutter::ball(3), centre}, 1e-9, infinite, finer);
        EXPECT_NEAR(ball->gap, h - 5 - 3, 2e-9);
        EXPECT_NEAR((ball->point - Vec3{3, 1, 4}).norm(), 0, 1e-3);
        // The circle of a bull-nose cutter's corner: its nearest point is R - r nearer in
        // x.
        const Vec3 reference = centre + Vec3{2, 0, 0};
        const auto bull =
            surface_gap(tree, CutterCore{Cutter{3, 1}, reference}, 1e-9, infinite, finer);
        EXPECT_NEAR(bull->gap, h - 5 - 1, 2e-9);
    }
}

// From a point of the axis the whole circle is equally far, so that no piece along it is
// settled before it is very small. The search goes on after its memory for halves is full.
TEST(SurfaceGap, IsFoundWithMorePiecesThanAreKept)
{
    const std::vector<Surface> surfaces{cylinder()};
    const PieceTree tree{surfaces, 1};
    FinerPieces finer;
    const auto ball = surface_gap(tree, CutterCore{Cutter::ball(3), Vec3{0, 1, 0}}, 1e-8,
                                  infinite, finer);
    EXPECT_TRUE(finer.is_full());
    EXPECT_NEAR(ball->gap, 5 - 3, 2e-8);
}

TEST(SurfaceGap, BelowALimitExistsIfTheMinimumIsBelow)
{
    const std::vector<Surface> surfaces{cylinder()};
    const PieceTree tree{surfaces, 1};
    FinerPieces finer;
    for (const double h : {6.0, 7.9, 8.1, 9.0}) {
        const CutterCore core{Cutter::ball(3), {0.6 * h, 1, 0.8 * h}};
        for (const double limit : {-1.0, -0.01, 0.0, 0.5}) {
            // Cases that the resolution would decide are excluded.
            ASSERT_GT(std::abs(h - 5 - 3 - limit), 1e-6);
            EXPECT_EQ(gap_below(tree, core, 1e-9, limit, finer).has_value(),
                      h - 5 - 3 < limit);
        }
    }
}

TEST(SurfaceGap, IsEmptyAboveTheLimit)
{
    const std::vector<Surface> surfaces{cylinder()};
    const PieceTree tree{surfaces, 1};
    FinerPieces finer;
    const CutterCore core{Cutter::ball(3), {0, 0, 9}};  // gap 1
    EXPECT_FALSE(surface_gap(tree, core, 1e-6, 0.5, finer));
    EXPECT_TRUE(surface_gap(tree, core, 1e-6, 1.5, finer));
}

}  // namespace
}  // namespace endmill
