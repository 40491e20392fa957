// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/tool_pieces.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

Vec3 random_place(test::Random& random, double size)
{
    return {random.uniform(-size, size), random.uniform(-size, size),
            random.uniform(-size, size)};
}

std::vector<ToolPiece> random_pieces(int count)
{
    test::Random random{1};
    std::vector<ToolPiece> pieces;
    CutterLocation last{{0, 0, 0}, {0, 0, 1}};
    for (int i = 0; i < count; ++i) {
        const CutterLocation next{last.tip + random_place(random, 3),
                                  (last.axis + random_place(random, 0.2)).normalized()};
        pieces.push_back({{last, next},
                          CuttingBody{i % 2 == 0 ? Cutter::flat(2) : Cutter::ball(1)},
                          i,
                          i});
        last = next;
    }
    return pieces;
}

// The least signed distance of a place from a piece, by many poses.
double sampled_distance(const ToolPiece& piece, const Vec3& place)
{
    double least = 1e9;
    for (int k = 0; k <= 32; ++k)
        least = std::min(least,
                         piece.body.distance(piece.motion.seen(place, k / 32.0)).value);
    return least;
}

TEST(ToolPieces, VisitsEveryPieceWithinTheBoundWithALowerBound)
{
    const ToolPieces pieces{random_pieces(300), {{0, 0, 0}, 60}};
    test::Random random{2};
    for (int i = 0; i < 100; ++i) {
        const Vec3 place = random_place(random, 30);
        const double within = random.uniform(0, 5);
        std::set<std::int32_t> visited;
        double last = -1e9;
        pieces.visit_nearest(place, within, [&](std::size_t number, double bound) {
            const ToolPiece& piece = pieces.pieces()[number];
            EXPECT_TRUE(visited.insert(piece.point).second);
            EXPECT_GE(bound, last);
            EXPECT_LE(bound, sampled_distance(piece, place) + 1e-12);
            last = bound;
            return within;
        });
        for (const ToolPiece& piece : pieces.pieces())
            EXPECT_TRUE(sampled_distance(piece, place) > within ||
                        visited.contains(piece.point));
    }
}

TEST(ToolPieces, WithoutPiecesVisitsNothing)
{
    const ToolPieces pieces{{}, {{0, 0, 0}, 1}};
    pieces.visit_nearest({0, 0, 0}, 1e9, [](std::size_t, double) {
        ADD_FAILURE();
        return 0.0;
    });
}

TEST(ToolPieces, StopsWhenTheVisitorLowersTheBound)
{
    const ToolPieces pieces{random_pieces(300), {{0, 0, 0}, 60}};
    int visits = 0;
    pieces.visit_nearest({0, 0, 0}, 1e9, [&](std::size_t, double) {
        ++visits;
        return -1e9;
    });
    EXPECT_EQ(visits, 1);
}

}  // namespace
}  // namespace endmill
