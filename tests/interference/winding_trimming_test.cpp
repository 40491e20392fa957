// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/interference/winding_trimming.h"

#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/interference/envelope_trimming.h"
#include "endmill/interference/profile_families.h"
#include "trimmed_curves.h"
#include "trimming_vectors.h"

namespace endmill {
namespace {

using Points = std::vector<SectionPoint>;

std::vector<Points> points_of(const Trimmed& trimmed)
{
    std::vector<Points> result;
    for (const TrimmedCurve& curve : trimmed.curves) {
        result.emplace_back();
        for (const TrimmedPoint& point : curve.points)
            result.back().push_back(point.at);
    }
    return result;
}

std::vector<Points> winding(const std::vector<SectionCurve>& curves)
{
    return points_of(winding_trimming(curves));
}

SectionCurve closed_curve(Points points)
{
    points.push_back(points.front());
    return {std::move(points), true};
}

TEST(WindingTrimming, GivesWhatTheVectorsList)
{
    for (const test::TrimmingVector& vector : test::trimming_vectors()) {
        SCOPED_TRACE(vector.name);
        test::expect_points(test::points_left(winding_trimming({&vector.curve, 1})),
                            vector.winding, 4e-15);
    }
}

// Between the ends of the curve, where nothing hangs over.
void expect_as_envelope(const SectionCurve& curve)
{
    const double first = curve.points.front()[0];
    const double last = curve.points.back()[0];
    const auto inside = [&](const Trimmed& trimmed) {
        std::vector<TrimmedPoint> points;
        for (const TrimmedCurve& left : trimmed.curves)
            for (const TrimmedPoint& point : left.points)
                if (first < point.at[0] && point.at[0] < last)
                    points.push_back(point);
        return points;
    };
    const Trimmed trimmed = winding_trimming({&curve, 1});
    const auto result = inside(trimmed);
    const auto expected = inside(envelope_trimming({&curve, 1}));
    ASSERT_EQ(result.size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
        EXPECT_EQ(result[k].at, expected[k].at);
        EXPECT_EQ(result[k].on, expected[k].on);
        EXPECT_EQ(result[k].across, expected[k].across);
        EXPECT_EQ(result[k].kind, expected[k].kind);
    }
    ASSERT_EQ(trimmed.curves.size(), 1u);
    EXPECT_EQ(trimmed.curves[0].points.front().at[0], first);
    EXPECT_EQ(trimmed.curves[0].points.back().at[0], last);
}

TEST(WindingTrimming, IsTheEnvelopeOfHardProfiles)
{
    for (const OffsetProfile& profile : hard_profiles()) {
        SCOPED_TRACE(profile.name);
        expect_as_envelope(offset_curve(profile, 401));
    }
}

TEST(WindingTrimming, IsTheEnvelopeOfConvexProfiles)
{
    for (const OffsetProfile& profile : convex_profiles(41)) {
        SCOPED_TRACE(profile.name);
        expect_as_envelope(offset_curve(profile, 41));
    }
}

// The loop that a cutter makes in the bottom of a slot that widens downwards.
TEST(WindingTrimming, KeepsWhatHangsOver)
{
    const Points slot{{-5, 0}, {-1, 0}, {-2, -3}, {2, -3}, {1, 0}, {5, 0}};
    EXPECT_EQ(winding({test::open_curve(slot)}), (std::vector<Points>{slot}));
}

TEST(WindingTrimming, DropsWhatIsDetached)
{
    const SectionCurve ground = test::open_curve({{-5, 0}, {5, 0}});
    for (const SectionCurve& crescent : {closed_curve({{-1, -3}, {1, -3}, {0, -2}}),
                                         closed_curve({{-1, -3}, {0, -2}, {1, -3}})})
        EXPECT_EQ(winding({ground, crescent}), (std::vector<Points>{{{-5, 0}, {5, 0}}}));
}

TEST(WindingTrimming, HasTheToolInsideAClosedCurveThatRunsLeftRound)
{
    const SectionCurve pocket = closed_curve({{0, 0}, {4, 0}, {4, 3}, {0, 3}});
    EXPECT_EQ(winding({pocket}), (std::vector<Points>{pocket.points}));
    EXPECT_TRUE(winding_trimming({&pocket, 1}).curves.at(0).is_closed);
    const SectionCurve island = closed_curve({{1, 1}, {1, 2}, {2, 2}, {2, 1}});
    EXPECT_EQ(winding({pocket, island}),
              (std::vector<Points>{pocket.points, island.points}));
    // The other way round there is no tool inside, and two that run alike leave the outer one.
    EXPECT_EQ(winding({closed_curve({{0, 0}, {0, 3}, {4, 3}, {4, 0}})}).size(), 1u);
}

// The path of a disc of radius 2 inside an L of width 3 and 1: it does not get into the arm.
TEST(WindingTrimming, CutsTheLoopOfAPocketOff)
{
    const Points raw{{1, 1}, {9, 1}, {9, -1}, {3, -1}, {3, 5}, {1, 5}};
    const auto left = winding({closed_curve(raw)});
    ASSERT_EQ(left.size(), 1u);
    EXPECT_EQ(left[0], (Points{{1, 1}, {3, 1}, {3, 5}, {1, 5}, {1, 1}}));
}

TEST(WindingTrimming, TakesPiecesThatCancelOut)
{
    // There and back again: no material, no border.
    const Points there_and_back{{0, 0}, {4, 0}, {2, 0}, {6, 0}};
    EXPECT_EQ(winding({test::open_curve(there_and_back)}),
              (std::vector<Points>{{{0, 0}, {4, 0}, {6, 0}}}));
    EXPECT_TRUE(winding({closed_curve({{0, 0}, {4, 0}})}).empty());
    EXPECT_TRUE(winding({}).empty());
    EXPECT_TRUE(winding({test::open_curve({{1, 1}, {1, 1}})}).empty());
}

TEST(WindingTrimming, RefusesWhatIsNoNumber)
{
    const SectionCurve curve =
        test::open_curve({{0, 0}, {1, std::numeric_limits<double>::quiet_NaN()}});
    EXPECT_THROW(winding_trimming({&curve, 1}), DomainError);
}

}  // namespace
}  // namespace endmill
