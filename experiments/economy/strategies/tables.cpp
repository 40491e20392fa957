// SPDX-License-Identifier: GPL-3.0-or-later
#include "economy/strategies/tables.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/planning/planner_options.h"
#include "endmill/surface/extent.h"
#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

constexpr double tolerance_share = 0.02;  // of the scallop height
constexpr double least_tolerance = 1e-3;  // mm
constexpr std::string_view best_name = "best";
constexpr std::string_view left_out =
    "left out: more squares as wide as a strip than most_squares";

// Nodes of the density of a bound, about. The default has more, and a bound that is less than a
// per cent longer.
constexpr double bound_nodes = 1500;
constexpr std::size_t bound_random_places = 5000;

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
    EstimateOptions options;
    options.random_places = bound_random_places;
    try {
        options.node_spacing = std::max(std::sqrt(area(surface) / bound_nodes),
                                        0.7 * 2 * plane_half_width(problem));
        return path_bound({&surface, 1}, tool_side_signs({&surface, 1}, Vec3::UnitZ()),
                          problem, options);
    } catch (const GeometryError&) {
        return std::nullopt;
    }
}

bool follows_parameters(Strategy strategy)
{
    return strategy == Strategy::IsoU || strategy == Strategy::IsoV;
}

// CPU time of all threads so far, s.
double cpu_s()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace

StrategiesTable::StrategiesTable(double most_squares)
    : table_{{"row",
              "surface",
              "diameter_mm",
              "scallop_mm",
              "strategy",
              "laid_by",
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
              "refusal",
              "cpu_s"}},
      most_squares_{most_squares}
{
}

void StrategiesTable::add(const std::string& name, const Surface& surface,
                          const ComparedCut& cut)
{
    const StrategyOptions options = options_for(surface, cut);
    const double diameter = 2 * cut.ball.radius();
    Comparison comparison{
        {name, diameter, cut.scallop_height},
        name + " D=" + to_text(diameter) + " h=" + to_text(cut.scallop_height)};
    const double width = 2 * plane_half_width({cut.ball, cut.scallop_height});
    if (area(surface) > most_squares_ * width * width)
        return add_left_out(comparison);
    comparison.bound = bound_of(surface, cut, options.inner_tolerance);
    const Part part = std::vector<Surface>{surface};
    for (const Strategy strategy : every_strategy)
        add_row(comparison, strategy_name(strategy),
                [&] { return plan_by_strategy(strategy, part, cut.ball, options); });
    add_row(comparison, best_name,
            [&] { return plan_by_best_strategy(part, cut.ball, options).plan; });
}

void StrategiesTable::add_left_out(const Comparison& comparison)
{
    std::vector<std::string> words;
    words.reserve(every_strategy.size() + 1);
    for (const Strategy strategy : every_strategy)
        words.emplace_back(strategy_name(strategy));
    words.emplace_back(best_name);
    for (const std::string& word : words) {
        std::vector<CsvCell> row{comparison.title + " " + word};
        row.insert(row.end(), comparison.first_cells.begin(),
                   comparison.first_cells.end());
        row.emplace_back(word);
        row.resize(table_.columns().size() - 2);
        row.emplace_back(std::string{left_out});
        row.emplace_back();
        table_.add_row(row);
    }
}

template <typename Plan>
void StrategiesTable::add_row(Comparison& comparison, std::string_view strategy,
                              const Plan& plan)
{
    std::vector<CsvCell> row{comparison.title + " " + std::string{strategy}};
    row.insert(row.end(), comparison.first_cells.begin(), comparison.first_cells.end());
    row.emplace_back(std::string{strategy});
    std::string refusal;
    const double begin = cpu_s();
    try {
        const StrategyPlan planned = plan();
        for (CsvCell& cell : cells_of(comparison, strategy, planned))
            row.push_back(std::move(cell));
    } catch (const GeometryError& error) {
        refusal = error.what();
    } catch (const LimitError& error) {
        refusal = error.what();
    }
    row.resize(table_.columns().size() - 2);
    row.emplace_back(refusal);
    row.emplace_back(cpu_s() - begin);
    table_.add_row(row);
}

std::vector<CsvCell> StrategiesTable::cells_of(Comparison& comparison,
                                               std::string_view strategy,
                                               const StrategyPlan& plan)
{
    const double cut_mm = plan.economy.cut.contact_mm;
    const auto pieces = static_cast<double>(plan.covering.pieces);
    const std::optional<PathBound>& bound = comparison.bound;
    const double least = bound ? bound->density_mm - pieces * bound->disc_mm : 0;
    check(comparison, strategy, plan, least);
    CsvCell saved;
    if (strategy != best_name && follows_parameters(plan.strategy)) {
        auto& shorter = comparison.along_parameters_mm;
        auto& clean = comparison.clean_along_parameters_mm;
        shorter = std::min(cut_mm, shorter.value_or(cut_mm));
        if (plan.is_good())
            clean = std::min(cut_mm, clean.value_or(cut_mm));
    } else if (comparison.along_parameters_mm) {
        saved = 100 * (1 - cut_mm / *comparison.along_parameters_mm);
    }
    return {std::string{strategy_name(plan.strategy)},
            cut_mm,
            saved,
            plan.economy.cut.tip_mm,
            plan.economy.link.tip_mm,
            count(plan.covering.pieces),
            count(plan.covering.lifted_links),
            count(plan.economy.ncl),
            bound ? CsvCell{bound->density_mm} : CsvCell{},
            bound ? CsvCell{cut_mm / bound->density_mm} : CsvCell{},
            least > 0 ? CsvCell{cut_mm / least} : CsvCell{},
            plan.deviation.max_scallop_mm,
            plan.deviation.max_gouge_mm,
            std::string{verdict_name(plan.verdict)},
            plan.covering.uncovered_mm2};
}

void StrategiesTable::check(const Comparison& comparison, std::string_view strategy,
                            const StrategyPlan& plan, double bound_mm)
{
    const double cut_mm = plan.economy.cut.contact_mm;
    const auto add = [&](const char* what) {
        violations_ += comparison.title;
        violations_ += ' ';
        violations_ += strategy;
        violations_ += what;
    };
    if (cut_mm < bound_mm)
        add(" is shorter than its bound; ");
    if (plan.verdict != Verdict::Clean && plan.covering.uncovered_mm2 == 0)
        add(" is neither clean nor has an uncovered area; ");
    const auto& clean = comparison.clean_along_parameters_mm;
    if (strategy == best_name && clean && !(plan.is_good() && cut_mm <= *clean))
        add(" is longer than a clean path along parameter lines; ");
}

}  // namespace endmill
