// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/along_path.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <set>

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

NamedCells spread_cells(const Spread& spread)
{
    return {{"least", spread.least},
            {"mean", spread.sum / spread.weight},
            {"greatest", spread.greatest}};
}

// Whether the feed per tooth of move i is at its cap.
bool is_at_cap(const FeedPlan& plan, std::size_t i)
{
    return reported_limit(plan.rows[i]) == FeedLimit::Cap;
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
        double step = 0;
        std::optional<double> before;
        int pass = 0;
        for (const SegmentCut& cut : cuts) {
            const std::optional<double> known = value(cut);
            if (known)
                spread.add(*known, 1);
            if (known && before && cut.pass == pass)
                step = std::max(step, std::abs(*known - *before));
            before = known;
            pass = cut.pass;
        }
        add_named(
            table, name,
            joined(spread_cells(spread),
                   {{"largest_step_share", step / (spread.greatest - spread.least)}}));
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
    const auto add = [&](const std::string& quantity, const Spread& spread) {
        add_named(table, name + ", " + quantity,
                  joined(spread_cells(spread),
                         {{"greatest_over_least", spread.greatest / spread.least}}));
    };
    add("feed_mm_per_min", feed);
    add("spindle_rpm", speed);
}

CapJumps cap_jumps(const std::vector<SegmentCut>& cuts, const FeedPlan& plan,
                   double shallow_mm, double cap_mm)
{
    CapJumps jumps;
    double length = 0;  // of the current stretch; 0: not at the cap
    bool is_shallow = false;
    std::set<int> passes;
    std::set<int> shallow;
    std::set<int> shallow_with_jump;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        if (plan.rows[i].tooth.feed_per_tooth_mm > cap_mm)
            ++jumps.above_cap;
        if (cuts[i].depth_mm < shallow_mm)
            shallow.insert(cuts[i].pass);
        if (!is_at_cap(plan, i)) {
            length = 0;
            continue;
        }
        if (length == 0 || cuts[i].pass != cuts[i - 1].pass) {
            ++jumps.count;
            passes.insert(cuts[i].pass);
            length = 0;
            is_shallow = false;
        }
        length += cuts[i].length_mm;
        if (cuts[i].depth_mm < shallow_mm && !is_shallow) {
            ++jumps.at_the_top;
            shallow_with_jump.insert(cuts[i].pass);
            is_shallow = true;
        }
        jumps.longest_mm = std::max(jumps.longest_mm, length);
    }
    jumps.passes = static_cast<int>(passes.size());
    jumps.shallow_passes = static_cast<int>(shallow.size());
    jumps.shallow_passes_with_jump = static_cast<int>(shallow_with_jump.size());
    return jumps;
}

NamedCells jump_cells(const CapJumps& jumps)
{
    const auto share = [](int part, int whole) {
        return static_cast<double>(part) / static_cast<double>(whole);
    };
    return {{"jumps", std::int64_t{jumps.count}},
            {"at_the_top", std::int64_t{jumps.at_the_top}},
            {"longest_mm", jumps.longest_mm},
            {"passes_with_jump", std::int64_t{jumps.passes}},
            {"at_the_top_share", share(jumps.at_the_top, jumps.count)},
            {"shallow_passes_share",
             share(jumps.shallow_passes_with_jump, jumps.shallow_passes)},
            {"above_cap", std::int64_t{jumps.above_cap}}};
}

void write_along(Experiment& run, const std::string& name, const std::string& title,
                 const std::vector<SegmentCut>& cuts, const FeedPlan& plan)
{
    run.write(name + ".csv", feed_csv(cuts, plan.rows));
    run.write(name + ".svg", feed_svg(cuts, plan.rows, {.title = title}));
}

}  // namespace endmill
