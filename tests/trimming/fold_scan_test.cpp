// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/fold_scan.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/trimming/detail/sequence_trimming.h"

namespace endmill {
namespace {

PlaneSection section(std::vector<SectionPoint> points)
{
    PlaneSection made;
    made.curves.emplace_back().points = std::move(points);
    return made;
}

// A loop whose branches cross at the origin; its cusps are at z = -2.
const std::vector<SectionPoint> crossed_loop{{-6, 6}, {2, -2}, {0, -1}, {-2, -2}, {6, 6}};

TEST(FoldScan, FindsTheBranchesOfALoop)
{
    const std::vector<PlaneSection> sections{section(crossed_loop),
                                             section({{-1, 0}, {0, 1}, {1, 0}})};
    const std::vector<FoldToSearch> folds = first_literal_folds(sections);
    ASSERT_EQ(folds.size(), 1U) << "the second curve has no fold";
    const Branches& branches = folds[0].branches;
    EXPECT_EQ(branches.first_a, 0);
    EXPECT_EQ(branches.cusp_a, 1);
    EXPECT_EQ(branches.cusp_b, 3);
    EXPECT_EQ(branches.last_b, 4);
}

TEST(FoldScan, CrossingsAreThoseOfTheSearch)
{
    const std::vector<PlaneSection> sections{section(crossed_loop)};
    const auto found = crossings(first_literal_folds(sections), scan_segments, {});
    ASSERT_EQ(found.size(), 1U);
    ASSERT_TRUE(found[0].has_value());
    EXPECT_LT(found[0]->at.norm(), 1e-15);
}

// Method 1 scans downwards from z = 6, where both branches begin, to the crossing at z = 0.
TEST(FoldScan, OutcomeHasTheLinesDownToTheCrossing)
{
    const std::vector<PlaneSection> sections{section(crossed_loop)};
    const std::vector<FoldToSearch> folds = first_literal_folds(sections);
    const auto truth = crossings(folds, scan_segments, {});
    TrimmingOptions options;
    options.scan_step = 0.01;
    options.scan_threshold = 0.03;
    const ScanOutcome outcome = scan_outcome(folds, truth, options);
    EXPECT_EQ(outcome.hits, 1);
    EXPECT_EQ(outcome.missed, 0);
    EXPECT_EQ(outcome.false_hits, 0);
    EXPECT_LE(outcome.error_mm, 0.03);
    EXPECT_GT(outcome.lines, 50);
    EXPECT_LE(outcome.lines, 801) << "z from 6 to -2";

    options.scan_threshold = 1e-6;
    options.scan_step = 0.7;
    EXPECT_EQ(scan_outcome(folds, truth, options).missed, 1)
        << "no line lies near the crossing";
}

TEST(FoldScan, CountsAHitWithoutATrueCrossingAsFalse)
{
    const std::vector<PlaneSection> sections{section(crossed_loop)};
    const std::vector<FoldToSearch> folds = first_literal_folds(sections);
    TrimmingOptions options;
    options.scan_step = 0.01;
    options.scan_threshold = 0.03;
    EXPECT_EQ(scan_outcome(folds, {std::nullopt}, options).false_hits, 1);
}

}  // namespace
}  // namespace endmill
