// SPDX-License-Identifier: GPL-3.0-or-later
#include "economic-cl-data/lost-surface/searched_tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "economic-cl-data/lost-surface/readings.h"
#include "endmill/core/error.h"
#include "endmill/planning/detail/portable_uniform.h"
#include "endmill/planning/detail/structureless_tables.h"
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

// The irregular row of the print. Indices of direction and tolerance.
constexpr int irregular_direction = 1;
constexpr int irregular_tolerance = 0;

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

// The mean square scatter within a row, from three numbers less their mean.
double row_variance(const RowScatter& row)
{
    return row.squares() / 2;
}

// Numbers of passes with the row effects of the decoded ones and new deviations with the scatter of their
// row. If `is_regular`, the row v, 1 mm has the pooled scatter of the other rows.
DecodedTables renumbered_decoding(std::uint32_t seed, bool is_regular)
{
    DecodedTables decoded = printed_decoding();
    std::array<double, 2> powers{};
    const std::array scatters{row_scatters(decoded.counts[0], powers[0]),
                              row_scatters(decoded.counts[1], powers[1])};
    double pooled = -row_variance(scatters[irregular_direction][irregular_tolerance]);
    for (const auto& direction : scatters)
        for (const RowScatter& row : direction)
            pooled += row_variance(row);
    pooled /= 5;
    PortableUniform uniform{seed};
    const auto draw = [&](int k, int i, double variance) {
        PassPair& pair = decoded.passes[k][i];
        for (int j = 0; j < 3; ++j) {
            const double log_number = scatters[k][i].mean +
                                      powers[k] * std::log(table_diameters_mm[j]) +
                                      std::sqrt(variance) * uniform.normal();
            const int passes = static_cast<int>(std::round(std::exp(log_number)));
            decoded.counts[k][i][j] = passes;
            if (passes % 2 == 1 && !pair.points_forward)
                pair.points_forward = pair.points_a_pair / 2;
        }
    };
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 3; ++i) {
            const bool is_smoothed =
                is_regular && k == irregular_direction && i == irregular_tolerance;
            draw(k, i, is_smoothed ? pooled : row_variance(scatters[k][i]));
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

// A planted surface with one pass more, one less or none, at random for each run.
DecodedTables noisy_decoding(const SearchCase& planted)
{
    DecodedTables decoded = planted_decoding(planted);
    PortableUniform uniform{number_at_end(planted.table)};
    for (auto& direction : decoded.counts)
        for (auto& row : direction)
            for (int& passes : row)
                passes += uniform.below(3) - 1;
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
    ranges.reserve(positions.size());
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
    if (const auto planted = changed_case(search, "noisy-"))
        return noisy_decoding(*planted);
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
    for (const char* change : {"irregular-", "noisy-"})
        if (const auto planted = changed_case(search, change))
            return with_counts(searched_tables(*planted), decoding_of(*planted),
                               decoding_of(search));
    if (const auto whole = changed_case(search, "less-")) {
        EconomyTables tables = searched_tables(*whole);
        tables.runs[irregular_direction][irregular_tolerance] = {};
        return tables;
    }
    throw DomainError{"searched_tables: unknown table " + search.table};
}

CurveTarget searched_target(const SearchCase& search, int curve)
{
    const CurveTarget print = printed_decoding().passes[curve];
    return starts_with(search.table, "targets-")
               ? random_target(print, number_at_end(search.table))
               : print;
}

}  // namespace endmill
