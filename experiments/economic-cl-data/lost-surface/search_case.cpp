// SPDX-License-Identifier: GPL-3.0-or-later
#include "economic-cl-data/lost-surface/search_case.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/planning/detail/portable_uniform.h"
#include "endmill/planning/detail/structureless_tables.h"
#include "endmill/surface/extent.h"
#include "support/experiment.h"
#include "support/printed_tables.h"

namespace endmill {
namespace {

// Changes of the heights of a fitted net for null B, mm.
constexpr double net_change_mm = 5;
// Planted surfaces lie in this share of the ranges about their middle, which holds those of the
// size of the paper's tables.
constexpr double planted_share = 0.6;

// The number after the last dash.
std::uint32_t number_at_end(const std::string& text)
{
    return static_cast<std::uint32_t>(std::stoul(text.substr(text.rfind('-') + 1)));
}

bool starts_with(const std::string& text, const char* start)
{
    return text.rfind(start, 0) == 0;
}

void round_as_printed(EconomyTables& tables)
{
    for (auto& direction : tables.runs)
        for (auto& row : direction)
            for (DirectionCost& run : row)
                run.tcd_mm = std::round(10 * run.tcd_mm) / 10;
}

EconomyTables tables_near_net(const std::string& text)
{
    const std::string name = text.substr(4, text.rfind('-') - 4);
    const std::uint32_t seed = number_at_end(text);
    const Surface net = dataset_surface(name);
    // Smooth changes: a bilinear and a wavy one keep the tangent continuity.
    for (std::uint32_t attempt = 0;; ++attempt) {
        PortableUniform uniform{seed + 1000 * attempt};
        const double most = seed == 0 ? 0 : net_change_mm;
        const double a = uniform(-most, most);
        const double b = uniform(-most, most);
        const double c = uniform(-most, most);
        std::vector<BezierPatch> patches;
        for (int j = 0; j < net.patches(Parameter::V); ++j)
            for (int i = 0; i < net.patches(Parameter::U); ++i) {
                std::vector<Vec3> points;
                for (int row = 0; row < 4; ++row)
                    for (int column = 0; column < 4; ++column) {
                        Vec3 point = net.patch(i, j).control_point(column, row);
                        const double x = point.x() / 200;
                        const double y = point.y() / 120;
                        point.z() *= 1 + (a + b * x + c * y) / 110;
                        points.push_back(point);
                    }
                patches.emplace_back(points);
            }
        const auto breaks = [&](Parameter along) {
            const auto span = net.breaks(along);
            return std::vector<double>{span.begin(), span.end()};
        };
        try {
            EconomyTables tables = planned_tables(
                Surface{breaks(Parameter::U), breaks(Parameter::V), patches});
            round_as_printed(tables);
            return tables;
        } catch (const GeometryError&) {
            continue;  // a ball does not fit: another change
        }
    }
}

// What an interpretation of the planted tables without error would give.
DecodedTables planted_decoding(const SearchCase& search)
{
    const PlantedSurface truth = planted_surface(search);
    const SurfaceFamily family = family_named(search.family);
    RunPolicies policies = policies_of(search.policies);
    policies.table.scallop_per_tolerance = truth.values.back();
    const FamilyMember member = family_surface(
        family, std::span<const double>{truth.values}.first(truth.values.size() - 1));
    const auto& surface = std::get<TranslationalSurface>(member);
    DecodedTables decoded = printed_decoding();
    const auto take = [](CurveTarget& target, const CompositeCurve& curve) {
        const auto march = march_both_ways(curve);
        for (int i = 0; march && i < 3; ++i) {
            const CurveMarch& pass = (*march)[i];
            target[i].points_a_pair = pass.points_forward + pass.points_backward;
            target[i].points_forward = pass.points_forward;
            target[i].chord_mm = (pass.forward_mm + pass.backward_mm) / 2;
        }
    };
    take(decoded.passes[0], surface.along_u);
    take(decoded.passes[1], surface.along_v);
    visit_runs(member, policies, [&](const RunPlace& at, const TableRun& run) {
        decoded.counts[at.direction][at.tolerance][at.diameter] = run.passes;
        return true;
    });
    return decoded;
}

// Numbers of passes by the power law of the decoded ones, with the scatter of its residuals.
DecodedTables renumbered_decoding(std::uint32_t seed)
{
    DecodedTables decoded = printed_decoding();
    EconomyTables numbers = printed_tables();
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                numbers.runs[k][i][j].ncl =
                    static_cast<std::size_t>(decoded.counts[k][i][j]);
    const EconomyTables drawn = structureless_tables(numbers, seed);
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                decoded.counts[k][i][j] = static_cast<int>(drawn.runs[k][i][j].ncl);
    return decoded;
}

// The cells that equal passes of the print have with the numbers of passes of `decoded`: f, b and L as
// decoded, W of the row kept.
EconomyTables renumbered_tables(std::uint32_t seed)
{
    const DecodedTables moved = renumbered_decoding(seed);
    const DecodedTables decoded = printed_decoding();
    EconomyTables tables = printed_tables();
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                const PassPair& pair = decoded.passes[k][i];
                const int passes = moved.counts[k][i][j];
                const int forward = pair.points_forward.value_or(pair.points_a_pair / 2);
                DirectionCost& run = tables.runs[k][i][j];
                const int points =
                    pair.points_a_pair * (passes / 2) + (passes % 2 == 1 ? forward : 0);
                run.ncl = static_cast<std::size_t>(points);
                run.tcd_mm += pair.chord_mm * (passes - decoded.counts[k][i][j]);
            }
    round_as_printed(tables);
    return tables;
}

// Numbers like those of target 1 that no curve need have: up to two points more or less a pair, f within
// one of half, all lengths up to 5 % more or less with half to one and a half of their differences.
CurveTarget random_target(const CurveTarget& print, std::uint32_t seed)
{
    PortableUniform uniform{seed};
    const double scale = uniform(0.95, 1.05);
    const double spread = uniform(0.5, 1.5);
    CurveTarget target = print;
    const double longest = print.back().chord_mm;
    for (PassPair& pair : target) {
        pair.points_a_pair += uniform.below(5) - 2;
        const int forward = pair.points_a_pair / 2 + uniform.below(3) - 1;
        if (pair.points_forward)
            pair.points_forward = forward;
        pair.chord_mm = scale * (longest - spread * (longest - pair.chord_mm));
    }
    return target;
}

// Number of curves that the first stage finds.
int curves_found(const SearchCase& search, int curve)
{
    CurveTarget target = printed_decoding().passes[curve];
    if (starts_with(search.table, "targets-"))
        target = random_target(target, number_at_end(search.table));
    StagedSearch stage;
    stage.curves = search.curves;
    stage.curve_evaluations = search.evaluations;
    stage.most_height = search.most_height;
    stage.seed = search.seed;
    return static_cast<int>(
        search_curves(family_named(search.family), curve, target, stage).size());
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
    const DecodedTables decoded = starts_with(search.table, "planted-")
                                      ? planted_decoding(search)
                                  : starts_with(search.table, "renumbered-")
                                      ? renumbered_decoding(number_at_end(search.table))
                                      : printed_decoding();
    StagedSearch stages;
    stages.curves = search.curves;
    stages.refined_evaluations = search.evaluations;
    stages.most_height = search.most_height;
    stages.seed = search.seed;
    stages.accepted_loss = 0.5;  // the fit of pairs corrects the rest
    stages.fitted = std::max(10, search.curves / 5);
    return search_in_stages(family, policies, target, decoded, stages);
}

CsvCell list_of(const std::vector<double>& values)
{
    std::string text = "values";  // a text that begins with a sign would be quoted
    for (const double value : values)
        text += " " + to_text(value);
    return text;
}

double height_of(SurfaceFamily family, std::span<const double> values)
{
    const Surface surface =
        as_surface(family_surface(family, values.first(values.size() - 1)));
    return extent(surface, Vec3::UnitZ()).length();
}

}  // namespace

PlantedSurface planted_surface(const SearchCase& search)
{
    const SurfaceFamily family = family_named(search.family);
    const RunPolicies policies = policies_of(search.policies);
    const EconomyTables printed = printed_tables();
    PortableUniform uniform{number_at_end(search.table)};
    while (true) {
        std::vector<double> values;
        for (const auto [low, high] : fit_ranges(family)) {
            const double middle = (low + high) / 2;
            const double half = planted_share * (high - low) / 2;
            values.push_back(uniform(middle - half, middle + half));
        }
        auto tables = fitted_tables(family, policies, values);
        if (!tables)
            continue;
        bool is_similar = true;
        for (const Parameter direction : table_directions)
            for (const TableQuantity quantity : table_quantities) {
                const double share = tables->cell(quantity, direction, 1, 1) /
                                     printed.cell(quantity, direction, 1, 1);
                is_similar = is_similar && 0.7 < share && share < 1.4;
            }
        if (!is_similar)
            continue;
        round_as_printed(*tables);
        return {values, *tables};
    }
}

RunPolicies policies_of(const std::string& text)
{
    RunPolicies policies;
    IsoParametricOptions& plan = policies.table.plan;
    const std::map<std::string, std::function<void()>> words{
        {"alternate", [&] { plan.march = March::Alternate; }},
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

DecodedTables printed_decoding()
{
    const auto pair = [](int points, std::optional<int> forward, double chord,
                         double tolerance) {
        return PassPair{points, forward, chord, tolerance};
    };
    const CurveTarget u{pair(25, {}, 347.66, 0.5), pair(36, 17, 349.31, 0.3),
                        pair(57, 29, 350.25, 0.2)};
    const CurveTarget v{pair(12, 7, 204.24, 0.5), pair(18, 10, 206.87, 0.3),
                        pair(27, 14, 206.97, 0.2)};
    return {{u, v},
            {{{{{52, 42, 36}, {73, 59, 51}, {115, 94, 81}}},
              {{{81, 64, 58}, {112, 91, 79}, {174, 143, 123}}}}}};
}

EconomyTables searched_tables(const SearchCase& search)
{
    if (search.table == "print")
        return printed_tables();
    if (starts_with(search.table, "null-"))
        return structureless_tables(printed_tables(), number_at_end(search.table));
    if (starts_with(search.table, "net-"))
        return tables_near_net(search.table);
    if (starts_with(search.table, "planted-"))
        return planted_surface(search).tables;
    if (starts_with(search.table, "renumbered-"))
        return renumbered_tables(number_at_end(search.table));
    throw DomainError{"searched_tables: unknown table " + search.table};
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
                               height_of(family, fit.values), list_of(fit.values)});
    } else {
        row.insert(row.end(), 7, CsvCell{});
    }
    table.add_row(row);
    return table;
}

}  // namespace endmill
