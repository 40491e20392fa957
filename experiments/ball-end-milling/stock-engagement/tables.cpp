// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball-end-milling/stock-engagement/tables.h"

#include <algorithm>
#include <cstdint>
#include <variant>

#include "endmill/process/detail/front_load.h"
#include "endmill/process/detail/segment_load.h"
#include "endmill/process/detail/stroke_forces.h"
#include "support/milling_jobs.h"

namespace endmill {
namespace {

// Relative accuracy of a force computed from the cells of a front.
constexpr double peak_accuracy = 0.02;

// Share in percent of the path length whose peak exceeds the limit by more than the accuracy.
double over_percent(const std::vector<SegmentCut>& cuts, const std::vector<double>& peaks,
                    double limit_n)
{
    double over = 0;
    for (std::size_t i = 0; i < cuts.size(); ++i)
        if (peaks[i] > limit_n * (1 + peak_accuracy))
            over += cuts[i].length_mm;
    return 100 * over / length_mm(cuts);
}

}  // namespace

void add_engagements(CsvTable& table, const std::vector<SegmentCut>& cuts,
                     const SimulatedCuts& simulated, double radius)
{
    std::vector<CuttingCoefficients> idealised;
    std::vector<CuttingCoefficients> met;
    idealised.reserve(cuts.size());
    met.reserve(cuts.size());
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        idealised.push_back(
            cutting_coefficients(ball_engagement(cuts[i], radius), ChipModel::Exact));
        met.push_back(front_coefficients(simulated.fronts[i], ChipModel::Exact));
    }
    add_named(table, "idealised", engagement_cells(cuts, idealised, radius));
    add_named(table, "simulated", engagement_cells(cuts, met, radius));
    add_named(table, "stock", {{"removed_mm3", simulated.removed_mm3}});
    const NamedCells model = engagement_cells(cuts, idealised, radius);
    const NamedCells stock = engagement_cells(cuts, met, radius);
    NamedCells ratios;
    for (std::size_t i = 0; i < model.size(); ++i)
        ratios.emplace_back(model[i].first, std::get<double>(model[i].second) /
                                                std::get<double>(stock[i].second));
    add_named(table, "idealised over simulated", ratios);
}

CsvTable PeakForceRun::along_table()
{
    return CsvTable{{"row", "pass", "travel_mm", "plan", "idealised_n", "simulated_n",
                     "right_hand_idealised_n", "right_hand_simulated_n"}};
}

void PeakForceRun::add(CsvTable& table, CsvTable& along, const std::string& name,
                       const FeedPlan& plan) const
{
    const std::vector<MilledMove> moves = milled_moves(cuts, plan, {});
    const std::vector<double> by_model = peak_cutting_forces(moves, job);
    const std::vector<double> by_stock =
        peak_cutting_forces(moves, simulated.fronts, job);
    const MillingJob right_hand = right_hand_job(job);
    const std::vector<double> right_by_model = peak_cutting_forces(moves, right_hand);
    const std::vector<double> right_by_stock =
        peak_cutting_forces(moves, simulated.fronts, right_hand);
    const double limit_n = job.tool.limits.cutting_force_n.value();
    add_named(table, name,
              {{"cut_min", plan.totals.cut_min},
               {"infeasible", static_cast<std::int64_t>(plan.totals.infeasible)},
               {"idealised_peak_n", std::ranges::max(by_model)},
               {"idealised_over_percent", over_percent(cuts, by_model, limit_n)},
               {"simulated_peak_n", std::ranges::max(by_stock)},
               {"simulated_over_percent", over_percent(cuts, by_stock, limit_n)},
               {"right_hand_idealised_peak_n", std::ranges::max(right_by_model)},
               {"right_hand_idealised_over_percent",
                over_percent(cuts, right_by_model, limit_n)},
               {"right_hand_simulated_peak_n", std::ranges::max(right_by_stock)},
               {"right_hand_simulated_over_percent",
                over_percent(cuts, right_by_stock, limit_n)}});
    double travel = 0;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        if (i > 0 && cuts[i].pass != cuts[i - 1].pass)
            travel = 0;
        travel += cuts[i].length_mm;
        along.add_row({std::to_string(cuts[i].pass) + "." + std::to_string(cuts[i].point),
                       static_cast<std::int64_t>(cuts[i].pass),
                       travel - cuts[i].length_mm / 2, name, by_model[i], by_stock[i],
                       right_by_model[i], right_by_stock[i]});
    }
}

}  // namespace endmill
