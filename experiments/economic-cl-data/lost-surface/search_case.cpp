// SPDX-License-Identifier: GPL-3.0-or-later
#include "economic-cl-data/lost-surface/search_case.h"

#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <sstream>
#include <utility>

#include "economic-cl-data/lost-surface/searched_tables.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/surface/extent.h"
#include "support/experiment.h"

namespace endmill {
namespace {

// Number of curves that the first stage finds.
int curves_found(const SearchCase& search, int curve)
{
    CurveSearch effort;
    effort.wanted = search.curves;
    effort.searches = search.curves;
    effort.evaluations = search.evaluations;
    effort.accepted_loss = 0;
    effort.most_height = search.most_height;
    effort.seed = search.seed;
    return static_cast<int>(search_curves(family_named(search.family), curve,
                                          searched_target(search, curve), effort)
                                .size());
}

// The result of the first stage alone.
CsvTable run_curve_case(const SearchCase& search)
{
    CsvTable table = search_table();
    const int curve = search.method == "curve-u" ? 0 : 1;
    std::vector<CsvCell> row(table.columns().size());
    row[0] = search.name;
    row[1] = search.method;
    row[2] = search.table;
    row[3] = search.family;
    row[5] = std::int64_t{search.seed};
    row[6] = std::int64_t{search.curves} * search.evaluations;
    row[7 + curve] = std::int64_t{curves_found(search, curve)};
    table.add_row(row);
    return table;
}

// The staged search of a case.
StagedFit staged_fit(const SearchCase& search, SurfaceFamily family,
                     const RunPolicies& policies, const EconomyTables& target)
{
    StagedSearch stages;
    stages.curves.wanted = search.curves;
    stages.curves.searches = 10 * search.curves;
    stages.curves.most_height = search.most_height;
    stages.curves.seed = search.seed;
    stages.evaluations = search.evaluations;
    stages.seed = search.seed;
    return search_in_stages(family, policies, target, decoding_of(search), stages);
}

CsvCell list_of(const std::vector<double>& values)
{
    std::string text = "values";  // a text that begins with a sign would be quoted
    for (const double value : values)
        text += " " + to_text(value);
    return text;
}

double extent_height(SurfaceFamily family, std::span<const double> values)
{
    const Surface surface =
        as_surface(family_surface(family, values.first(values.size() - 1)));
    return extent(surface, Vec3::UnitZ()).length();
}

}  // namespace

RunPolicies policies_of(const std::string& text)
{
    RunPolicies policies;
    IsoParametricOptions& plan = policies.table.plan;
    const std::map<std::string, std::function<void()>> words{
        {"alternate", [&] { plan.march = March::Alternate; }},
        {"border", [&] { plan.last_path = LastPath::Border; }},
        {"none", [&] { plan.last_path = LastPath::None; }},
        {"half", [&] { plan.last_path = LastPath::Half; }},
        {"free", [&] { plan.end_point = EndPoint::Free; }},
        {"stop", [&] { plan.patch_borders = PatchBorders::Stop; }},
        {"normal", [&] { plan.step_curvature = StepCurvature::Normal; }},
        {"first-pass", [&] { policies.points_of_first_pass = true; }},
        {"dense-min", [&] { plan.governing = Governing::DenseMin; }},
        {"mean", [&] { plan.governing = Governing::Mean; }},
        {"first", [&] { plan.governing = Governing::First; }},
        {"max", [&] { plan.governing = Governing::Max; }},
        {"tip", [&] { policies.table.distance = TravelKind::Tip; }},
        {"cuts", [&] { policies.table.counted = CountedMoves::Cuts; }},
        {"single", [&] { policies.interval = IntervalArithmetic::PrintedSingle; }},
        {"diameter", [&] { policies.radius_per_diameter = 1; }},
        {"chord", [&] { plan.cross_curvature = CrossCurvature::Chord; }},
        {"default", [] {}}};
    std::istringstream input{text};
    for (std::string word; input >> word;) {
        const auto found = words.find(word);
        if (found == words.end())
            throw DomainError{"policies_of: unknown word " + word};
        found->second();
    }
    return policies;
}

std::vector<double> values_of(const std::string& text)
{
    std::istringstream input{text};
    std::string word;
    input >> word;
    std::vector<double> values;
    for (double value = 0; input >> value;)
        values.push_back(value);
    return values;
}

CsvTable search_table()
{
    return CsvTable{{"row", "method", "table", "family", "policies", "seed",
                     "evaluations", "curves_u", "curves_v", "passes_off_percent",
                     "ncl_matched", "tcd_matched", "rms_percent", "worst_percent",
                     "deviation_bits", "height_mm", "values"}};
}

CsvTable run_case(const SearchCase& search)
{
    if (search.method == "curve-u" || search.method == "curve-v")
        return run_curve_case(search);
    CsvTable table = search_table();
    const SurfaceFamily family = family_named(search.family);
    const RunPolicies policies = policies_of(search.policies);
    const EconomyTables target = searched_tables(search);
    TableFit fit;
    CsvCell curves_u;
    CsvCell curves_v;
    CsvCell passes_off;
    if (search.method == "stages") {
        StagedFit found = staged_fit(search, family, policies, target);
        curves_u = std::int64_t{found.curves_found[0]};
        curves_v = std::int64_t{found.curves_found[1]};
        if (std::isfinite(found.passes_percent))
            passes_off = found.passes_percent;
        fit = std::move(found.best);
    } else if (search.method == "cells") {
        fit = search_cells(family, policies, target,
                           {.evaluations = search.evaluations, .seed = search.seed});
    } else {
        throw DomainError{"run_case: unknown method " + search.method};
    }
    std::vector<CsvCell> row{search.name,
                             search.method,
                             search.table,
                             search.family,
                             search.policies,
                             std::int64_t{search.seed},
                             std::int64_t{fit.evaluations},
                             curves_u,
                             curves_v,
                             passes_off};
    const auto tables =
        fit.values.empty() ? std::nullopt : fitted_tables(family, policies, fit.values);
    if (tables) {
        const TableMatch match = table_match(*tables, target);
        row.insert(row.end(), {std::int64_t{match.ncl}, std::int64_t{match.tcd},
                               match.rms_percent, match.worst_percent, match.deviation,
                               extent_height(family, fit.values), list_of(fit.values)});
    } else {
        row.insert(row.end(), 7, CsvCell{});
    }
    table.add_row(row);
    return table;
}

}  // namespace endmill
