// SPDX-License-Identifier: GPL-3.0-or-later
// envelope_trimming_cgal_test.cpp compares the envelope with that of CGAL.
#include "endmill/trimming/detail/envelope_trimming.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/trimming/detail/profile_families.h"
#include "endmill/trimming/trimming_quality.h"
#include "random.h"
#include "trimmed_curves.h"
#include "trimming_vectors.h"

namespace endmill {
namespace {

using Points = std::vector<SectionPoint>;

std::vector<Points> envelope(const std::vector<SectionCurve>& curves)
{
    std::vector<Points> result;
    for (const TrimmedCurve& curve : envelope_trimming(curves).curves) {
        result.emplace_back();
        for (const TrimmedPoint& point : curve.points)
            result.back().push_back(point.at);
    }
    return result;
}

Points envelope(const Points& points)
{
    const auto curves = envelope(std::vector{test::open_curve(points)});
    EXPECT_EQ(curves.size(), 1u);
    return curves.front();
}

TEST(EnvelopeTrimming, AgreesWithTheTestVectors)
{
    for (const test::TrimmingVector& vector : test::trimming_vectors()) {
        SCOPED_TRACE(vector.name);
        // The listed fractions are of decimals, which doubles represent only
        // approximately.
        test::expect_points(envelope(vector.curve.points), vector.envelope, 4e-15);
    }
}

TEST(EnvelopeTrimming, HasTheCarriersAndJointsListedForHardProfiles)
{
    const auto json = test::offset_curves_json("hard-cases.json");
    const auto profiles = hard_profiles();
    for (std::size_t i = 0; i < profiles.size(); ++i) {
        SCOPED_TRACE(profiles[i].name);
        const SectionCurve curve = offset_curve(profiles[i], 401);
        const Trimmed trimmed = envelope_trimming({&curve, 1});
        ASSERT_EQ(trimmed.curves.size(), 1u);
        std::vector<TrimmedPoint> crossings;
        std::vector<std::int32_t> vertices;
        for (const TrimmedPoint& point : trimmed.curves.front().points) {
            if (point.kind == TrimmedKind::Crossing)
                crossings.push_back(point);
            if (point.kind == TrimmedKind::Vertex)
                vertices.push_back(point.on.point);
        }
        std::vector<std::int32_t> inner_vertices;
        for (const auto& range : json["cases"][i]["carriers"])
            for (std::int32_t k = range[0].get<int>() + 1; k <= range[1].get<int>(); ++k)
                inner_vertices.push_back(k);
        for (const std::int32_t vertex : inner_vertices)
            EXPECT_EQ(std::ranges::count(vertices, vertex), 1) << vertex;
        auto crossing = crossings.begin();
        for (const auto& joint : json["cases"][i]["joints"]) {
            if (joint["kind"] != "crossing")
                continue;
            ASSERT_NE(crossing, crossings.end());
            EXPECT_EQ(crossing->on.point, joint["segments"][0]);
            EXPECT_EQ(crossing->across.point, joint["segments"][1]);
            EXPECT_NEAR(crossing->at[0], joint["sampled"][0].get<double>(), 1e-9);
            EXPECT_NEAR(crossing->at[1], joint["sampled"][1].get<double>(), 1e-9);
            ++crossing;
        }
        EXPECT_EQ(crossing, crossings.end());
    }
}

void expect_right(const OffsetProfile& profile, int points)
{
    SCOPED_TRACE(profile.name);
    const SectionCurve curve = offset_curve(profile, points);
    const auto quality = trimming_quality({&curve, 1}, envelope_trimming({&curve, 1}));
    EXPECT_TRUE(
        is_right(quality, {.step_back_mm = 0, .gouge_mm = 1e-12, .uncovered = 1e-12}));
}

TEST(EnvelopeTrimming, IsRightOnAllFamilies)
{
    for (const OffsetProfile& profile : hard_profiles())
        expect_right(profile, 401);
    for (const OffsetProfile& profile : wavy_profiles())
        expect_right(profile, 401);
    for (const int points : {41, 101, 401})
        for (const OffsetProfile& profile : convex_profiles(points))
            expect_right(profile, points);
}

TEST(EnvelopeTrimming, KeepsSpikesAndStandsOnTheirFeet)
{
    EXPECT_EQ(envelope(Points{{0, 0}, {2, 2}, {2, 9}, {2, 2}, {4, 4}}),
              (Points{{0, 0}, {2, 2}, {2, 9}, {2, 2}, {4, 4}}));
    const std::vector curves{test::open_curve({{0, 0}, {4, 4}}),
                             test::open_curve({{1, -3}, {1, 5}})};
    EXPECT_EQ(envelope(curves),
              (std::vector<Points>{{{0, 0}, {1, 1}, {1, 5}, {1, 1}, {4, 4}}}));
    const Trimmed trimmed = envelope_trimming(curves);
    const TrimmedPoint& foot = trimmed.curves[0].points[1];
    EXPECT_EQ(foot.kind, TrimmedKind::Crossing);
    EXPECT_EQ(foot.across, (SegmentNumber{1, 0}));
}

TEST(EnvelopeTrimming, BeginsAtTheTopOfAWall)
{
    EXPECT_EQ(envelope(Points{{0, 5}, {0, 0}, {3, 0}}), (Points{{0, 5}, {0, 0}, {3, 0}}));
    EXPECT_EQ(envelope(Points{{0, 0}, {0, 5}, {3, 5}}), (Points{{0, 5}, {3, 5}}));
    EXPECT_EQ(envelope(Points{{0, 3}, {0, 1}, {0, 5}}), (Points{{0, 1}, {0, 5}}));
}

TEST(EnvelopeTrimming, BreaksWhereNoCurveLies)
{
    const std::vector curves{
        test::open_curve({{5, 0}, {6, 1}}), test::open_curve({{0, 0}, {2, 0}}),
        test::open_curve({{3, 1}, {3, 2}}), test::open_curve({{2, 1}, {1, 1}})};
    EXPECT_EQ(envelope(curves),
              (std::vector<Points>{
                  {{0, 0}, {1, 0}, {1, 1}, {2, 1}}, {{3, 1}, {3, 2}}, {{5, 0}, {6, 1}}}));
}

TEST(EnvelopeTrimming, WithoutCurvesIsEmpty)
{
    EXPECT_TRUE(envelope(std::vector<SectionCurve>{}).empty());
    EXPECT_TRUE(envelope(std::vector<SectionCurve>(3)).empty());
    EXPECT_TRUE(envelope(std::vector{test::open_curve({{1, 2}})}).empty());
    EXPECT_TRUE(envelope(std::vector{test::open_curve({{1, 2}, {1, 2}})}).empty());
}

TEST(EnvelopeTrimming, IsCarriedByTheFirstOfSegmentsThatCoincide)
{
    const std::vector curves{test::open_curve({{2, 2}, {6, 6}}),
                             test::open_curve({{0, 0}, {8, 8}}),
                             test::open_curve({{0, 0}, {1, 1}, {8, 8}})};
    const Trimmed trimmed = envelope_trimming(curves);
    const auto& points = trimmed.curves.at(0).points;
    std::vector<SegmentNumber> vertices;
    for (const TrimmedPoint& point : points)
        vertices.push_back(point.on);
    EXPECT_EQ(vertices, (std::vector<SegmentNumber>{{1, 0}, {0, 0}, {0, 1}, {1, 1}}));
}

// All coordinates times 2^k, for the smallest and the largest numbers, whose products
// would underflow or overflow.
TEST(EnvelopeTrimming, SupportsAnySize)
{
    for (const test::TrimmingVector& vector : test::trimming_vectors()) {
        SCOPED_TRACE(vector.name);
        const Points expected = envelope(vector.curve.points);
        for (const double scale : {0x1p-1000, 0x1p-500, 0x1p+240, 0x1p+300, 0x1p+1017}) {
            Points points = vector.curve.points;
            for (SectionPoint& point : points)
                point *= scale;
            Points result = envelope(points);
            for (SectionPoint& point : result)
                point /= scale;
            EXPECT_EQ(result, expected) << scale;
        }
    }
}

TEST(EnvelopeTrimming, MirroredIsTheMirrorImage)
{
    test::Random random{3};
    for (int k = 0; k < 300; ++k) {
        Points points;
        for (int i = 0; i < 40; ++i)
            points.emplace_back(std::floor(random.uniform(0, 12)),
                                std::floor(random.uniform(0, 12)));
        Points expected = envelope(points);
        std::ranges::reverse(expected);
        for (SectionPoint& point : expected)
            point[0] = 0 - point[0];
        for (SectionPoint& point : points)
            point[0] = -point[0];
        EXPECT_EQ(envelope(points), expected);
    }
}

// Long chains above each other, so that the stack of envelopes is used. The tips of the
// teeth rise, and their envelope has a closed form.
TEST(EnvelopeTrimming, OfManyLongTeethIsTheirTips)
{
    constexpr int teeth = 3000;
    Points points;
    for (int k = 0; k < teeth; ++k) {
        points.emplace_back(k % 2 == 0 ? -teeth : teeth, -1);
        const int place = (k * 1789) % teeth;  // 1789 is prime
        points.emplace_back(place, 1);
    }
    Points tips;
    for (const SectionPoint& point : envelope(points))
        if (point[1] == 1)
            tips.push_back(point);
    ASSERT_EQ(tips.size(), static_cast<std::size_t>(teeth));
    for (int k = 0; k < teeth; ++k)
        EXPECT_EQ(tips[k], SectionPoint(k, 1));
}

TEST(EnvelopeTrimming, RefusesNonFiniteCoordinates)
{
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()}) {
        const SectionCurve curve = test::open_curve({{0, 0}, {1, bad}, {2, 0}});
        EXPECT_THROW(envelope_trimming({&curve, 1}), DomainError);
    }
}

}  // namespace
}  // namespace endmill
