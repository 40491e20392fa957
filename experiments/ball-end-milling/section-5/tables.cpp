// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball-end-milling/section-5/tables.h"

#include <cmath>
#include <set>
#include <variant>

#include "endmill/process/fed_path.h"

namespace endmill {
namespace {

void add_two_feeds(CsvTable& table, const PrintedTimes& printed)
{
    const ConstantFeedRun one{printed.feeds_mm_per_min[0], printed.constant_feed_min[0]};
    const ConstantFeedRun other{printed.feeds_mm_per_min[1],
                                printed.constant_feed_min[1]};
    const RunParts parts = parts_of_runs(one, other);
    const double e = printed.rounding_min;
    const auto with = [&](double a, double b) {
        return parts_of_runs({one.feed_mm_per_min, one.total_min + a},
                             {other.feed_mm_per_min, other.total_min + b});
    };
    add_named(table, "two constant feeds: length",
              {{"length_mm", parts.length_mm},
               {"least", with(e, -e).length_mm},
               {"greatest", with(-e, e).length_mm},
               {"off_over_rounding", std::abs(printed.length_mm - parts.length_mm) /
                                         (with(-e, e).length_mm - parts.length_mm)}});
    add_named(table, "two constant feeds: not cutting",
              {{"noncut_min", parts.noncut_min},
               {"least", with(-e, e).noncut_min},
               {"greatest", with(e, -e).noncut_min}});
}

void add_noncut(CsvTable& table, const PrintedTimes& printed, double noncut_min)
{
    for (std::size_t i = 0; i < printed.materials.size(); ++i) {
        const double cut = printed.length_mm / printed.feeds_mm_per_min[i];
        const double noncut = printed.constant_feed_min[i] - cut;
        add_named(table, "printed length, " + printed.materials[i] + ": not cutting",
                  {{"noncut_min", noncut},
                   {"total_min", cut + noncut_min},
                   {"least", noncut - printed.rounding_min},
                   {"greatest", noncut + printed.rounding_min}});
    }
}

void add_savings(CsvTable& table, const PrintedTimes& printed, double noncut_min)
{
    const double e = printed.rounding_min;
    for (std::size_t i = 0; i < printed.materials.size(); ++i) {
        const double varied = printed.variable_feed_min[i];
        const double constant = printed.constant_feed_min[i];
        const double saving = saving_percent(varied, constant);
        add_named(table, "print, " + printed.materials[i] + ": saving",
                  {{"saving_percent", saving},
                   {"saving_cut_off_percent", std::floor(10 * saving) / 10},
                   {"least", saving_percent(varied + e, constant - e)},
                   {"greatest", saving_percent(varied - e, constant + e)}});
        const double cut = varied - noncut_min;
        const double at_constant = printed.length_mm / printed.feeds_mm_per_min[i];
        add_named(table, "print, " + printed.materials[i] + ": cutting",
                  {{"noncut_min", noncut_min},
                   {"cut_min", cut},
                   {"mean_feed_mm_per_min", printed.length_mm / cut},
                   {"cut_saving_percent", saving_percent(cut, at_constant)}});
    }
}

}  // namespace

NamedCells machine_cells(const FeedPlan& plan, const MillingJob& job)
{
    return {{"torque_used", plan.totals.max_torque_n_m / *job.tool.limits.torque_n_m},
            {"power_used", plan.totals.max_power_w / *job.machine.max_power_w}};
}

NamedCells saving_cells(const NamedCells& times)
{
    constexpr double printed_about_percent = 60;  // conclusion 3: "about 60 %"
    for (const auto& [name, cell] : times)
        if (name == "saving_percent")
            return {{"off_60_percent",
                     std::abs(std::get<double>(cell) - printed_about_percent)}};
    return {};
}

std::int64_t different_names(const std::vector<std::string>& names)
{
    return static_cast<std::int64_t>(std::set(names.begin(), names.end()).size());
}

std::vector<std::string> time_columns()
{
    return {"row",
            "length_mm",
            "noncut_min",
            "total_min",
            "saving_percent",
            "saving_cut_off_percent",
            "off_60_percent",
            "cut_min",
            "mean_feed_mm_per_min",
            "cut_saving_percent",
            "least",
            "greatest",
            "force_share",
            "thrust_share",
            "torque_share",
            "cap_share",
            "block_share",
            "infeasible_share",
            "economic_share",
            "spindle_share",
            "power_share",
            "drive_share",
            "infeasible",
            "max_torque_n_m",
            "max_power_w",
            "mostly_force",
            "sometimes_thrust",
            "never_torque_or_power",
            "torque_used",
            "power_used",
            "off_over_rounding",
            "names"};
}

void add_accounts(CsvTable& table, const PrintedTimes& printed, double noncut_min)
{
    add_two_feeds(table, printed);
    add_noncut(table, printed, noncut_min);
    add_savings(table, printed, noncut_min);
}

}  // namespace endmill
