// SPDX-License-Identifier: GPL-3.0-or-later
#include "economic-cl-data/lost-surface/search_case.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <vector>

#include "economic-cl-data/lost-surface/readings.h"
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
constexpr Interval cell_sizes{0.7, 1.4};
constexpr Interval staged_sizes{0.6, 1.6};

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

// The policies of a planted table: those of the search, with the words after a plus.
RunPolicies planted_policies(const SearchCase& search)
{
    const auto plus = search.table.find('+');
    if (plus == std::string::npos)
        return policies_of(search.policies);
    const std::string words =
        search.table.substr(plus + 1, search.table.rfind('-') - plus - 1);
    return policies_of(search.policies + " " + words);
}

// What an interpretation of the planted tables without error would give.
DecodedTables planted_decoding(const SearchCase& search)
{
    const PlantedSurface truth = planted_surface(search);
    const SurfaceFamily family = family_named(search.family);
    RunPolicies policies = planted_policies(search);
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

// Deviations of log N of a row from the common power of R, and their mean.
struct RowScatter {
    std::array<double, 3> deviations;
    double mean;

    double squares() const
    {
        double sum = 0;
        for (const double deviation : deviations)
            sum += (deviation - mean) * (deviation - mean);
        return sum;
    }
};

// log N = row effect + c log R + deviation, with c by least squares from the nine numbers of a direction.
std::array<RowScatter, 3> row_scatters(const std::array<std::array<int, 3>, 3>& counts,
                                       double& power)
{
    std::array<double, 3> logs{};
    double mean_log = 0;
    for (int j = 0; j < 3; ++j) {
        logs[j] = std::log(table_diameters_mm[j]);
        mean_log += logs[j] / 3;
    }
    double products = 0;
    double squares = 0;
    for (const auto& row : counts)
        for (int j = 0; j < 3; ++j) {
            products += (logs[j] - mean_log) * std::log(row[j]);
            squares += (logs[j] - mean_log) * (logs[j] - mean_log);
        }
    power = products / squares;
    std::array<RowScatter, 3> scatters{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            scatters[i].deviations[j] = std::log(counts[i][j]) - power * logs[j];
            scatters[i].mean += scatters[i].deviations[j] / 3;
        }
    return scatters;
}

// A sum of 12 uniform numbers: mean 0, standard deviation 1.
double normal(PortableUniform& uniform)
{
    double sum = -6;
    for (int i = 0; i < 12; ++i)
        sum += uniform(0, 1);
    return sum;
}

// Numbers of passes with the row effects of the decoded ones and new deviations with the scatter of their
// row. If `is_regular`, the row v, 1 mm has the pooled scatter of the other rows.
DecodedTables renumbered_decoding(std::uint32_t seed, bool is_regular)
{
    DecodedTables decoded = printed_decoding();
    PortableUniform uniform{seed};
    std::array<double, 2> powers{};
    std::array<std::array<RowScatter, 3>, 2> scatters{};
    double pooled = 0;
    constexpr int free_numbers = 2;  // three less their mean
    for (int k = 0; k < 2; ++k) {
        scatters[k] = row_scatters(decoded.counts[k], powers[k]);
        for (int i = 0; i < 3; ++i)
            if (k == 0 || i > 0)
                pooled += scatters[k][i].squares() / (5 * free_numbers);
    }
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 3; ++i) {
            const bool is_smoothed = is_regular && k == 1 && i == 0;
            const double scatter =
                std::sqrt(is_smoothed ? pooled : scatters[k][i].squares() / free_numbers);
            PassPair& pair = decoded.passes[k][i];
            for (int j = 0; j < 3; ++j) {
                const int passes = static_cast<int>(std::round(std::exp(
                    scatters[k][i].mean + powers[k] * std::log(table_diameters_mm[j]) +
                    scatter * normal(uniform))));
                decoded.counts[k][i][j] = passes;
                if (passes % 2 == 1 && !pair.points_forward)
                    pair.points_forward = pair.points_a_pair / 2;
            }
        }
    return decoded;
}

// The cells that equal passes have with the numbers of passes of `to`: f, b and L of `from`, and W of each run kept.
EconomyTables with_counts(EconomyTables tables, const DecodedTables& from,
                          const DecodedTables& to)
{
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                const PassPair& pair = from.passes[k][i];
                const int passes = to.counts[k][i][j];
                const int forward = pair.points_forward.value_or(pair.points_a_pair / 2);
                DirectionCost& run = tables.runs[k][i][j];
                const int points =
                    pair.points_a_pair * (passes / 2) + (passes % 2 == 1 ? forward : 0);
                run.ncl = static_cast<std::size_t>(points);
                run.tcd_mm += pair.chord_mm * (passes - from.counts[k][i][j]);
            }
    round_as_printed(tables);
    return tables;
}

bool is_renumbered(const SearchCase& search)
{
    return starts_with(search.table, "renumbered-") ||
           starts_with(search.table, "regular-");
}

// The same case with another table.
SearchCase with_table(SearchCase search, const std::string& table)
{
    search.table = table;
    return search;
}

// The case of the table of which this one is a change; nothing if it is none.
std::optional<SearchCase> changed_case(const SearchCase& search,
                                       const std::string& change)
{
    if (!starts_with(search.table, change.c_str()))
        return std::nullopt;
    return with_table(search, search.table.substr(change.size()));
}

// The irregular row of the print. Indices of direction and tolerance.
constexpr int irregular_direction = 1;
constexpr int irregular_tolerance = 0;

// A planted surface whose run v, 1 mm, 15 mm has fewer passes by the deviation of the print.
DecodedTables irregular_decoding(const SearchCase& planted)
{
    DecodedTables decoded = planted_decoding(planted);
    int& passes = decoded.counts[irregular_direction][irregular_tolerance][1];
    const double percent =
        middle_ball_deviation(printed_tables(), irregular_direction, irregular_tolerance);
    passes = static_cast<int>(std::round(passes * std::exp(percent / 100)));
    return decoded;
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
    stage.curve_searches = search.curves;
    stage.curve_evaluations = search.evaluations;
    stage.accepted_curve_loss = 0;
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
    StagedSearch stages;
    stages.curves = search.curves;
    stages.curve_searches = 10 * search.curves;
    stages.evaluations = search.evaluations;
    stages.most_height = search.most_height;
    stages.seed = search.seed;
    return search_in_stages(family, policies, target, decoding_of(search), stages);
}

// Values in the planted share of their ranges.
std::vector<double> drawn_values(const std::vector<Interval>& ranges,
                                 PortableUniform& uniform)
{
    std::vector<double> values;
    for (const auto [low, high] : ranges) {
        const double middle = (low + high) / 2;
        const double half = planted_share * (high - low) / 2;
        values.push_back(uniform(middle - half, middle + half));
    }
    return values;
}

// Draws the values of a curve until its passes look like those of the print.
void draw_plausible_curve(std::vector<double>& values, SurfaceFamily family, int curve,
                          double most_height, PortableUniform& uniform)
{
    const std::vector<Interval> all = value_ranges(family);
    const std::vector<std::size_t> positions = curve_positions(family, curve);
    std::vector<Interval> ranges;
    for (const std::size_t position : positions)
        ranges.push_back(all[position]);
    std::vector<double> drawn;
    do
        drawn = drawn_values(ranges, uniform);
    while (!is_plausible(family_curve(family, curve, drawn), most_height));
    for (std::size_t i = 0; i < positions.size(); ++i)
        values[positions[i]] = drawn[i];
}

// Whether the cells with 0.5 mm and 15 mm are those of the print times a factor in `sizes`.
bool has_printed_size(const EconomyTables& tables, const Interval& sizes)
{
    const EconomyTables printed = printed_tables();
    for (const Parameter direction : table_directions)
        for (const TableQuantity quantity : table_quantities) {
            const double share = tables.cell(quantity, direction, 1, 1) /
                                 printed.cell(quantity, direction, 1, 1);
            if (share <= sizes.low || share >= sizes.high)
                return false;
        }
    return true;
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

DecodedTables decoding_of(const SearchCase& search)
{
    if (const auto whole = changed_case(search, "less-")) {
        DecodedTables decoded = decoding_of(*whole);
        decoded.counts[irregular_direction][irregular_tolerance] = {};
        return decoded;
    }
    if (const auto planted = changed_case(search, "irregular-"))
        return irregular_decoding(*planted);
    if (starts_with(search.table, "planted"))
        return planted_decoding(search);
    if (is_renumbered(search))
        return renumbered_decoding(number_at_end(search.table),
                                   starts_with(search.table, "regular-"));
    return printed_decoding();
}

PlantedSurface planted_surface(const SearchCase& search)
{
    const SurfaceFamily family = family_named(search.family);
    const RunPolicies policies = planted_policies(search);
    PortableUniform uniform{number_at_end(search.table)};
    while (true) {
        std::vector<double> values = drawn_values(fit_ranges(family), uniform);
        if (search.method == "stages")
            for (int k = 0; k < 2; ++k)
                draw_plausible_curve(values, family, k, search.most_height, uniform);
        auto tables = fitted_tables(family, policies, values);
        if (!tables || !has_printed_size(*tables, search.method == "stages" ? staged_sizes
                                                                            : cell_sizes))
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
    if (starts_with(search.table, "planted"))
        return planted_surface(search).tables;
    if (is_renumbered(search))
        return with_counts(printed_tables(), printed_decoding(), decoding_of(search));
    if (const auto planted = changed_case(search, "irregular-"))
        return with_counts(searched_tables(*planted), decoding_of(*planted),
                           decoding_of(search));
    if (const auto whole = changed_case(search, "less-")) {
        EconomyTables tables = searched_tables(*whole);
        tables.runs[irregular_direction][irregular_tolerance] = {};
        return tables;
    }
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
