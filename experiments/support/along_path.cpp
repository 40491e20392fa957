// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/along_path.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>

#include "endmill/core/angle.h"
#include "endmill/figures/feed_svg.h"
#include "endmill/files/result_csv.h"

namespace endmill {
namespace {

// Extremes and weighted mean of the values added.
struct Spread {
    double least = std::numeric_limits<double>::infinity();
    double greatest = -std::numeric_limits<double>::infinity();
    double sum = 0;
    double weight = 0;

    void add(double value, double its_weight)
    {
        least = std::min(least, value);
        greatest = std::max(greatest, value);
        sum += its_weight * value;
        weight += its_weight;
    }
};

void add_spread(CsvTable& table, const std::string& row, const Spread& spread)
{
    add_named(table, row,
              {{"least", spread.least},
               {"mean", spread.sum / spread.weight},
               {"greatest", spread.greatest}});
}

std::optional<double> degrees(const std::optional<double>& angle)
{
    return angle ? std::optional{Angle::radians(*angle).degrees()} : std::nullopt;
}

}  // namespace

void add_geometry(CsvTable& table, const std::vector<SegmentCut>& cuts)
{
    using Value = std::function<std::optional<double>(const SegmentCut&)>;
    const std::vector<std::pair<std::string, Value>> quantities{
        {"mu_deg", [](const SegmentCut& cut) { return degrees(cut.mu); }},
        {"lambda_deg", [](const SegmentCut& cut) { return degrees(cut.lambda); }},
        {"pick_feed_mm", [](const SegmentCut& cut) { return cut.pick_feed_mm; }},
        {"pick_feed_horizontal_mm",
         [](const SegmentCut& cut) { return cut.pick_feed_horizontal_mm; }},
        {"depth_mm", [](const SegmentCut& cut) { return std::optional{cut.depth_mm}; }}};
    for (const auto& [name, value] : quantities) {
        Spread spread;
        for (const SegmentCut& cut : cuts)
            if (const std::optional<double> known = value(cut))
                spread.add(*known, 1);
        add_spread(table, name, spread);
    }
    const auto in_air = std::ranges::count_if(
        cuts, [](const SegmentCut& cut) { return cut.depth_mm <= 0; });
    add_named(
        table, "in_air_percent",
        {{"mean", 100 * static_cast<double>(in_air) / static_cast<double>(cuts.size())}});
}

void add_feeds(CsvTable& table, const std::string& name,
               const std::vector<SegmentCut>& cuts, const FeedPlan& plan)
{
    Spread feed;
    Spread speed;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        feed.add(plan.rows[i].table.feed_mm_per_min, cuts[i].length_mm);
        speed.add(plan.rows[i].table.spindle_rpm, cuts[i].length_mm);
    }
    add_spread(table, name + ", feed_mm_per_min", feed);
    add_spread(table, name + ", spindle_rpm", speed);
}

CapJumps cap_jumps(const std::vector<SegmentCut>& cuts, const FeedPlan& plan,
                   double shallow_mm)
{
    CapJumps jumps;
    double length = 0;  // of the current stretch; 0: not at the cap
    bool is_shallow = false;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        if (reported_limit(plan.rows[i]) != FeedLimit::Cap) {
            length = 0;
            continue;
        }
        if (length == 0 || cuts[i].pass != cuts[i - 1].pass) {
            ++jumps.count;
            length = 0;
            is_shallow = false;
        }
        length += cuts[i].length_mm;
        if (cuts[i].depth_mm < shallow_mm && !is_shallow) {
            ++jumps.at_the_top;
            is_shallow = true;
        }
        jumps.longest_mm = std::max(jumps.longest_mm, length);
    }
    return jumps;
}

void write_along(Experiment& run, const std::string& name, const std::string& title,
                 const std::vector<SegmentCut>& cuts, const FeedPlan& plan)
{
    run.write(name + ".csv", feed_csv(cuts, plan.rows));
    run.write(name + ".svg", feed_svg(cuts, plan.rows, {.title = title}));
}

}  // namespace endmill
