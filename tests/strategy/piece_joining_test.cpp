// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/piece_joining.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "test_surfaces.h"

namespace endmill {
namespace {

// A plane of 40 x 20 mm and a ball of radius 5 mm. At a height of 1 mm the ball covers 3 mm on
// both sides of a pass.
class JoinedPieces : public testing::Test {
protected:
    PassContact contact(double x, double y) const
    {
        const Vec3 point{x, y, 0};
        std::int32_t near = 0;
        for (std::size_t i = 0; i < samples_.size(); ++i)
            if ((samples_.point(i) - point).norm() <
                (samples_.point(near) - point).norm())
                near = static_cast<std::int32_t>(i);
        return samples_.contact({x / 40, y / 20}, near);
    }

    void add_line(double y, double from, double to)
    {
        covering_.add({{contact(from, y), contact(to, y)}, false});
    }

    // The pieces after joining.
    std::vector<LaidPass> joined(const StrategyOptions& options = {})
    {
        join_pieces(covering_, samples_, part_, {1, 0.01}, options);
        std::vector<LaidPass> pieces;
        for (const LaidPass& piece : covering_.pieces())
            if (!piece.contacts.empty())
                pieces.push_back(piece);
        return pieces;
    }

    // The greatest distance of a place of the plane from the moves of pieces.
    static double greatest_distance(const std::vector<LaidPass>& pieces)
    {
        double greatest = 0;
        for (double x = 0; x <= 40; x += 0.1)
            for (double y = 0; y <= 20; y += 0.1) {
                double least = 100;
                for (const LaidPass& piece : pieces)
                    for (std::size_t k = 0; k < piece.contacts.size(); ++k)
                        least =
                            std::min(least, distance(piece.contacts[k > 0 ? k - 1 : 0],
                                                     piece.contacts[k], Vec3{x, y, 0}));
                greatest = std::max(greatest, least);
            }
        return greatest;
    }

    static double total_length(const std::vector<LaidPass>& pieces)
    {
        double sum = 0;
        for (const LaidPass& piece : pieces)
            sum += pass_length(piece);
        return sum;
    }

    Part plane_ = std::vector<Surface>{test::plane(40, 20)};
    BallCutter ball_{5};
    CoveredPart part_{plane_, ball_, {0.01, 1}};
    PartSamples samples_ = part_.samples(0.8, 100'000);
    CoveringPieces covering_{samples_, ball_, 1};

private:
    static double distance(const PassContact& from, const PassContact& to,
                           const Vec3& point)
    {
        const Vec3& a = from.at.contact.point;
        const Vec3 way = to.at.contact.point - a;
        const double share =
            way.squaredNorm() > 0
                ? std::clamp((point - a).dot(way) / way.squaredNorm(), 0.0, 1.0)
                : 0;
        return (a + share * way - point).norm();
    }
};

// Three parts of a line with gaps of 2 mm, a third of a strip, become one piece.
TEST_F(JoinedPieces, OfOneLineBridgeItsGaps)
{
    add_line(10, 28, 40);
    add_line(10, 0, 12);
    add_line(10, 14, 26);
    const std::vector<LaidPass> pieces = joined();
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_LE(total_length(pieces), 40 + 1e-9);
    EXPECT_GT(total_length(pieces), 30);
}

// A straight link is clear here, and a contact link of more than 0.6 strips does not pay.
TEST_F(JoinedPieces, KeepDistantEndsApart)
{
    add_line(2, 0, 40);
    add_line(7, 0, 40);
    EXPECT_EQ(joined().size(), 2u);
}

// Two lines overlap by 14 mm, which are cut only once.
TEST_F(JoinedPieces, AreCutBack)
{
    for (const double y : {2.0, 7.0, 12.0})
        add_line(y, 0, 40);
    add_line(17, 0, 22);
    add_line(17, 8, 40);
    const std::vector<LaidPass> pieces = joined();
    EXPECT_EQ(pieces.size(), 4u);
    EXPECT_LE(greatest_distance(pieces), 3 + 1e-3);
    EXPECT_LT(total_length(pieces), 4 * 40);
}

// A dot that covers a gap between two lines becomes a detour of one of them.
TEST_F(JoinedPieces, LeadOverShortPieces)
{
    add_line(2.5, 0, 40);
    covering_.add(
        {{contact(0, 8), contact(16, 8), contact(20, 9), contact(24, 8), contact(40, 8)},
         false});
    add_line(13, 0, 40);
    add_line(18, 0, 40);
    covering_.add({{contact(20, 5.7)}, false});
    ASSERT_TRUE(covering_.missed().empty());
    const std::vector<LaidPass> pieces = joined();
    EXPECT_EQ(pieces.size(), 4u);
    EXPECT_LE(greatest_distance(pieces), 3 + 1e-3);
}

// A bow that nothing needs becomes straight.
TEST_F(JoinedPieces, AreStraight)
{
    for (const double y : {2.0, 12.0, 17.0})
        add_line(y, 0, 40);
    covering_.add({{contact(0, 7), contact(15, 7), contact(20, 7.8), contact(25, 7),
                    contact(40, 7)},
                   false});
    const std::vector<LaidPass> pieces = joined();
    EXPECT_LE(greatest_distance(pieces), 3 + 1e-3);
    EXPECT_LT(total_length(pieces), 4 * 40 + 0.01);
}

TEST_F(JoinedPieces, KeepTheirDirectionInOneWayOrder)
{
    for (const double y : {2.5, 7.5, 12.5, 17.5})
        add_line(y, 0, 40);
    StrategyOptions options;
    options.link.order = PassOrder::OneWay;
    const std::vector<LaidPass> pieces = joined(options);
    EXPECT_EQ(pieces.size(), 4u);
    for (const LaidPass& piece : pieces)
        EXPECT_LT(piece.contacts.front().at.contact.point.x(),
                  piece.contacts.back().at.contact.point.x());
}

TEST_F(JoinedPieces, AClosedPieceReturnsToItsStart)
{
    const LaidPass ring{{contact(5, 5), contact(15, 5), contact(15, 15)}, true};
    const LaidPass spot{{contact(16, 16)}, false};
    const std::vector<LaidPass> pieces{ring, spot};
    const std::vector<OrderedPiece> order = cutting_order(pieces, ball_, {});
    ASSERT_EQ(order.size(), 2u);
    const std::size_t place = order[0].piece == 0 ? 0 : 1;
    EXPECT_EQ(order[place].start, 2u) << "the corner beside the spot";
    const std::vector<PassContact> contacts = contacts_in_order(ring, order[place]);
    ASSERT_EQ(contacts.size(), 4u);
    for (const std::size_t end : {0, 3})
        EXPECT_LT((contacts[end].at.contact.point - Vec3(15, 15, 0)).norm(), 1e-9);
}

}  // namespace
}  // namespace endmill
