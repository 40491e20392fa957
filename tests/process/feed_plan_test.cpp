// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/feed_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/process/cutting_coefficients.h"
#include "endmill/process/detail/segment_load.h"
#include "milling_examples.h"
#include "random.h"
#include "reference_path.h"

namespace endmill {
namespace {

using std::numbers::pi;
using test::relative_error;

MillingJob steel_job()
{
    return {test::steel(), test::ball_10(), test::mill_3000()};
}

MillingJob aluminium_job()
{
    MillingJob job = steel_job();
    job.material.specific_resistance_n_per_mm2 = 99.55 * 9.80665;
    job.material.edge_thickness_mm = 0.03;
    job.material.max_feed_per_tooth_mm = 0.25;
    return job;
}

// The path REF, scaled to the length that the paper prints.
std::vector<SegmentCut> scaled_reference_cuts()
{
    std::vector<SegmentCut> cuts = test::reference_cuts();
    for (SegmentCut& cut : cuts)
        cut.length_mm *= 5385.6 / 5315.028783;
    return cuts;
}

double share(const FeedPlan& plan, FeedLimit limit)
{
    return plan.totals.limit_shares[static_cast<std::size_t>(limit)];
}

double share(const FeedPlan& plan, SpeedLimit limit)
{
    return plan.totals.speed_limit_shares[static_cast<std::size_t>(limit)];
}

// docs/methods/ball-end-milling.md, section 9, A14.
TEST(FeedPlan, OfASlotIsClosed)
{
    MillingJob job = steel_job();
    job.material.specific_resistance_n_per_mm2 = 2000;
    job.tool.limits.cutting_force_n = 1200;
    job.tool.limits.thrust_n = job.tool.limits.torque_n_m = std::nullopt;
    job.machine = {};
    const SegmentCut slot{
        .length_mm = 100, .depth_mm = 5, .previous = PreviousPass::None};
    const FeedPlan plan = feed_plan(std::vector{slot}, job, {.accuracy = 1e-11});
    ASSERT_EQ(plan.rows.size(), 1U);
    EXPECT_LT(relative_error(plan.rows[0].tooth.feed_per_tooth_mm, 0.072097110475), 1e-9);
    EXPECT_LT(relative_error(plan.rows[0].table.spindle_rpm, 904.996386706), 1e-9);
    EXPECT_LT(relative_error(plan.rows[0].table.feed_mm_per_min, 130.495248944), 1e-9);
    EXPECT_LT(relative_error(plan.totals.cut_min, 100 / 130.495248944), 1e-9);
    EXPECT_EQ(share(plan, FeedLimit::CuttingForce), 1);
    EXPECT_EQ(share(plan, SpeedLimit::EconomicSpeed), 1);
}

// docs/methods/ball-end-milling.md, section 7: facts of the path REF.
TEST(ReferencePath, HasTheStatedLengthAndRanges)
{
    const std::vector<double> passes = test::reference_passes();
    ASSERT_EQ(passes.size(), 40U);
    EXPECT_NEAR(passes[38], 38.91865603, 1e-8);
    EXPECT_NEAR(passes[37], 36.61371758, 1e-8);
    EXPECT_NEAR(passes[1], -37.74744338, 1e-8);
    const std::vector<SegmentCut> cuts = test::reference_cuts();
    ASSERT_EQ(cuts.size(), 1625U);
    const auto sum = [&](auto of) {
        double total = 0;
        for (const SegmentCut& cut : cuts)
            total += of(cut);
        return total;
    };
    EXPECT_NEAR(sum([](const SegmentCut& cut) { return cut.length_mm; }), 5315.028783,
                1e-5);
    EXPECT_NEAR(sum([](const SegmentCut& cut) { return cut.depth_mm; }) / 1625, 20.68,
                0.005);
    EXPECT_NEAR(
        sum([](const SegmentCut& cut) { return cut.depth_mm <= 0 ? 1 : 0; }) / 1625,
        0.0049, 5e-5);
    const auto [low, high] = std::ranges::minmax(cuts, {}, &SegmentCut::mu);
    EXPECT_NEAR(Angle::radians(*low.mu).degrees(), -53.4697, 5e-5);
    EXPECT_NEAR(Angle::radians(*high.mu).degrees(), 50.5292, 5e-5);
    const auto [down, up] = std::ranges::minmax(cuts, {}, &SegmentCut::lambda);
    EXPECT_NEAR(Angle::radians(down.lambda).degrees(), -49.5217, 5e-5);
    EXPECT_NEAR(Angle::radians(up.lambda).degrees(), 49.5217, 5e-5);
}

// docs/methods/ball-end-milling.md, sections 8 and 9, A12. The constants were
// calibrated to the printed 54.8 min, so this is a regression test.
TEST(FeedPlan, OfTheReferencePathInSteel)
{
    const FeedPlan plan =
        feed_plan(scaled_reference_cuts(), steel_job(), {.accuracy = 1e-8});
    EXPECT_NEAR(plan.totals.cut_min + 12.47, 54.771, 0.005);
    EXPECT_NEAR(share(plan, FeedLimit::CuttingForce), 0.774, 6e-4);
    EXPECT_NEAR(share(plan, FeedLimit::Thrust), 0.102, 6e-4);
    EXPECT_EQ(share(plan, FeedLimit::Torque), 0);
    EXPECT_NEAR(share(plan, FeedLimit::Cap), 0.103, 6e-4);
    EXPECT_NEAR(share(plan, FeedLimit::Infeasible), 0.0205, 6e-5);
    EXPECT_EQ(plan.totals.infeasible, 36U);
    EXPECT_NEAR(share(plan, SpeedLimit::EconomicSpeed), 0.986, 6e-4);
    EXPECT_NEAR(share(plan, SpeedLimit::Spindle), 0.014, 6e-4);
    EXPECT_NEAR(plan.totals.max_torque_n_m * 1000 / 9.80665, 668, 0.6);
    EXPECT_NEAR(plan.totals.max_power_w, 960, 6);
}

// Likewise for aluminium, calibrated to the printed 31.3 min.
TEST(FeedPlan, OfTheReferencePathInAluminium)
{
    const FeedPlan plan =
        feed_plan(scaled_reference_cuts(), aluminium_job(), {.accuracy = 1e-8});
    EXPECT_NEAR(plan.totals.cut_min + 12.47, 31.300, 0.005);
    EXPECT_NEAR(share(plan, FeedLimit::CuttingForce), 0.766, 6e-4);
    EXPECT_NEAR(share(plan, FeedLimit::Thrust), 0.072, 6e-4);
    EXPECT_EQ(share(plan, FeedLimit::Torque), 0);
    EXPECT_NEAR(share(plan, FeedLimit::Cap), 0.155, 6e-4);
    EXPECT_NEAR(share(plan, FeedLimit::Infeasible), 0.0071, 6e-5);
    EXPECT_EQ(plan.totals.infeasible, 21U);
    EXPECT_NEAR(share(plan, SpeedLimit::EconomicSpeed), 0.986, 6e-4);
    EXPECT_NEAR(share(plan, SpeedLimit::Spindle), 0.014, 6e-4);
    EXPECT_EQ(share(plan, SpeedLimit::Power), 0);
    const auto speed = [](const SegmentFeed& row) { return row.table.spindle_rpm; };
    const auto [least, greatest] = std::ranges::minmax(plan.rows, {}, speed);
    EXPECT_NEAR(speed(least), 904.996386706, 1e-6) << "a half turn is engaged";
    EXPECT_EQ(speed(greatest), 3000);
}

// docs/methods/ball-end-milling.md, section 8: thrust governs where the cut is deep
// and goes downhill.
TEST(FeedPlan, IsBoundByThrustAsInThePaper)
{
    const std::vector<SegmentCut> cuts = test::reference_cuts();
    const FeedPlan plan = feed_plan(cuts, steel_job(), {});
    double count = 0;
    double depth = 0;
    double lambda = 0;
    double mu = 0;
    for (std::size_t i = 0; i < cuts.size(); ++i)
        if (plan.rows[i].tooth.governing == FeedLimit::Thrust) {
            count += 1;
            depth += cuts[i].depth_mm;
            lambda += cuts[i].lambda;
            mu += *cuts[i].mu;
        }
    ASSERT_GT(count, 0);
    EXPECT_NEAR(depth / count, 31.2, 0.05);
    EXPECT_NEAR(Angle::radians(lambda / count).degrees(), -8.4, 0.05);
    EXPECT_NEAR(Angle::radians(mu / count).degrees(), -10.2, 0.05);
}

// docs/methods/ball-end-milling.md, section 8: dependence of the total on the least
// feed.
TEST(FeedPlan, DependsOnTheLeastFeed)
{
    const std::vector<SegmentCut> cuts = scaled_reference_cuts();
    const double least[] = {0.002, 0.01, 0.02, 0.03};
    const double total[] = {65.31, 49.25, 44.89, 42.45};
    for (std::size_t i = 0; i < 4; ++i) {
        const FeedPlan plan =
            feed_plan(cuts, steel_job(), {.min_feed_per_tooth_mm = least[i]});
        EXPECT_NEAR(plan.totals.cut_min + 12.47, total[i], 0.0055);
    }
    const FeedPlan exact = feed_plan(cuts, steel_job(), {.chip = ChipModel::Exact});
    EXPECT_NEAR(exact.totals.cut_min + 12.47, 52.30, 0.0055);
}

// docs/methods/ball-end-milling.md, section 8: the same path with the torque of
// helical flutes.
TEST(FeedPlan, DependsOnTheRuleOfThePeak)
{
    const std::vector<SegmentCut> cuts = scaled_reference_cuts();
    const FeedPlan torque = feed_plan(cuts, steel_job(), {.peak = PeakRule::Torque});
    EXPECT_NEAR(torque.totals.cut_min + 12.47, 47.72, 0.05);
    std::vector<double> factors;
    for (const SegmentFeed& row : torque.rows)
        if (row.peak_factor)
            factors.push_back(*row.peak_factor);
    std::ranges::sort(factors);
    const auto part = [&](double of) {
        return factors[static_cast<std::size_t>(of *
                                                static_cast<double>(factors.size()))];
    };
    EXPECT_NEAR(part(0.05), 1.15, 0.01);
    EXPECT_NEAR(part(0.5), 1.88, 0.01);
    EXPECT_NEAR(part(0.95), 3.12, 0.01);
    EXPECT_NEAR(factors.back(), 6.84, 0.01);
}

// docs/methods/ball-end-milling.md, section 4: equivalent radius over the radius of
// the ball.
TEST(FeedPlan, PutsTheForceNearTheBallsRadius)
{
    const std::vector<SegmentCut> cuts = test::reference_cuts();
    const FeedPlan plan = feed_plan(cuts, steel_job(), {});
    std::vector<double> ratios;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        const EdgeSums sums = edge_sums(
            cutting_coefficients(ball_engagement(cuts[i], 5), ChipModel::Paper, 1e-6), 2,
            1);
        const auto radius = equivalent_radius({test::steel(), 5}, sums,
                                              plan.rows[i].tooth.feed_per_tooth_mm);
        if (cuts[i].depth_mm <= 0) {
            EXPECT_FALSE(radius);
        }
        if (radius)
            ratios.push_back(*radius / 5);
    }
    std::ranges::sort(ratios);
    const auto part = [&](double of) {
        return ratios[static_cast<std::size_t>(of * static_cast<double>(ratios.size()))];
    };
    EXPECT_NEAR(part(0.05), 0.83, 0.01);
    EXPECT_NEAR(part(0.5), 0.92, 0.01);
    EXPECT_NEAR(part(0.95), 0.98, 0.01);
}

// docs/methods/ball-end-milling.md, section 9, A13.
TEST(FeedPlan, KeepsCapAndBlockTimeOnEveryMove)
{
    const std::vector<SegmentCut> cuts = test::reference_cuts();
    for (const MillingJob& job : {steel_job(), aluminium_job()}) {
        const FeedPlan plan = feed_plan(cuts, job, {});
        double shares = 0;
        for (std::size_t i = 0; i < cuts.size(); ++i) {
            const SegmentFeed& row = plan.rows[i];
            EXPECT_LE(row.tooth.feed_per_tooth_mm, *job.material.max_feed_per_tooth_mm);
            EXPECT_GE(row.tooth.feed_per_tooth_mm, *job.material.min_feed_per_tooth_mm);
            EXPECT_GE(60000 * cuts[i].length_mm / row.table.feed_mm_per_min,
                      10 * (1 - 1e-12));
            EXPECT_LE(row.table.spindle_rpm, *job.machine.max_rpm);
        }
        for (const double one : plan.totals.limit_shares)
            shares += one;
        EXPECT_NEAR(shares, 1, 1e-12);
    }
}

TEST(FeedPlan, ReportsSufficientLimits)
{
    const std::vector<SegmentCut> cuts = test::reference_cuts();
    MillingJob job = steel_job();
    FeedPlan plan = feed_plan(cuts, job, {});
    ASSERT_GT(plan.totals.infeasible, 0U);
    const LoadLimits needed = plan.totals.needed;
    ASSERT_TRUE(needed.cutting_force_n || needed.thrust_n);
    job.tool.limits.cutting_force_n =
        needed.cutting_force_n.value_or(*job.tool.limits.cutting_force_n);
    job.tool.limits.thrust_n = needed.thrust_n.value_or(*job.tool.limits.thrust_n);
    EXPECT_EQ(feed_plan(cuts, job, {}).totals.infeasible, 0U);
    // A slightly smaller limit does not suffice.
    job = steel_job();
    job.tool.limits.cutting_force_n =
        0.999 * needed.cutting_force_n.value_or(*job.tool.limits.cutting_force_n);
    job.tool.limits.thrust_n =
        0.999 * needed.thrust_n.value_or(*job.tool.limits.thrust_n);
    EXPECT_GT(feed_plan(cuts, job, {}).totals.infeasible, 0U);
}

TEST(FeedPlan, IsTheSameWithAnyNumberOfThreads)
{
    const std::vector<SegmentCut> cuts = test::reference_cuts();
    set_thread_count(1);
    const FeedPlan one = feed_plan(cuts, steel_job(), {});
    set_thread_count(2);
    const FeedPlan two = feed_plan(cuts, steel_job(), {});
    EXPECT_EQ(one.totals.cut_min, two.totals.cut_min);
    for (std::size_t i = 0; i < cuts.size(); ++i)
        EXPECT_EQ(one.rows[i].table.feed_mm_per_min, two.rows[i].table.feed_mm_per_min);
}

// No load exceeds its limit on a move that the plan reports as feasible.
TEST(FeedPlan, KeepsTheLimitsUnderEveryRule)
{
    std::vector<SegmentCut> cuts = test::reference_cuts();
    std::vector<SegmentCut> few;
    for (std::size_t i = 0; i < cuts.size(); i += 60)
        few.push_back(cuts[i]);
    const MillingJob job = steel_job();
    for (const PeakRule rule : {PeakRule::Constant, PeakRule::Torque, PeakRule::Direct}) {
        FeedPlanOptions options = corrected_feed_options();
        options.peak = rule;
        const FeedPlan plan = feed_plan(few, job, options);
        for (std::size_t i = 0; i < few.size(); ++i) {
            const SegmentFeed& row = plan.rows[i];
            EXPECT_EQ(row.peak_factor.has_value(),
                      rule == PeakRule::Constant ||
                          (rule == PeakRule::Torque && few[i].depth_mm > 0));
            if (row.tooth.is_infeasible)
                continue;
            EXPECT_LE(row.loads.cutting_force_n,
                      *job.tool.limits.cutting_force_n * (1 + 2e-5));
            EXPECT_LE(row.loads.thrust_n, *job.tool.limits.thrust_n * (1 + 2e-5));
            EXPECT_LE(row.loads.torque_n_m, *job.tool.limits.torque_n_m * (1 + 2e-5));
        }
    }
}

TEST(FeedPlan, OfNoMovesIsEmpty)
{
    const FeedPlan plan = feed_plan(std::span<const SegmentCut>{}, steel_job(), {});
    EXPECT_TRUE(plan.rows.empty());
    EXPECT_EQ(plan.totals.cut_min, 0);
    EXPECT_EQ(plan.totals.infeasible, 0U);
}

TEST(FeedPlan, InAirGoesAtTheCap)
{
    const SegmentCut air{.length_mm = 10, .depth_mm = -1, .previous = PreviousPass::Edge};
    for (const PeakRule rule : {PeakRule::Constant, PeakRule::Torque, PeakRule::Direct}) {
        const FeedPlan plan = feed_plan(std::vector{air}, steel_job(), {.peak = rule});
        EXPECT_EQ(plan.rows[0].tooth.feed_per_tooth_mm, 0.15);
        EXPECT_NEAR(plan.rows[0].engaged_angle, pi / 36, 1e-15);
        EXPECT_EQ(plan.rows[0].loads.torque_n_m, 0);
        EXPECT_EQ(reported_limit(plan.rows[0]), FeedLimit::Cap);
    }
}

TEST(FeedPlan, RefusesMovesThatAreNotSound)
{
    const SegmentCut good{.length_mm = 1,
                          .mu = 0,
                          .pick_feed_mm = 2,
                          .pick_feed_horizontal_mm = 2,
                          .depth_mm = 3};
    const auto refused = [&](auto change) {
        SegmentCut cut = good;
        change(cut);
        EXPECT_THROW(feed_plan(std::vector{cut}, steel_job(), {}), DomainError);
    };
    EXPECT_NO_THROW(feed_plan(std::vector{good}, steel_job(), {}));
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    refused([](SegmentCut& cut) { cut.length_mm = 0; });
    refused([](SegmentCut& cut) { cut.length_mm = nan; });
    refused([](SegmentCut& cut) { cut.mu = std::nullopt; });
    refused([](SegmentCut& cut) { cut.pick_feed_mm = std::nullopt; });
    refused([](SegmentCut& cut) { cut.pick_feed_mm = -1; });
    refused([](SegmentCut& cut) { cut.mu = 2; });
    refused([](SegmentCut& cut) { cut.lambda = -2; });
    refused([](SegmentCut& cut) { cut.depth_mm = nan; });
    MillingJob unbounded = steel_job();
    unbounded.material.max_feed_per_tooth_mm = std::nullopt;
    unbounded.tool.limits.cutting_force_n = unbounded.tool.limits.thrust_n =
        unbounded.tool.limits.torque_n_m = std::nullopt;
    EXPECT_THROW(feed_plan(std::vector{good}, unbounded, {}), DomainError);
}

// Coefficients from the table change a plan by no more than the error of the table.
TEST(FeedPlan, ByTheTableIsNearlyTheSame)
{
    const CoefficientTable table{ChipModel::Paper,
                                 {.angles = 9, .pick_feeds = 5, .depths = 5}};
    const std::vector<SegmentCut> cuts = test::reference_cuts();
    const FeedPlan direct = feed_plan(cuts, steel_job(), {});
    const FeedPlan tabled = feed_plan(cuts, steel_job(), {.table = &table});
    EXPECT_LT(relative_error(tabled.totals.cut_min, direct.totals.cut_min), 0.05);
    EXPECT_NE(tabled.totals.cut_min, direct.totals.cut_min);
}

}  // namespace
}  // namespace endmill
