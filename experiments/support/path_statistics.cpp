// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/path_statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "endmill/core/angle.h"
#include "endmill/process/detail/engaged_region.h"
#include "endmill/process/detail/segment_load.h"

namespace endmill {
namespace {

double weighted_mean(std::span<const double> values, std::span<const double> weights)
{
    double sum = 0;
    double weight = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        sum += weights[i] * values[i];
        weight += weights[i];
    }
    return sum / weight;
}

// Places of `values` in rising order.
std::vector<std::size_t> rising_order(std::span<const double> values)
{
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return values[i]; });
    return order;
}

// Rank of each value; equal values share the mean of their ranks.
std::vector<double> ranks(std::span<const double> values)
{
    const std::vector<std::size_t> order = rising_order(values);
    std::vector<double> found(values.size());
    for (std::size_t begin = 0; begin < order.size();) {
        std::size_t end = begin;
        while (end < order.size() && values[order[end]] == values[order[begin]])
            ++end;
        for (std::size_t i = begin; i < end; ++i)
            found[order[i]] = static_cast<double>(begin + end - 1) / 2;
        begin = end;
    }
    return found;
}

// Sums of |change| of a quantity between neighbouring moves of a pass, with the distance
// of their middles, and the number of reversals.
struct Changes {
    double change = 0;
    double distance = 0;
    double reversals = 0;
};

Changes changes(const std::vector<SegmentCut>& cuts, const std::vector<double>& values)
{
    Changes sums;
    double before = 0;  // last change that is not 0 in this pass
    for (std::size_t i = 1; i < cuts.size(); ++i) {
        if (cuts[i].pass != cuts[i - 1].pass) {
            before = 0;
            continue;
        }
        const double step = values[i] - values[i - 1];
        sums.change += std::abs(step);
        sums.distance += (cuts[i].length_mm + cuts[i - 1].length_mm) / 2;
        sums.reversals += step * before < 0 ? 1 : 0;
        before = step != 0 ? step : before;
    }
    return sums;
}

template <typename Value>
std::vector<double> values_of(const std::vector<SegmentCut>& cuts, const Value& value)
{
    std::vector<double> all;
    all.reserve(cuts.size());
    for (const SegmentCut& cut : cuts)
        all.push_back(value(cut));
    return all;
}

double reversals_per_100_mm(const Changes& sums)
{
    return 100 * sums.reversals / sums.distance;
}

}  // namespace

std::vector<double> lengths_of(const std::vector<SegmentCut>& cuts)
{
    return values_of(cuts, [](const SegmentCut& cut) { return cut.length_mm; });
}

std::vector<double> table_feeds(const FeedPlan& plan)
{
    std::vector<double> feeds;
    feeds.reserve(plan.rows.size());
    for (const SegmentFeed& row : plan.rows)
        feeds.push_back(row.table.feed_mm_per_min);
    return feeds;
}

double deviation(std::span<const double> values, std::span<const double> weights)
{
    const double mean = weighted_mean(values, weights);
    std::vector<double> squares;
    squares.reserve(values.size());
    for (const double value : values)
        squares.push_back((value - mean) * (value - mean));
    return std::sqrt(weighted_mean(squares, weights));
}

double variation(std::span<const double> values, std::span<const double> weights)
{
    return deviation(values, weights) / weighted_mean(values, weights);
}

double weighted_quantile(std::span<const double> values, std::span<const double> weights,
                         double share)
{
    const double wanted = share * std::accumulate(weights.begin(), weights.end(), 0.0);
    const std::vector<std::size_t> order = rising_order(values);
    double sum = 0;
    for (const std::size_t i : order) {
        sum += weights[i];
        if (sum >= wanted)
            return values[i];
    }
    return values[order.back()];
}

double rank_correlation(const std::vector<double>& one, const std::vector<double>& other)
{
    const std::vector<double> a = ranks(one);
    const std::vector<double> b = ranks(other);
    const std::vector<double> equal(a.size(), 1.0);
    const double mean = static_cast<double>(a.size() - 1) / 2;
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += (a[i] - mean) * (b[i] - mean);
    return sum / static_cast<double>(a.size()) /
           (deviation(a, equal) * deviation(b, equal));
}

double full_ring_percent(const std::vector<SegmentCut>& cuts, double radius)
{
    constexpr double rounding = 1e-9;
    double ring = 0;
    double total = 0;
    for (const SegmentCut& cut : cuts) {
        total += cut.length_mm;
        const BallEngagement engagement = ball_engagement(cut, radius);
        if (cut.lambda >= 0 || is_air(engagement))
            continue;
        const auto ranges = engaged_ranges(engagement, -cut.lambda / 2);
        if (ranges.size() == 1 &&
            ranges.front().to - ranges.front().from > 2 * std::numbers::pi - rounding)
            ring += cut.length_mm;
    }
    return 100 * ring / total;
}

NamedCells geometry_variation(const std::vector<SegmentCut>& cuts)
{
    // The first pass has neither a pick feed nor a slope across the feed to compare.
    std::vector<SegmentCut> beside = cuts;
    std::erase_if(beside, [](const SegmentCut& cut) { return !cut.pick_feed_mm; });
    const std::vector<double> lengths = lengths_of(beside);
    const auto mu = values_of(
        beside, [](const SegmentCut& c) { return Angle::radians(*c.mu).degrees(); });
    const auto lambda = values_of(
        beside, [](const SegmentCut& c) { return Angle::radians(c.lambda).degrees(); });
    const auto pick =
        values_of(beside, [](const SegmentCut& c) { return *c.pick_feed_mm; });
    const auto depth = values_of(beside, [](const SegmentCut& c) { return c.depth_mm; });
    const auto per_mm = [&](const std::vector<double>& values) {
        const Changes sums = changes(beside, values);
        return sums.change / sums.distance;
    };
    return {{"mu_deviation_deg", deviation(mu, lengths)},
            {"lambda_deviation_deg", deviation(lambda, lengths)},
            {"pick_feed_deviation_mm", deviation(pick, lengths)},
            {"depth_deviation_mm", deviation(depth, lengths)},
            {"mu_change", per_mm(mu)},
            {"lambda_change", per_mm(lambda)},
            {"pick_feed_change", per_mm(pick)},
            {"depth_change", per_mm(depth)},
            {"depth_reversals_per_100_mm", reversals_per_100_mm(changes(beside, depth))}};
}

NamedCells feed_distribution(const std::vector<SegmentCut>& cuts,
                             const std::vector<double>& feeds)
{
    std::vector<double> logarithms;
    logarithms.reserve(feeds.size());
    for (const double feed : feeds)
        logarithms.push_back(std::log(feed));
    const std::vector<double> lengths = lengths_of(cuts);
    const Changes relative = changes(cuts, logarithms);
    return {{"feed_50", weighted_quantile(feeds, lengths, 0.5)},
            {"feed_95", weighted_quantile(feeds, lengths, 0.95)},
            {"feed_99", weighted_quantile(feeds, lengths, 0.99)},
            {"feed_greatest", std::ranges::max(feeds)},
            {"feed_variation", variation(feeds, lengths)},
            {"feed_reversals_per_100_mm", reversals_per_100_mm(changes(cuts, feeds))},
            {"feed_change", relative.change / relative.distance}};
}

}  // namespace endmill
