// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/gouge/detail/piece_tree.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/surface/extent.h"
#include "revolved_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

std::vector<Surface> two_surfaces()
{
    return {test::random_surface(3, {2, 1}),
            Surface{{0, 1}, {0, 1}, {test::random_patch(4, 2, 4, true)}}};
}

TEST(PieceTree, HalvesTileThePatches)
{
    const std::vector<Surface> surfaces = two_surfaces();
    const PieceTree tree{surfaces, 4};
    double shares = 0;
    for (const PieceTree::Piece& piece : tree.pieces()) {
        const BezierPiece& bezier = piece.bezier;
        const Surface& surface = surfaces[bezier.surface];
        for (const int end_u : {0, 1})
            for (const int end_v : {0, 1}) {
                const double u = end_u == 0 ? bezier.low.u : bezier.high.u;
                const double v = end_v == 0 ? bezier.low.v : bezier.high.v;
                EXPECT_LT(
                    (bezier.corner(end_u, end_v) - surface.tangents(u, v).point).norm(),
                    1e-12);
            }
        if (piece.halves != 0)
            continue;
        EXPECT_LE(bezier.box().diagonal().norm(), 4);
        shares += (bezier.high.u - bezier.low.u) * (bezier.high.v - bezier.low.v);
    }
    EXPECT_NEAR(shares, 3, 1e-12);  // patches
}

TEST(PieceTree, BoundsEveryPieceFromBelow)
{
    const std::vector<Surface> surfaces = two_surfaces();
    const PieceTree tree{surfaces, 9};
    const Vec3 direction = Vec3{1, -2, 3}.normalized();
    const Vec3 origin{5, 6, 7};
    for (const PieceTree::Piece& piece : tree.pieces()) {
        const auto& [low, high] = std::pair{piece.bezier.low, piece.bezier.high};
        const double bound = piece.bezier.least_height(direction, origin);
        for (int k = 0; k <= 30; ++k) {
            const Vec3 point =
                surfaces[piece.bezier.surface]
                    .tangents(std::lerp(low.u, high.u, k / 30.0),
                              std::lerp(low.v, high.v, (k * 7 % 31) / 30.0))
                    .point;
            EXPECT_GE(direction.dot(point - origin), bound - 1e-12);
            EXPECT_LT(piece.bezier.box().exteriorDistance(point), 1e-12);
        }
    }
}

TEST(PieceTree, LimitsTheNumberOfPieces)
{
    const std::vector<Surface> surfaces{test::plane(100, 100)};
    EXPECT_LT((PieceTree{surfaces, 1e-9}.pieces().size()), 200'000U);
    // Narrow for its area: squares of the same area would be few.
    const std::vector<Surface> needle{test::plane(1e6, 0.01)};
    EXPECT_LT((PieceTree{needle, 1}.pieces().size()), 200'000U);
    EXPECT_THROW((PieceTree{surfaces, 0}), DomainError);
    EXPECT_THROW((PieceTree{{}, 1}), DomainError);
}

}  // namespace
}  // namespace endmill
