// SPDX-License-Identifier: GPL-3.0-or-later
#include "economic-cl-data/lost-surface/short_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "economic-cl-data/lost-surface/readings.h"
#include "economic-cl-data/lost-surface/search_case.h"
#include "economic-cl-data/lost-surface/searched_tables.h"
#include "endmill/core/text.h"
#include "endmill/figures/tool_path_svg.h"
#include "endmill/files/surface_file.h"
#include "endmill/planning/detail/integer_decoding.h"
#include "endmill/planning/detail/structureless_tables.h"
#include "endmill/surface/extent.h"
#include "endmill/surface/nurbs.h"
#include "support/printed_tables.h"

namespace endmill {
namespace {

constexpr SurfaceFamily curves_family = SurfaceFamily::Translational;
// Extent of the paper's part and what another extent costs. Source: [KimChoi, fig. 2], criterion.md.
constexpr double printed_height_mm = 220;
constexpr double height_tolerance_mm = 1;
constexpr double wrong_extent_bits = 10;

// A row of the result; empty cells are unknown.
struct ResultRow {
    std::string name;
    std::optional<int> count = {};
    std::optional<int> tried = {};
    std::optional<double> low = {};
    std::optional<double> high = {};
    std::optional<TableMatch> match = {};
    std::optional<double> value_bits = {};
    std::optional<double> score_bits = {};
};

CsvTable empty_result()
{
    return CsvTable{{"row", "count", "tried", "low", "high", "ncl_matched", "tcd_matched",
                     "rms_percent", "worst_percent", "deviation_bits", "information_bits",
                     "choice_bits", "value_bits", "score_bits"}};
}

template <typename Number>
CsvCell cell_of(const std::optional<Number>& number)
{
    if (!number)
        return {};
    if constexpr (std::is_same_v<Number, int>)
        return std::int64_t{*number};
    else
        return *number;
}

void add(CsvTable& table, const ResultRow& row)
{
    std::vector<CsvCell> cells{row.name, cell_of(row.count), cell_of(row.tried),
                               cell_of(row.low), cell_of(row.high)};
    if (row.match)
        cells.insert(cells.end(),
                     {std::int64_t{row.match->ncl}, std::int64_t{row.match->tcd},
                      row.match->rms_percent, row.match->worst_percent,
                      row.match->deviation, row.match->information, row.match->choice});
    else
        cells.insert(cells.end(), 7, CsvCell{});
    cells.push_back(cell_of(row.value_bits));
    cells.push_back(cell_of(row.score_bits));
    table.add_row(cells);
}

void add_readings(CsvTable& table, Experiment& run)
{
    const EconomyTables printed = printed_tables();
    const DecodedTables decoded = printed_decoding();
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 3; ++i) {
            const Surplus surplus = surplus_points(printed, decoded, k, i);
            add(table, {.name = table_row_label("surplus points", table_tolerances_mm[i],
                                                table_directions[k]),
                        .low = surplus.low,
                        .high = surplus.high});
        }
    const double ratio = run.number("scallop_per_tolerance");
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 3; ++i)
            add(table,
                {.name = table_row_label("spread of TCD times interval, %",
                                         table_tolerances_mm[i], table_directions[k]),
                 .low = 100 * interval_spread(printed, k, i, ratio)});
    const double factor = run.number("interval_factor");
    for (const auto& [name, last_path] :
         {std::pair{"border", LastPath::Border}, std::pair{"half", LastPath::Half},
          std::pair{"none", LastPath::None}}) {
        const LinkContradiction least =
            link_contradiction(printed, decoded, last_path, factor);
        add(table,
            {.name = std::string{"contradiction of the links, mm: last path "} + name,
             .low = least.excess_mm});
    }
}

void add_null_readings(CsvTable& table, Experiment& run)
{
    const EconomyTables printed = printed_tables();
    const DecodingRules rules{run.number("decoding_tolerance_mm"),
                              run.number("chord_spread"), run.number("longest_chord")};
    const int tables = static_cast<int>(run.number("null_tables"));
    std::array<int, 2> triples{};
    int rows = 0;
    for (int seed = 1; seed <= tables; ++seed) {
        const EconomyTables null =
            structureless_tables(printed, static_cast<std::uint32_t>(seed));
        for (int k = 0; k < 2; ++k) {
            const auto readings = readings_of(null, k, rules);
            for (const std::vector<Decoding>& row : readings)
                rows += row.empty() ? 0 : 1;
            triples[k] += one_chord_triples(readings, rules.chord_spread) > 0 ? 1 : 0;
        }
    }
    add(table,
        {.name = "null A rows with a reading", .count = rows, .tried = 6 * tables});
    add(table, {.name = "null A triples with a reading, u",
                .count = triples[0],
                .tried = tables});
    add(table, {.name = "null A triples with a reading, v",
                .count = triples[1],
                .tried = tables});
}

// The search of the table of a random translational surface with passes like those of the print.
SearchCase planted_case(Experiment& run, int seed)
{
    return {"",
            "stages",
            "planted-" + std::to_string(seed),
            "translational",
            run.text("policies"),
            1,
            0,
            0,
            run.number("most_height_mm")};
}

// How often the interpretation of a row of a random translational surface is the truth.
void add_planted_readings(CsvTable& table, Experiment& run, const std::string& tolerance)
{
    const DecodingRules rules{run.number(tolerance), run.number("chord_spread"),
                              run.number("longest_chord")};
    const int surfaces = static_cast<int>(run.number("read_surfaces"));
    int read = 0;
    for (int seed = 1; seed <= surfaces; ++seed) {
        const SearchCase planted = planted_case(run, seed);
        const EconomyTables tables = planted_surface(planted).tables;
        const DecodedTables truth = decoding_of(planted);
        for (int k = 0; k < 2; ++k) {
            const auto readings = readings_of(tables, k, rules);
            for (int i = 0; i < 3; ++i)
                read += std::ranges::any_of(readings[i], [&](const Decoding& reading) {
                    return reading.points_a_pair == truth.passes[k][i].points_a_pair &&
                           reading.passes == truth.counts[k][i];
                });
        }
    }
    add(table, {.name = "rows of random surfaces whose readings contain the truth, " +
                        to_text(rules.tolerance_mm) + " mm",
                .count = read,
                .tried = 6 * surfaces});
}

// How often a random translational surface has a row as irregular as the most irregular one of the print, and how
// irregular its row v, 1 mm is.
void add_random_rows(CsvTable& table, Experiment& run)
{
    const auto deviations = [](const EconomyTables& tables) {
        std::array<std::array<double, 3>, 2> percent{};
        for (int k = 0; k < 2; ++k)
            for (int i = 0; i < 3; ++i)
                percent[k][i] = middle_ball_deviation(tables, k, i);
        return percent;
    };
    const auto largest = [&](const EconomyTables& tables) {
        double most = 0;
        for (const auto& direction : deviations(tables))
            for (const double percent : direction)
                most = std::max(most, std::abs(percent));
        return most;
    };
    const EconomyTables printed = printed_tables();
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 3; ++i)
            add(table,
                {.name = table_row_label("middle ball off the power law, %",
                                         table_tolerances_mm[i], table_directions[k]),
                 .low = deviations(printed)[k][i]});
    const int surfaces = static_cast<int>(run.number("random_surfaces"));
    int irregular = 0;
    Interval range{1e9, -1e9};
    for (int seed = 1; seed <= surfaces; ++seed) {
        const EconomyTables tables = planted_surface(planted_case(run, seed)).tables;
        irregular += largest(tables) >= largest(printed) ? 1 : 0;
        const double row = deviations(tables)[1][0];
        range = {std::min(range.low, row), std::max(range.high, row)};
    }
    add(table, {.name = "random surfaces with a row as irregular as v, 1 mm in print",
                .count = irregular,
                .tried = surfaces});
    add(table, {.name = "random surfaces: row v, 1 mm off the power law, %",
                .tried = surfaces,
                .low = range.low,
                .high = range.high});
}

void add_curves(CsvTable& table, Experiment& run)
{
    CurveSearch search;
    search.most_height = run.number("most_height_mm");
    search.wanted = static_cast<int>(run.number("curve_searches"));
    search.searches = search.wanted;
    search.accepted_loss = 0;
    search.evaluations = static_cast<int>(run.number("curve_evaluations"));
    const DecodedTables decoded = printed_decoding();
    for (int k = 0; k < 2; ++k) {
        const auto curves = search_curves(curves_family, k, decoded.passes[k], search);
        const std::string name = k == 0 ? "target 1 u: " : "target 1 v: ";
        add(table, {.name = name + "curves found",
                    .count = static_cast<int>(curves.size()),
                    .tried = search.searches});
        std::array<Interval, 4> ranges;
        ranges.fill({1e9, -1e9});
        for (const std::vector<double>& values : curves) {
            const CompositeCurve curve = family_curve(curves_family, k, values);
            const CurveIntegrals integrals = curve_integrals(curve);
            const std::array numbers{integrals.arc_mm, integrals.turning,
                                     integrals.root_curvature, height_of(curve)};
            for (int n = 0; n < 4; ++n)
                ranges[n] = {std::min(ranges[n].low, numbers[n]),
                             std::max(ranges[n].high, numbers[n])};
        }
        constexpr std::array names{"arc, mm", "turning, rad",
                                   "integral of sqrt(k), sqrt(mm)", "height, mm"};
        for (int n = 0; n < 4 && !curves.empty(); ++n)
            add(table,
                {.name = name + names[n], .low = ranges[n].low, .high = ranges[n].high});
    }
}

void add_small_search(CsvTable& table, Experiment& run)
{
    const int evaluations = static_cast<int>(run.number("evaluations"));
    const std::string policies = run.text("policies");
    for (const std::string& name : run.texts("searched_tables")) {
        const SearchCase search{"",          "cells", name, "translational", policies, 1,
                                evaluations, 0,       0};
        const EconomyTables target = searched_tables(search);
        const RunPolicies parsed = policies_of(policies);
        const TableFit fit = search_cells(curves_family, parsed, target,
                                          {.evaluations = evaluations, .seed = 1});
        ResultRow row{.name = "search of " + name};
        if (const auto cells = fitted_tables(curves_family, parsed, fit.values))
            row.match = table_match(*cells, target);
        add(table, row);
    }
}

// A surface of the file of the best.
struct BestSurface {
    std::string name;
    SurfaceFamily family;
    RunPolicies policies;
    std::vector<double> values;
};

std::vector<BestSurface> read_best(const std::filesystem::path& file)
{
    const CsvTable table = read_csv(file);
    std::vector<BestSurface> surfaces;
    for (std::size_t i = 0; i < table.rows(); ++i) {
        surfaces.push_back({table.cell(i, "name"), family_named(table.cell(i, "family")),
                            policies_of(table.cell(i, "policies")),
                            values_of(table.cell(i, "values"))});
    }
    return surfaces;
}

// The values of the family: all but the last, h / delta.
std::span<const double> without_ratio(const std::vector<double>& values)
{
    return std::span<const double>{values}.first(values.size() - 1);
}

// The cells of a target of criterion.md.
struct Target {
    std::string name;
    std::span<const Parameter> directions;
    std::span<const TableQuantity> quantities;
};

// Adds the score of a surface against the cells `wanted`.
void add_score(CsvTable& table, const BestSurface& best, const EconomyTables& wanted,
               const Target& target, double choice_bits)
{
    const auto match_of = [&](std::span<const double> values) -> TableMatch {
        const auto cells = fitted_tables(best.family, best.policies, values);
        return cells ? table_match(*cells, wanted, target.directions, target.quantities)
                     : TableMatch{};
    };
    const TableMatch match = match_of(best.values);
    const double value_bits = bits_of_values(best.values, fit_ranges(best.family),
                                             [&](std::span<const double> v) {
                                                 const TableMatch moved = match_of(v);
                                                 return moved.ncl + moved.tcd;
                                             });
    const double height =
        extent(as_surface(family_surface(best.family, without_ratio(best.values))),
               Vec3::UnitZ())
            .length();
    const bool has_extent = std::abs(height - printed_height_mm) <= height_tolerance_mm;
    add(table, {.name = best.name + ": " + target.name,
                .match = match,
                .value_bits = value_bits,
                .score_bits = match.information - match.choice - value_bits -
                              choice_bits - (has_extent ? 0 : wrong_extent_bits)});
}

// The contacts of the run of [KimChoi, fig. 12 and 13] in cutting order.
std::string passes_svg(const BestSurface& best, Parameter direction)
{
    const Surface surface =
        as_surface(family_surface(best.family, without_ratio(best.values)));
    TablePolicies policies = best.policies.table;
    policies.scallop_per_tolerance = best.values.back();
    constexpr int middle = 1;  // 0.5 mm and 15 mm
    const IsoParametricPlan plan =
        table_plan(surface, policies, direction, table_tolerances_mm[middle],
                   table_diameters_mm[middle]);
    const DirectionCost cost = path_cost(plan.path, policies);
    const char* letter = direction == Parameter::U ? "u" : "v";
    FigureOptions options;
    options.title = std::string{"Passes along "} + letter + ", fit \"" + best.name +
                    "\", not the authors' surface";
    options.captions = {
        "tolerance 0.5 mm, ball of 15 mm: NCL " + to_text(double(cost.ncl)) + ", TCD " +
        to_text(std::round(10 * cost.tcd_mm) / 10) + " mm, " +
        to_text(double(plan.governing.size())) + " passes; 200 x 120 x " +
        to_text(std::round(extent(surface, Vec3::UnitZ()).length())) + " mm"};
    return tool_path_svg(plan.path, options);
}

// The surface as a file for the program.
std::string surface_file(const BestSurface& best)
{
    const Surface surface =
        as_surface(family_surface(best.family, without_ratio(best.values)));
    return surface_text(nurbs_of(surface), ToolSide::Up, best.name,
                        "a fit of experiments/economic-cl-data/lost-surface, not the "
                        "surface of the paper");
}

// The 18 runs of a surface beside the print.
void add_cells(CsvTable& cells, const BestSurface& best, const EconomyTables& printed)
{
    const auto tables = fitted_tables(best.family, best.policies, best.values);
    for (int k = 0; tables && k < 2; ++k)
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                const DirectionCost& run = tables->runs[k][i][j];
                const DirectionCost& print = printed.runs[k][i][j];
                cells.add_row(
                    {best.name, std::string{k == 0 ? "u" : "v"}, table_tolerances_mm[i],
                     table_diameters_mm[j], static_cast<std::int64_t>(run.ncl),
                     static_cast<std::int64_t>(print.ncl), run.tcd_mm, print.tcd_mm});
            }
}

}  // namespace

CsvTable short_result(Experiment& run)
{
    CsvTable table = empty_result();
    add_readings(table, run);
    add_null_readings(table, run);
    add_planted_readings(table, run, "decoding_tolerance_mm");
    add_planted_readings(table, run, "planted_decoding_tolerance_mm");
    add_random_rows(table, run);
    add_curves(table, run);
    add_small_search(table, run);
    return table;
}

void add_best_surfaces(CsvTable& result, Experiment& run,
                       const std::filesystem::path& surfaces)
{
    static constexpr std::array u{Parameter::U};
    static constexpr std::array v{Parameter::V};
    static constexpr std::array ncl{TableQuantity::Ncl};
    const std::array targets{Target{"target 2, NCL of u", u, ncl},
                             Target{"target 3, NCL of v", v, ncl},
                             Target{"target 4, all", table_directions, table_quantities}};
    const double choice_bits = std::log2(run.number("cases_searched"));
    CsvTable cells{{"surface", "direction", "tolerance_mm", "diameter_mm", "ncl",
                    "printed_ncl", "tcd_mm", "printed_tcd_mm"}};
    const EconomyTables printed = printed_tables();
    // The criterion can be passed: a surface against its own cells.
    const SearchCase own{
        "", "cells", "planted-1", "translational", run.text("policies"), 1, 0, 0, 0};
    PlantedSurface planted = planted_surface(own);
    add_score(result,
              {"a random surface, its own cells", family_named(own.family),
               policies_of(own.policies), std::move(planted.values)},
              planted.tables, targets.back(), choice_bits);
    for (const BestSurface& best : read_best(surfaces)) {
        for (const Target& target : targets)
            add_score(result, best, printed, target, choice_bits);
        for (const Parameter direction : table_directions)
            run.write(best.name + (direction == Parameter::U ? "-u.svg" : "-v.svg"),
                      passes_svg(best, direction));
        run.write(best.name + ".json", surface_file(best));
        add_cells(cells, best, printed);
    }
    run.write("best-cells.csv", cells.text());
}

}  // namespace endmill
