// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/covering_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/strategy/detail/covered_part.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

// A plane of 20 x 10 mm and a ball of radius 5 mm. At a height of 1 mm the ball covers 3 mm on
// both sides of a pass.
class PiecesOfAPlane : public testing::Test {
protected:
    PassContact contact(double x, double y) const
    {
        const Vec3 point{x, y, 0};
        std::int32_t near = 0;
        for (std::size_t i = 0; i < samples_.size(); ++i)
            if ((samples_.point(i) - point).norm() <
                (samples_.point(near) - point).norm())
                near = static_cast<std::int32_t>(i);
        return samples_.contact({x / 20, y / 10}, near);
    }

    LaidPass line(const Vec3& from, const Vec3& to) const
    {
        return {{contact(from.x(), from.y()), contact(to.x(), to.y())}, false};
    }

    Part plane_ = std::vector<Surface>{test::plane(20, 10)};
    BallCutter ball_{5};
    CoveredPart part_{plane_, ball_, {0.01, 1}};
    PartSamples samples_ = part_.samples(0.6, 100'000);
    CoveringPieces covering_{samples_, ball_, 1};
};

TEST_F(PiecesOfAPlane, MissWhatLiesBeyondTheirStrips)
{
    EXPECT_EQ(covering_.missed().size(), samples_.triangles().size());
    covering_.add(line({0, 2.9, 0}, {20, 2.9, 0}));
    for (const MissedPlace& place : covering_.missed())
        EXPECT_GT(contact_at(samples_, place).at.contact.point.y(), 5.9);
    EXPECT_FALSE(covering_.missed().empty());
    const std::size_t second = covering_.add(line({0, 9, 0}, {20, 9, 0}));
    EXPECT_FALSE(covering_.missed().empty());
    for (const MissedPlace& place : covering_.missed()) {
        EXPECT_GT(contact_at(samples_, place).at.contact.point.y(), 5.9);
        EXPECT_LT(contact_at(samples_, place).at.contact.point.y(), 6);
    }
    covering_.add(line({0, 8, 0}, {20, 8, 0}));
    EXPECT_TRUE(covering_.missed().empty());
    covering_.remove(second);
    EXPECT_TRUE(covering_.missed().empty());
    EXPECT_TRUE(covering_.pieces()[second].contacts.empty());
}

TEST_F(PiecesOfAPlane, LeaveOutOnlyWhatOthersCover)
{
    const std::size_t low = covering_.add(line({0, 2.9, 0}, {20, 2.9, 0}));
    const std::size_t between = covering_.add(line({5, 5, 0}, {15, 5, 0}));
    const std::size_t high = covering_.add(line({0, 8.8, 0}, {20, 8.8, 0}));
    ASSERT_TRUE(covering_.missed().empty());
    EXPECT_FALSE(covering_.leave_out(low));
    EXPECT_FALSE(covering_.leave_out(high));
    EXPECT_TRUE(covering_.leave_out(between));
    EXPECT_TRUE(covering_.missed().empty());
}

// An end of a pass at y = 2 has to reach the corner (0, 0) within 3 mm.
TEST_F(PiecesOfAPlane, AreCutBackToTheClosedDistance)
{
    const std::size_t low = covering_.add(line({20, 2, 0}, {0, 2, 0}));
    covering_.add(line({0, 7.9, 0}, {20, 7.9, 0}));
    covering_.add(line({0, 5, 0}, {20, 5, 0}));
    ASSERT_TRUE(covering_.missed().empty());
    double too_short = 20;
    double long_enough = 0;
    for (int k = 0; k < 20; ++k) {
        const double x = (too_short + long_enough) / 2;
        const PieceChange change{low, 1, 2, {contact(x, 2)}};
        const PassContact end = covering_.pieces()[low].contacts.back();
        const bool would_cover = covering_.would_cover(change);
        EXPECT_EQ(covering_.pieces()[low].contacts.back().at.contact.point,
                  end.at.contact.point);
        EXPECT_EQ(covering_.make(change), would_cover);
        (would_cover ? long_enough : too_short) = x;
    }
    EXPECT_NEAR(long_enough, std::sqrt(9 - 4), 0.01);
    EXPECT_TRUE(covering_.missed().empty());
}

TEST_F(PiecesOfAPlane, ChangeInTheMiddleAndTakeAnotherAway)
{
    const std::size_t low = covering_.add(line({0, 2.5, 0}, {20, 2.5, 0}));
    covering_.add(line({0, 7.5, 0}, {9, 7.5, 0}));
    covering_.add(line({11, 7.5, 0}, {20, 7.5, 0}));
    const std::size_t dot = covering_.add({{contact(10, 9)}, false});
    ASSERT_TRUE(covering_.missed().empty());
    EXPECT_TRUE(covering_.leave_out(dot));  // the ends reach 3 mm further
    const std::size_t again = covering_.add({{contact(10, 5)}, false});
    EXPECT_FALSE(covering_.make({low, 1, 1, {contact(10, 9.9)}, again}))
        << "without the way along y = 2.5";
    EXPECT_TRUE(covering_.make({low, 1, 1, {contact(10, 2.5)}, again}));
    EXPECT_EQ(covering_.pieces()[low].contacts.size(), 3u);
    EXPECT_TRUE(covering_.pieces()[again].contacts.empty());
    EXPECT_THROW(covering_.make({low, 1, 9, {}}), DomainError);
}

TEST_F(PiecesOfAPlane, AreReversedOpenedAndJoined)
{
    const std::size_t ring = covering_.add(
        {{contact(2.1, 2.1), contact(17.9, 2.1), contact(17.9, 7.9), contact(2.1, 7.9)},
         true});
    const std::size_t spot = covering_.add({{contact(10, 5)}, false});
    ASSERT_TRUE(covering_.missed().empty());
    EXPECT_FALSE(covering_.make({ring, 2, 3, {}})) << "cuts a corner";
    covering_.reverse(ring);
    covering_.open(ring, 1);
    EXPECT_FALSE(covering_.pieces()[ring].is_closed);
    EXPECT_EQ(covering_.pieces()[ring].contacts.size(), 5u);
    for (const std::size_t end : {0, 4})
        EXPECT_LT(
            (covering_.pieces()[ring].contacts[end].at.contact.point - Vec3(17.9, 7.9, 0))
                .norm(),
            1e-9);
    covering_.append(ring, std::array{contact(12, 6)}, spot);
    EXPECT_TRUE(covering_.pieces()[spot].contacts.empty());
    EXPECT_EQ(covering_.pieces()[ring].contacts.size(), 7u);
    EXPECT_NEAR(pass_length(covering_.pieces()[ring]),
                43.2 + std::hypot(5.9, 1.9) + std::hypot(2, 1), 1e-9);
    EXPECT_TRUE(covering_.missed().empty());
    EXPECT_FALSE(covering_.make({ring, 1, 2, {}})) << "moves keep their places";
    EXPECT_TRUE(covering_.make({ring, 6, 7, {}}));
    EXPECT_TRUE(covering_.missed().empty());
}

// In a concave trough the part lies below the triangles of the net. Two lines along the trough
// cover it if each place between is in reach of a ball, which is tested on the surface itself.
TEST(CoveringPieces, MeasureConcavePlacesBetweenSamples)
{
    const std::vector<Surface> surfaces{test::parabolic_cylinder(0.04, 6, 12)};
    const Part trough = surfaces;
    const BallCutter ball{5};
    const CoveredPart part{trough, ball, {0.01, 0.5}};
    const PartSamples samples = part.samples(1.5, 100'000);
    const auto contact = [&](double u, double v) {
        std::int32_t near = 0;
        const PassContact at = samples.contact({u, v}, 0);
        for (std::size_t i = 0; i < samples.size(); ++i)
            if ((samples.point(i) - at.at.contact.point).norm() <
                (samples.point(near) - at.at.contact.point).norm())
                near = static_cast<std::int32_t>(i);
        return samples.contact({u, v}, near);
    };
    const auto greatest_gap = [&](const CoveringPieces& covering) {
        double greatest = -5;
        for (double u = 0; u <= 1; u += 0.005)
            for (double v = 0; v <= 1; v += 0.02) {
                const CutterContact at = samples.contact({u, v}, 0).at.contact;
                double least = 5;
                for (const LaidPass& piece : covering.pieces()) {
                    const UprightSweep sweep{ball_centre(piece.contacts[0].at, ball),
                                             ball_centre(piece.contacts[1].at, ball)};
                    least = std::min(
                        least,
                        beyond_reach(sweep.squared_distance(at.point + 0.5 * at.normal),
                                     5));
                }
                greatest = std::max(greatest, least);
            }
        return greatest;
    };
    int covered = 0;
    for (double share = 0.1; share < 0.35; share += 0.002) {
        CoveringPieces covering{samples, ball, 0.5};
        for (const double u : {share, 0.5, 1 - share})
            covering.add({{contact(u, 0), contact(u, 1)}, false});
        const double gap = greatest_gap(covering);
        if (covering.missed().empty()) {
            ++covered;
            EXPECT_LT(gap, 2e-4) << share;
        } else {
            EXPECT_GT(gap, -2e-3) << share;
        }
    }
    EXPECT_GT(covered, 3);
}

}  // namespace
}  // namespace endmill
