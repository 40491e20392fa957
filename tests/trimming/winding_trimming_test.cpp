// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/winding_trimming.h"

#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/trimming/detail/envelope_trimming.h"
#include "endmill/trimming/detail/profile_families.h"
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

TEST(WindingTrimming, AgreesWithTheTestVectors)
{
    for (const test::TrimmingVector& vector : test::trimming_vectors()) {
        SCOPED_TRACE(vector.name);
        test::expect_points(test::points_left(winding_trimming({&vector.curve, 1})),
                            vector.winding, 4e-15);
    }
}

// Compares with the envelope between the ends of the curve, where nothing overhangs.
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

TEST(WindingTrimming, IsTheEnvelopeOfWavyProfiles)
{
    for (const OffsetProfile& profile : wavy_profiles()) {
        SCOPED_TRACE(profile.name);
        expect_as_envelope(offset_curve(profile, 401));
    }
}

// All profiles with few points; a part of the others, to save time.
TEST(WindingTrimming, IsTheEnvelopeOfConvexProfiles)
{
    const std::pair<int, std::size_t> samplings[]{
        {41, 1}, {101, 1}, {401, 5}, {1601, 25}};
    for (const auto& [points, step] : samplings) {
        const auto profiles = convex_profiles(points);
        for (std::size_t k = 0; k < profiles.size(); k += step) {
            SCOPED_TRACE(std::to_string(points) + " of " + profiles[k].name);
            expect_as_envelope(offset_curve(profiles[k], points));
        }
    }
}

// The loop that a cutter makes at the bottom of a slot that widens downwards.
TEST(WindingTrimming, KeepsOverhangs)
{
    const Points slot{{-5, 0}, {-1, 0}, {-2, -3}, {2, -3}, {1, 0}, {5, 0}};
    EXPECT_EQ(winding({test::open_curve(slot)}), (std::vector<Points>{slot}));
}

// The vertical step of one curve ends where the other curve crosses it, not at its own
// end.
TEST(WindingTrimming, EndsWhereAVerticalSegmentIsCrossed)
{
    const SectionCurve stepped = test::open_curve({{0, 1}, {2, 2}, {2, 0}, {2, 2}});
    const SectionCurve passing =
        test::open_curve({{1, 0}, {3, 2}, {0, 1}, {3, 0}, {2, 0}});
    const auto left = winding({stepped, passing});
    ASSERT_EQ(left.size(), 1U);
    test::expect_points(
        left[0], {{0, 1}, {2, 2}, {2, 5.0 / 3}, {0, 1}, {1.5, 0.5}, {2, 1}, {2, 1.0 / 3}},
        1e-15);
    const Trimmed trimmed = winding_trimming(std::vector{stepped, passing});
    const TrimmedPoint& last = trimmed.curves[0].points.back();
    EXPECT_EQ(last.kind, TrimmedKind::Crossing);
    EXPECT_EQ(last.on, (SegmentNumber{0, 1}));
    EXPECT_EQ(last.across, (SegmentNumber{1, 2}));
}

// Curves on a small grid of integers, with many degenerate cases.
std::vector<SectionCurve> whole_number_curves(std::mt19937_64& random)
{
    const auto below = [&](std::uint64_t bound) {
        return static_cast<double>(random() % bound);
    };
    std::vector<SectionCurve> curves;
    for (int c = 0; c < 2; ++c) {
        Points points;
        for (int k = 0; k < 5; ++k)
            points.emplace_back(below(4), below(4));
        if (points.front() == points.back())
            points.back().x() += 1;
        if (points.front().x() > points.back().x())
            std::ranges::reverse(points);
        curves.push_back(test::open_curve(points));
    }
    return curves;
}

bool lies_on(const SectionPoint& point, const SectionPoint& from, const SectionPoint& to)
{
    constexpr double coordinate_rounding = 1e-14;
    const SectionPoint way = to - from;
    const SectionPoint off = point - from;
    return std::abs(way.x() * off.y() - way.y() * off.x()) <= coordinate_rounding &&
           off.dot(way) >= -coordinate_rounding &&
           (point - to).dot(way) <= coordinate_rounding;
}

bool lies_on_one_segment(const SectionPoint& from, const SectionPoint& to,
                         const std::vector<SectionCurve>& curves)
{
    for (const SectionCurve& curve : curves)
        for (std::size_t k = 1; k < curve.points.size(); ++k)
            if (lies_on(from, curve.points[k - 1], curve.points[k]) &&
                lies_on(to, curve.points[k - 1], curve.points[k]))
                return true;
    return false;
}

// The index of a point with no vertex vertically above it: the crossings of a ray
// upwards.
int index_at(const SectionPoint& place, const std::vector<SectionCurve>& curves)
{
    int index = 0;
    for (const SectionCurve& curve : curves)
        for (std::size_t k = 1; k < curve.points.size(); ++k) {
            const SectionPoint& from = curve.points[k - 1];
            const SectionPoint& to = curve.points[k];
            if ((from.x() < place.x()) == (to.x() < place.x()))
                continue;
            const double share = (place.x() - from.x()) / (to.x() - from.x());
            if (from.y() + share * (to.y() - from.y()) > place.y())
                index += from.x() < to.x() ? -1 : 1;
        }
    return index;
}

// A point slightly left of the middle of a piece, and not vertically below a vertex.
SectionPoint left_of(const std::pair<SectionPoint, SectionPoint>& piece)
{
    const SectionPoint way = (piece.second - piece.first).normalized();
    const SectionPoint middle = (piece.first + piece.second) / 2;
    return middle + 1e-5 * SectionPoint{-way.y(), way.x()} + SectionPoint{1e-7, 0};
}

// Whether two pieces of a result have more than one point in common.
bool overlap(const std::pair<SectionPoint, SectionPoint>& one,
             const std::pair<SectionPoint, SectionPoint>& other)
{
    const SectionPoint middle = (one.first + one.second) / 2;
    return lies_on(middle, other.first, other.second) &&
           (lies_on(one.first, other.first, other.second) ||
            lies_on(one.second, other.first, other.second)) &&
           std::abs((one.second - one.first).x() * (other.second - other.first).y() -
                    (one.second - one.first).y() * (other.second - other.first).x()) <
               1e-14;
}

// Each piece of a result is a piece of a segment, has no material on its left, and occurs
// once.
TEST(WindingTrimming, LeavesPiecesOfSegmentsEachOnce)
{
    std::mt19937_64 random{20};
    for (int trial = 0; trial < 1000; ++trial) {
        SCOPED_TRACE(trial);
        const auto curves = whole_number_curves(random);
        std::vector<std::pair<SectionPoint, SectionPoint>> pieces;
        for (const Points& points : winding(curves))
            for (std::size_t k = 1; k < points.size(); ++k)
                pieces.emplace_back(points[k - 1], points[k]);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            EXPECT_TRUE(lies_on_one_segment(pieces[i].first, pieces[i].second, curves));
            EXPECT_GE(index_at(left_of(pieces[i]), curves), 0);
            for (std::size_t k = 0; k < pieces.size(); ++k)
                EXPECT_FALSE(i != k && overlap(pieces[i], pieces[k]));
        }
    }
}

TEST(WindingTrimming, DropsDetachedPieces)
{
    const SectionCurve ground = test::open_curve({{-5, 0}, {5, 0}});
    for (const SectionCurve& crescent : {closed_curve({{-1, -3}, {1, -3}, {0, -2}}),
                                         closed_curve({{-1, -3}, {0, -2}, {1, -3}})})
        EXPECT_EQ(winding({ground, crescent}), (std::vector<Points>{{{-5, 0}, {5, 0}}}));
}

TEST(WindingTrimming, KeepsTheInsideOfACounterClockwiseCurve)
{
    const SectionCurve pocket = closed_curve({{0, 0}, {4, 0}, {4, 3}, {0, 3}});
    EXPECT_EQ(winding({pocket}), (std::vector<Points>{pocket.points}));
    EXPECT_TRUE(winding_trimming({&pocket, 1}).curves.at(0).is_closed);
    const SectionCurve island = closed_curve({{1, 1}, {1, 2}, {2, 2}, {2, 1}});
    EXPECT_EQ(winding({pocket, island}),
              (std::vector<Points>{pocket.points, island.points}));
    // In the opposite direction no tool is inside. Of two curves with the same direction
    // the outer one remains.
    EXPECT_EQ(winding({closed_curve({{0, 0}, {0, 3}, {4, 3}, {4, 0}})}).size(), 1u);
}

// The path of a disc of radius 2 inside an L of widths 3 and 1. The disc does not fit
// into the narrow arm.
TEST(WindingTrimming, CutsTheLoopOfAPocketOff)
{
    const Points raw{{1, 1}, {9, 1}, {9, -1}, {3, -1}, {3, 5}, {1, 5}};
    const auto left = winding({closed_curve(raw)});
    ASSERT_EQ(left.size(), 1u);
    EXPECT_EQ(left[0], (Points{{1, 1}, {3, 1}, {3, 5}, {1, 5}, {1, 1}}));
}

TEST(WindingTrimming, TakesPiecesThatCancelOut)
{
    // A curve that returns on itself has no material and no border.
    const Points there_and_back{{0, 0}, {4, 0}, {2, 0}, {6, 0}};
    EXPECT_EQ(winding({test::open_curve(there_and_back)}),
              (std::vector<Points>{{{0, 0}, {4, 0}, {6, 0}}}));
    EXPECT_TRUE(winding({closed_curve({{0, 0}, {4, 0}})}).empty());
    EXPECT_TRUE(winding({}).empty());
    EXPECT_TRUE(winding({test::open_curve({{1, 1}, {1, 1}})}).empty());
}

TEST(WindingTrimming, RefusesNonFiniteCoordinates)
{
    const SectionCurve curve =
        test::open_curve({{0, 0}, {1, std::numeric_limits<double>::quiet_NaN()}});
    EXPECT_THROW(winding_trimming({&curve, 1}), DomainError);
}

}  // namespace
}  // namespace endmill
