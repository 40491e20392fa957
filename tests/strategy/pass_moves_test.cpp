// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/pass_moves.h"

#include <gtest/gtest.h>

#include "test_surfaces.h"

namespace endmill {
namespace {

LaidPass straight_pass(const PartSamples& samples, int contacts)
{
    LaidPass pass;
    for (int k = 0; k < contacts; ++k)
        pass.contacts.push_back(samples.contact({k / (contacts - 1.0), 0.5}, 0));
    return pass;
}

TEST(PassMoves, AStraightPassIsOneMove)
{
    const Part plane = std::vector<Surface>{test::plane(20, 10)};
    const CoveredPart part{plane, BallCutter{5}, {0.01, 0.1}};
    const PartSamples samples = part.samples(1, 100'000);
    LaidPass pass = straight_pass(samples, 21);
    const auto pieces = divided_into_moves(pass, samples, part, {0.9, 0.05});
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_EQ(pieces[0].contacts.size(), 2u);
    pass.contacts[7].is_required = true;
    EXPECT_EQ(divided_into_moves(pass, samples, part, {0.9, 0.05})[0].contacts.size(),
              3u);
}

TEST(PassMoves, KeepTheInnerToleranceOnASaddle)
{
    const std::vector<Surface> surfaces{test::saddle(60, 20)};
    const Part saddle = surfaces;
    const BallCutter ball{5};
    const CoveredPart part{saddle, ball, {0.01, 0.1}};
    const PartSamples samples = part.samples(1, 100'000);
    const GougeTest gouge{surfaces, ball, Vec3::UnitZ()};
    const LaidPass pass = straight_pass(samples, 41);
    std::size_t moves = 0;
    for (const LaidPass& piece : divided_into_moves(pass, samples, part, {0.4, 0.05}))
        for (std::size_t k = 0; k + 1 < piece.contacts.size(); ++k, ++moves) {
            const BallMove move{ball_centre(piece.contacts[k].at, ball),
                                ball_centre(piece.contacts[k + 1].at, ball)};
            EXPECT_NE(gouge.test(move, 0.0101).gouges, Answer::Yes);
        }
    EXPECT_LT(moves, 40u);
    EXPECT_GT(moves, 2u);
}

// A pass that is changed and divided again has the pieces of a new one.
TEST(PassDivision, DividesAChangedPassAsANewOne)
{
    const Part saddle = std::vector<Surface>{test::saddle(60, 20)};
    const CoveredPart part{saddle, BallCutter{5}, {0.01, 0.1}};
    const PartSamples samples = part.samples(1, 100'000);
    const MoveLimits limits{0.4, 0.05};
    PassDivision division{samples, part, limits};
    MoveTestState state;
    LaidPass pass = straight_pass(samples, 41);
    division.pieces_of(pass, state);
    pass.contacts[9].is_required = true;
    division.pieces_of(pass, state);
    PassContact bend = samples.contact({0.51, 0.52}, 0);
    bend.is_required = true;
    pass.contacts.insert(pass.contacts.begin() + 21, bend);
    const auto again = division.pieces_of(pass, state);
    const auto anew = divided_into_moves(pass, samples, part, limits);
    ASSERT_EQ(again.size(), anew.size());
    for (std::size_t k = 0; k < anew.size(); ++k) {
        ASSERT_EQ(again[k].contacts.size(), anew[k].contacts.size());
        for (std::size_t l = 0; l < anew[k].contacts.size(); ++l)
            EXPECT_EQ(again[k].contacts[l].at.contact.point,
                      anew[k].contacts[l].at.contact.point);
    }
}

}  // namespace
}  // namespace endmill
