// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball-end-milling/figure-11-12/comparison.h"

#include <algorithm>
#include <cstdint>
#include <variant>

#include "support/path_statistics.h"

namespace endmill {
namespace {

constexpr int leftover_pass = 1;

// A path with its feeds.
struct FedCuts {
    std::vector<SegmentCut> cuts;
    std::vector<double> feeds;  // mm/min
};

FedCuts without_leftover(const FedCuts& all)
{
    FedCuts kept;
    for (std::size_t i = 0; i < all.cuts.size(); ++i)
        if (all.cuts[i].pass != leftover_pass) {
            kept.cuts.push_back(all.cuts[i]);
            kept.feeds.push_back(all.feeds[i]);
        }
    return kept;
}

NamedCells cells_of(const FedCuts& path, double radius)
{
    return joined(joined(geometry_variation(path.cuts),
                         {{"full_ring_percent", full_ring_percent(path.cuts, radius)}}),
                  feed_distribution(path.cuts, path.feeds));
}

// The quotients of two lists of numbers with the same names, and the least quotient of the
// four standard deviations of the geometry.
NamedCells quotients(const NamedCells& one, const NamedCells& other)
{
    NamedCells found;
    double least =
        std::get<double>(one.front().second) / std::get<double>(other.front().second);
    for (std::size_t i = 0; i < one.size(); ++i) {
        const double quotient =
            std::get<double>(one[i].second) / std::get<double>(other[i].second);
        found.emplace_back(one[i].first, quotient);
        if (one[i].first.find("_deviation_") != std::string::npos)
            least = std::min(least, quotient);
    }
    found.emplace_back("least_deviation", least);
    return found;
}

void add_quantiles(CsvTable& table, const std::string& name, const FedCuts& path)
{
    const std::vector<double> lengths = lengths_of(path.cuts);
    for (int percent = 1; percent <= 100; ++percent)
        table.add_row({name + " " + std::to_string(percent), std::int64_t{percent},
                       weighted_quantile(path.feeds, lengths, percent / 100.0), name});
}

}  // namespace

std::vector<std::string> comparison_columns()
{
    return {"mu_deviation_deg",
            "lambda_deviation_deg",
            "pick_feed_deviation_mm",
            "depth_deviation_mm",
            "mu_change",
            "lambda_change",
            "pick_feed_change",
            "depth_change",
            "depth_reversals_per_100_mm",
            "full_ring_percent",
            "feed_50",
            "feed_95",
            "feed_99",
            "feed_greatest",
            "feed_variation",
            "feed_reversals_per_100_mm",
            "feed_change",
            "least_deviation"};
}

CsvTable add_comparison(CsvTable& table, const std::string& name,
                        const OneWayPasses& plan, const MillingJob& job,
                        const FeedPlanOptions& options)
{
    const auto fed = [&](const OneWayPasses& passes) {
        std::vector<SegmentCut> cuts = milled_path(passes).cuts;
        const FeedPlan feeds = feed_plan(cuts, job, options);
        return FedCuts{std::move(cuts), table_feeds(feeds)};
    };
    const auto add = [&](const std::string& suffix, const FedCuts& one,
                         const FedCuts& other) {
        const NamedCells ours = cells_of(one, job.tool.radius);
        const NamedCells test = cells_of(other, job.tool.radius);
        add_named(table, name + suffix, ours);
        add_named(table, "test surface" + suffix, test);
        add_named(table, name + " over test surface" + suffix, quotients(ours, test));
    };
    const FedCuts one = fed(plan);
    const FedCuts other = fed(reference_passes());
    add("", one, other);
    add(", without the leftover pass", without_leftover(one), without_leftover(other));
    CsvTable quantiles{{"row", "share_percent", "feed_mm_per_min", "path"}};
    add_quantiles(quantiles, name, one);
    add_quantiles(quantiles, "test surface", other);
    return quantiles;
}

}  // namespace endmill
