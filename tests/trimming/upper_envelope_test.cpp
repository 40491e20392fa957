// SPDX-License-Identifier: GPL-3.0-or-later
// envelope_trimming_cgal_test.cpp compares the envelope with that of CGAL.
#include "endmill/trimming/detail/upper_envelope.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "endmill/trimming/detail/profile_families.h"
#include "random.h"
#include "trimmed_curves.h"
#include "trimming_vectors.h"

namespace endmill {
namespace {

UpperEnvelope envelope_of(const SectionCurve& curve)
{
    const PlanePoints plane{{&curve, 1}};
    return upper_envelope(plane.section());
}

std::vector<std::int32_t> carriers(const UpperEnvelope& envelope)
{
    std::vector<std::int32_t> result;
    for (const EnvelopePiece& piece : envelope.pieces)
        if (piece.segment != no_segment)
            result.push_back(piece.segment);
    return result;
}

TEST(UpperEnvelope, OfALoopPassesFromSegmentToSegmentInTheCrossing)
{
    const UpperEnvelope envelope =
        envelope_of(test::open_curve({{-6, 6}, {2, -2}, {0, -1}, {-2, -2}, {6, 6}}));
    EXPECT_EQ(carriers(envelope), (std::vector<std::int32_t>{0, 3}));
    const std::int32_t from = envelope.pieces.back().from;
    ASSERT_LT(from, 0);
    const EnvelopeCrossing& crossing = envelope.crossings.at(~from);
    EXPECT_LE(std::abs(crossing.s), crossing.error);
    EXPECT_LE(std::abs(crossing.z), crossing.error);
    EXPECT_EQ(envelope.end, 4);
}

TEST(UpperEnvelope, LeavesVerticalSegmentsOut)
{
    const UpperEnvelope envelope =
        envelope_of(test::open_curve({{0, 0}, {1, 0}, {1, 9}, {2, 9}}));
    EXPECT_EQ(carriers(envelope), (std::vector<std::int32_t>{0, 2}));
    EXPECT_EQ(envelope.verticals, (std::vector<std::int32_t>{1}));
}

// In the middle of each piece, the largest height of all segments, tested one after the
// other.
TEST(UpperEnvelope, IsTheHighestSegmentEverywhere)
{
    test::Random random{11};
    for (int run = 0; run < 20; ++run) {
        SectionCurve curve;
        for (int k = 0; k < 400; ++k)
            curve.points.emplace_back(random.uniform(0, run < 10 ? 50 : 5) + 0.1 * k,
                                      random.uniform(0, 5));
        const auto height = [&](std::int32_t segment, double s) {
            const SectionPoint& a = curve.points[segment];
            const SectionPoint& b = curve.points[segment + 1];
            return a[1] + (b[1] - a[1]) * (s - a[0]) / (b[0] - a[0]);
        };
        const UpperEnvelope envelope = envelope_of(curve);
        const auto place = [&](std::int32_t from) {
            return from >= 0 ? curve.points[from][0] : envelope.crossings[~from].s;
        };
        double covered = 0;
        for (std::size_t k = 0; k < envelope.pieces.size(); ++k) {
            if (envelope.pieces[k].segment == no_segment)
                continue;
            const double low = place(envelope.pieces[k].from);
            const double high =
                place(k + 1 < envelope.pieces.size() ? envelope.pieces[k + 1].from
                                                     : envelope.end);
            ASSERT_LE(low, high);
            covered += high - low;
            const double s = (low + high) / 2;
            for (std::int32_t segment = 0; segment + 1 < 400; ++segment) {
                const auto [a, b] =
                    std::minmax(curve.points[segment][0], curve.points[segment + 1][0]);
                if (a < s && s < b) {
                    EXPECT_LE(height(segment, s),
                              height(envelope.pieces[k].segment, s) + 1e-10);
                }
            }
        }
        const auto [least, largest] = std::ranges::minmax_element(
            curve.points, {}, [](const SectionPoint& point) { return point[0]; });
        EXPECT_NEAR(covered, (*largest)[0] - (*least)[0], 1e-9);
    }
}

// A roof of two segments, and below it a zigzag of 400 with one peak of the given height
// at s = 32, where the roof is 24 high. A vertical segment belongs to the zigzag.
SectionCurve roof_over_a_zigzag(double peak)
{
    SectionCurve curve = test::open_curve({{0, 16}, {64, 32}, {128, 16}, {128, 0}});
    test::Random random{5};
    for (int k = 0; k < 399; ++k) {
        if (k == 200)
            curve.points.emplace_back(32, peak);
        const double s = k == 199 ? 10 : k == 200 ? 50 : random.uniform(1, 127);
        curve.points.emplace_back(s, random.uniform(0, 4));
        if (k == 100)
            curve.points.emplace_back(s, 5);
    }
    return curve;
}

TEST(UpperEnvelope, LeavesOutSegmentsBelowIt)
{
    EXPECT_EQ(carriers(envelope_of(roof_over_a_zigzag(23))),
              (std::vector<std::int32_t>{0, 1}));
}

TEST(UpperEnvelope, HasThePeakOfAZigzagThatRisesAboveItByTheLastBit)
{
    const std::int32_t peak = 205;  // behind 4 vertices of the roof and 201 others
    EXPECT_EQ(carriers(envelope_of(roof_over_a_zigzag(24))),
              (std::vector<std::int32_t>{0, 1}));
    const std::vector<std::int32_t> found =
        carriers(envelope_of(roof_over_a_zigzag(std::nextafter(24.0, 25.0))));
    EXPECT_EQ(found, (std::vector<std::int32_t>{0, peak - 1, peak, 0, 1}));
}

// Every vertex of the zigzag, turned with the roof, lies below the roof or on it.
TEST(UpperEnvelope, LeavesOutAZigzagThatTouchesASteepRoof)
{
    for (const double slope : {0.5, -3.0, 1e6, 1e90}) {
        SectionCurve curve = test::open_curve({{0, 0}, {64, 64 * slope}});
        test::Random random{3};
        for (int k = 0; k < 200; ++k) {
            const double s = random.uniform(1, 63);
            // below the roof by far, but for some vertices that touch it at s = 32
            if (k % 50 == 49)
                curve.points.emplace_back(32, 32 * slope);
            else
                curve.points.emplace_back(
                    s, slope * s - random.uniform(1, 2) * std::abs(slope));
        }
        curve.points.insert(curve.points.begin() + 2,
                            {64, 64 * slope - 9 * std::abs(slope)});
        EXPECT_EQ(carriers(envelope_of(curve)), (std::vector<std::int32_t>{0})) << slope;
    }
}

using Ranges = std::vector<std::array<std::int32_t, 2>>;

// The carriers as ranges of consecutive segments: the first and the last of each.
Ranges carrier_ranges(const UpperEnvelope& envelope)
{
    Ranges result;
    std::int32_t before = no_segment;
    for (const std::int32_t segment : carriers(envelope)) {
        if (before == no_segment || std::abs(segment - before) != 1)
            result.push_back({segment, segment});
        result.back() = {std::min(result.back()[0], segment),
                         std::max(result.back()[1], segment)};
        before = segment;
    }
    return result;
}

// Whether the envelope of a profile has the listed carriers and joints.
bool is_as_listed(const UpperEnvelope& envelope, const nlohmann::json& listed)
{
    constexpr double last_bits = 1e-9;  // mm, effect of the last bits of sine and cosine
    if (carrier_ranges(envelope) != listed["carriers"].get<Ranges>())
        return false;
    std::vector<SectionPoint> crossings;
    for (const auto& joint : listed["joints"])
        if (joint.size() == 2)
            crossings.emplace_back(joint[0], joint[1]);
    std::size_t k = 0;
    for (const EnvelopePiece& piece : envelope.pieces) {
        // The first piece may be the gap left of all segments.
        if (piece.from >= 0 || piece.segment == no_segment)
            continue;
        const EnvelopeCrossing& found = envelope.crossings.at(~piece.from);
        if (k == crossings.size() ||
            (SectionPoint{found.s, found.z} - crossings[k]).norm() > last_bits)
            return false;
        ++k;
    }
    return k == crossings.size();
}

// Compares with rational arithmetic in another language:
// scripts/generation/upper_envelope.py.
void expect_as_listed(const std::string& family,
                      const std::vector<OffsetProfile>& profiles, int points)
{
    constexpr int other_libraries = 2;  // number of profiles that other last bits change
    const auto listed = test::offset_curves_json("random-families/" + family + ".json");
    ASSERT_EQ(profiles.size(), listed.size());
    int others = 0;
    for (std::size_t i = 0; i < profiles.size(); ++i)
        others +=
            !is_as_listed(envelope_of(offset_curve(profiles[i], points)), listed[i]);
    EXPECT_LE(others, other_libraries) << family;
}

TEST(UpperEnvelope, AgreesWithTheListForAllRandomProfiles)
{
    expect_as_listed("wavy", wavy_profiles(), 401);
    for (const int points : {41, 101, 401, 1601})
        expect_as_listed("convex-" + std::to_string(points), convex_profiles(points),
                         points);
}

}  // namespace
}  // namespace endmill
