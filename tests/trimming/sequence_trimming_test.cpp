// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/sequence_trimming.h"

#include <gtest/gtest.h>

#include "endmill/trimming/detail/distance_trimming.h"
#include "endmill/trimming/detail/line_trimming.h"
#include "endmill/trimming/detail/profile_families.h"
#include "endmill/trimming/detail/section_runs.h"
#include "trimmed_curves.h"

namespace endmill {
namespace {

constexpr std::array both_detections{FoldDetection::Literal, FoldDetection::Guarded};

struct Sampled {
    SectionCurve curve;
    double radius;
};

std::vector<Sampled> all_families()
{
    std::vector<Sampled> curves;
    const auto append = [&](const std::vector<OffsetProfile>& profiles, int points) {
        for (const OffsetProfile& profile : profiles)
            curves.push_back({offset_curve(profile, points), profile.radius});
    };
    append(hard_profiles(), 401);
    append(wavy_profiles(), 401);
    for (const int points : {41, 101, 401})
        append(convex_profiles(points), points);
    return curves;
}

TEST(March, AgreesWithTheScan)
{
    for (const Sampled& sampled : all_families()) {
        for (const FoldDetection detection : both_detections) {
            const TrimmingOptions march{.detection = detection};
            const TrimmingOptions scan{.detection = detection,
                                       .search = BranchSearch::Scan};
            ASSERT_EQ(test::points_left(test::trim("3", sampled.curve, march)),
                      test::points_left(test::trim("3", sampled.curve, scan)));
        }
    }
}

TEST(March, FindsACrossingInACommonVertex)
{
    const SectionCurve curve =
        test::open_curve({{-4, 4}, {0, 0}, {1, -1}, {0, -0.5}, {-1, -1}, {0, 0}, {4, 4}});
    for (const FoldDetection detection : both_detections) {
        EXPECT_EQ(test::points_left(test::trim("3", curve, {.detection = detection})),
                  (std::vector<SectionPoint>{{-4, 4}, {0, 0}, {4, 4}}));
    }
}

// docs/methods/interference.md, section 11, T5: nested loops. Branch B, the fourth run of
// dz, does not reach A; the sixth run does, in (0, 0).
TEST(ScanToEnd, FindsACrossingBehindBranchB)
{
    const SectionCurve nested = test::open_curve(
        {{-10, 10}, {4, -4}, {-2, -3}, {0, -3.6}, {2, -3.1}, {-4, -4}, {10, 10}});
    const auto trimmed_by = [&](BranchSearch search) {
        return test::points_left(test::trim(
            "3", nested, {.detection = FoldDetection::Literal, .search = search}));
    };
    const std::vector<SectionPoint> exact{{-10, 10}, {0, 0}, {10, 10}};
    EXPECT_EQ(trimmed_by(BranchSearch::ScanToEnd), exact);
    EXPECT_NE(trimmed_by(BranchSearch::Scan), exact);
}

TEST(ScanToEnd, WithGuardedDetectionIsTheScan)
{
    for (const Sampled& sampled : all_families())
        ASSERT_EQ(test::points_left(test::trim("3", sampled.curve,
                                               {.search = BranchSearch::ScanToEnd})),
                  test::points_left(
                      test::trim("3", sampled.curve, {.search = BranchSearch::Scan})));
}

// The two runs forward in s at the first fold of a curve.
std::optional<Branches> first_fold(const SectionChain& chain, double band)
{
    std::vector<SectionRun> forward;
    RunReader reader{chain, RunAxis::S, band, chain.first()};
    while (const auto run = reader.next()) {
        if (run->grows)
            forward.push_back(*run);
    }
    if (forward.size() < 2)
        return std::nullopt;
    return Branches{forward[0].first, forward[0].last, forward[1].first, forward[1].last};
}

// The segments of B come first, so that a crossing of B is also the first one up to the
// end of the curve.
TEST(ScanToEnd, FindsEveryCrossingOfTheScan)
{
    const TrimmingOptions literal{.detection = FoldDetection::Literal};
    int found_by_both = 0;
    int found_behind = 0;
    for (const Sampled& sampled : all_families()) {
        const SectionChain chain{sampled.curve.points, 0};
        const auto fold = first_fold(chain, dead_band(sampled.curve.points));
        if (!fold)
            continue;
        const auto in_run = scan_segments(chain, *fold, literal);
        const auto to_end = scan_to_end(chain, *fold, literal);
        if (in_run) {
            ASSERT_TRUE(to_end);
            EXPECT_EQ(to_end->at, in_run->at);
            ++found_by_both;
        } else {
            found_behind += to_end.has_value();
        }
    }
    EXPECT_GT(found_by_both, 600);
    EXPECT_GT(found_behind, 0);
}

// The error bound of method 1 for the threshold 1, in s and in z.
SectionPoint bound(const SectionChain& chain, const ChainCrossing& crossing)
{
    const auto slope = [&](std::int32_t segment) {
        const SectionPoint along = chain.at(chain.next(segment)) - chain.at(segment);
        return along.x() / along.y();
    };
    const double a = slope(crossing.segment_a);
    const double b = slope(crossing.segment_b);
    return {std::max(0.5, std::abs((a + b) / (b - a)) / 2), 1 / std::abs(b - a)};
}

TEST(Searches, AgreeWhereAllFindACrossing)
{
    int found = 0;
    int false_hits = 0;
    for (const Sampled& sampled : all_families()) {
        const SectionChain chain{sampled.curve.points, 0};
        // With few points the branches bend within the reach of the threshold.
        constexpr std::size_t many_points = 300;
        if (sampled.curve.points.size() < many_points)
            continue;
        const auto fold = first_fold(chain, dead_band(sampled.curve.points));
        if (!fold)
            continue;
        const double threshold = 4e-3 * sampled.radius;
        const TrimmingOptions options{.scan_step = threshold / 4,
                                      .scan_threshold = threshold};
        const auto by_distance = search_by_distance(chain, *fold, options);
        const auto by_lines = search_by_lines(chain, *fold, options);
        const auto in_sequence = search_in_sequence(chain, *fold, options);
        false_hits += by_distance && !in_sequence;
        if (!by_distance || !by_lines || !in_sequence)
            continue;
        ++found;
        EXPECT_LE((by_lines->at - in_sequence->at).norm(), 1e-12);
        const SectionPoint error = (by_distance->at - in_sequence->at).cwiseAbs();
        const SectionPoint most = 1.2 * threshold * bound(chain, *in_sequence);
        EXPECT_LE(error.x(), most.x());
        EXPECT_LE(error.y(), most.y());
    }
    EXPECT_GT(found, 600);
    RecordProperty("false_hits_of_method_1", false_hits);
    EXPECT_LT(false_hits, found / 50);
}

}  // namespace
}  // namespace endmill
