// SPDX-License-Identifier: GPL-3.0-or-later
// Against CGAL's envelope: envelope_by_cgal_test.cpp.
#include "endmill/interference/upper_envelope.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "random.h"
#include "trimmed_curves.h"

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

// The largest of all segments in the middle of each piece, one after the other.
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

}  // namespace
}  // namespace endmill
