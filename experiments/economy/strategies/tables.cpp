// SPDX-License-Identifier: GPL-3.0-or-later
#include "economy/strategies/tables.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <iterator>
#include <optional>
#include <vector>

#include "endmill/bound/path_bound.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/planning/planner_options.h"
#include "endmill/strategy/strategy.h"
#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

constexpr double tolerance_share = 0.02;  // of the scallop height
constexpr double least_tolerance = 1e-3;  // mm

std::int64_t count(std::size_t number)
{
    return static_cast<std::int64_t>(number);
}

StrategyOptions options_for(const Surface& surface, const ComparedCut& cut)
{
    StrategyOptions options;
    options.scallop_height = cut.scallop_height;
    options.inner_tolerance =
        std::max(least_tolerance, tolerance_share * cut.scallop_height);
    options.link.safe_height = default_safe_height({&surface, 1}, options.link.axis);
    return options;
}

// The bound for paths of one piece; each further piece takes `disc_mm` from it.
std::optional<PathBound> bound_of(const Surface& surface, const ComparedCut& cut,
                                  double stray)
{
    BoundProblem problem{cut.ball, cut.scallop_height};
    problem.stray = stray;
    try {
        return path_bound({&surface, 1}, tool_side_signs({&surface, 1}, Vec3::UnitZ()),
                          problem, {});
    } catch (const GeometryError&) {
        return std::nullopt;
    }
}

std::string row_name(const std::string& surface, const ComparedCut& cut,
                     const std::string& strategy)
{
    return surface + " D=" + to_text(2 * cut.ball.radius()) +
           " h=" + to_text(cut.scallop_height) + " " + strategy;
}

// What a path saves against the better of the paths along parameters, in per cent; empty
// for those paths.
CsvCell saved_percent(double cut_mm, const std::optional<double>& along_parameters_mm,
                      Strategy strategy)
{
    if (!along_parameters_mm || strategy == Strategy::IsoU || strategy == Strategy::IsoV)
        return {};
    return 100 * (1 - cut_mm / *along_parameters_mm);
}

std::vector<CsvCell> planned_cells(const StrategyPlan& plan,
                                   const std::optional<PathBound>& bound,
                                   const std::optional<double>& along_parameters_mm)
{
    const CoveringPath& covering = plan.covering;
    const double cut_mm = plan.economy.cut.contact_mm;
    const double least =
        bound ? bound->density_mm - static_cast<double>(covering.pieces) * bound->disc_mm
              : 0;
    return {cut_mm,
            saved_percent(cut_mm, along_parameters_mm, plan.strategy),
            plan.economy.cut.tip_mm,
            plan.economy.link.tip_mm,
            count(covering.pieces),
            count(covering.lifted_links),
            count(plan.economy.ncl),
            bound ? CsvCell{bound->density_mm} : CsvCell{},
            bound ? CsvCell{cut_mm / bound->density_mm} : CsvCell{},
            least > 0 ? CsvCell{cut_mm / least} : CsvCell{},
            plan.deviation.max_scallop_mm,
            plan.deviation.max_gouge_mm,
            std::string{verdict_name(plan.verdict)},
            covering.uncovered_mm2};
}

}  // namespace

CsvTable strategies_table()
{
    return CsvTable{{"row",
                     "surface",
                     "diameter_mm",
                     "scallop_mm",
                     "strategy",
                     "cut_contact_mm",
                     "saved_against_iso_percent",
                     "cut_tip_mm",
                     "link_mm",
                     "pieces",
                     "lifted_links",
                     "ncl",
                     "bound_density_mm",
                     "cut_over_density",
                     "cut_over_bound",
                     "max_left_mm",
                     "max_gouge_mm",
                     "verdict",
                     "uncovered_mm2",
                     "time_s"}};
}

void add_strategies(CsvTable& table, const std::string& name, const Surface& surface,
                    const ComparedCut& cut)
{
    const StrategyOptions options = options_for(surface, cut);
    const double diameter = 2 * cut.ball.radius();
    const std::optional<PathBound> bound =
        bound_of(surface, cut, options.inner_tolerance);
    std::optional<double> along_parameters_mm;
    for (const Strategy strategy : every_strategy) {
        const std::string word{strategy_name(strategy)};
        std::vector<CsvCell> row{row_name(name, cut, word), name, diameter,
                                 cut.scallop_height, word};
        const auto begin = std::chrono::steady_clock::now();
        try {
            const StrategyPlan plan = plan_by_strategy(
                strategy, std::vector<Surface>{surface}, cut.ball, options);
            std::ranges::copy(planned_cells(plan, bound, along_parameters_mm),
                              std::back_inserter(row));
            const double cut_mm = plan.economy.cut.contact_mm;
            if (strategy == Strategy::IsoU || strategy == Strategy::IsoV)
                along_parameters_mm =
                    std::min(cut_mm, along_parameters_mm.value_or(cut_mm));
        } catch (const GeometryError&) {
            row.resize(table.columns().size() - 1);
        }
        row.push_back(
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
                .count());
        table.add_row(row);
    }
}

}  // namespace endmill
