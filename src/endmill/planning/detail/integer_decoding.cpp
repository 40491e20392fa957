// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/integer_decoding.h"

#include <algorithm>
#include <cmath>

#include "endmill/planning/detail/portable_uniform.h"
#include "endmill/planning/path_interval.h"

namespace endmill {
namespace {

// The whole numbers of an interpretation.
struct Counts {
    std::optional<int> points_forward;
    std::array<int, 3> passes;
};

// Numbers of passes for a given f + b. For odd N the remainder of NCL is f, which must be
// the same for all three balls; none if it is not, or if two balls have equal numbers of
// passes.
std::optional<Counts> counts_for(const std::array<int, 3>& ncl, int points_a_pair)
{
    Counts counts{};
    for (int j = 0; j < 3; ++j) {
        const int rest = ncl[j] % points_a_pair;
        if (rest != 0 && counts.points_forward.value_or(rest) != rest)
            return std::nullopt;
        if (rest != 0)
            counts.points_forward = rest;
        counts.passes[j] = 2 * (ncl[j] / points_a_pair) + (rest != 0 ? 1 : 0);
    }
    const auto& [a, b, c] = counts.passes;
    if (a == b || b == c || a == c)
        return std::nullopt;
    return counts;
}

Decoding fitted(const Counts& counts, int points_a_pair,
                const std::array<double, 3>& tcd_mm)
{
    double mean_passes = 0;
    double mean_travel = 0;
    for (int j = 0; j < 3; ++j) {
        mean_passes += counts.passes[j] / 3.0;
        mean_travel += tcd_mm[j] / 3;
    }
    double xy = 0;
    double xx = 0;
    for (int j = 0; j < 3; ++j) {
        const double x = counts.passes[j] - mean_passes;
        xy += x * (tcd_mm[j] - mean_travel);
        xx += x * x;
    }
    const double chord = xy / xx;
    const double link = mean_travel - chord * mean_passes;
    double residual = 0;
    for (int j = 0; j < 3; ++j)
        residual =
            std::max(residual, std::abs(counts.passes[j] * chord + link - tcd_mm[j]));
    return {points_a_pair, counts.points_forward, counts.passes, chord, link, residual};
}

// Extent of the part along the passes, mm.
double width_along(Parameter direction)
{
    return direction == Parameter::U ? 200 : 120;
}

// Properties that the three rows of a synthetic triple share.
struct SyntheticPart {
    Parameter direction;
    double chord_mm;
    double link_mm;
};

CostRow synthetic_row(const EconomyTables& printed, const SyntheticPart& part,
                      int tolerance, PortableUniform& uniform)
{
    constexpr int middle = 1;  // index of the ball whose printed cell sets the size
    const auto cell = [&](TableQuantity quantity) {
        return printed.cell(quantity, part.direction, tolerance, middle);
    };
    const auto interval = [&](int diameter) {
        const BallCutter ball{table_diameters_mm[diameter] / 2};
        return path_interval(ball, 0, table_tolerances_mm[tolerance]).chord;
    };
    // Real numbers near the printed ones, not rounded.
    const double passes = cell(TableQuantity::Tcd) / part.chord_mm * uniform(0.9, 1.1);
    const double points_a_pass = cell(TableQuantity::Ncl) / passes * uniform(0.9, 1.1);
    constexpr double scatter_mm = 0.5;  // of the printed (NCL, TCD) about a line
    CostRow row{};
    for (int j = 0; j < 3; ++j) {
        row.ncl[j] = static_cast<int>(
            std::lround(points_a_pass * passes * interval(middle) / interval(j)));
        const double travel = part.chord_mm / points_a_pass * row.ncl[j] + part.link_mm +
                              uniform(-scatter_mm, scatter_mm);
        row.tcd_mm[j] = std::round(10 * travel) / 10;  // as printed
    }
    return row;
}

bool have_one_chord(std::span<const Decoding> readings, double spread)
{
    const auto [least, greatest] = std::ranges::minmax(readings, {}, &Decoding::chord_mm);
    double mean = 0;
    for (const Decoding& reading : readings)
        mean += reading.chord_mm / static_cast<double>(readings.size());
    return greatest.chord_mm - least.chord_mm <= spread * mean;
}

}  // namespace

std::vector<Decoding> decodings(const CostRow& row, double tolerance_mm,
                                const Interval& chord_mm)
{
    std::vector<Decoding> found;
    for (int pair = 2; pair <= *std::ranges::min_element(row.ncl); ++pair) {
        const auto counts = counts_for(row.ncl, pair);
        if (!counts)
            continue;
        const Decoding decoding = fitted(*counts, pair, row.tcd_mm);
        if (decoding.residual_mm <= tolerance_mm && chord_mm.low <= decoding.chord_mm &&
            decoding.chord_mm <= chord_mm.high)
            found.push_back(decoding);
    }
    return found;
}

int one_chord_triples(std::span<const std::vector<Decoding>, 3> readings, double spread)
{
    int count = 0;
    for (const Decoding& a : readings[0])
        for (const Decoding& b : readings[1])
            for (const Decoding& c : readings[2])
                count += have_one_chord(std::array{a, b, c}, spread) ? 1 : 0;
    return count;
}

Interval chord_bounds(Parameter direction, const DecodingRules& rules)
{
    const double width = width_along(direction);
    return {width, rules.longest_chord * width};
}

std::array<std::vector<Decoding>, 3> readings_of(const EconomyTables& tables,
                                                 std::size_t direction,
                                                 const DecodingRules& rules)
{
    std::array<std::vector<Decoding>, 3> readings;
    for (int i = 0; i < 3; ++i) {
        CostRow row{};
        for (int j = 0; j < 3; ++j) {
            const DirectionCost& run = tables.runs[direction][i][j];
            row.ncl[j] = static_cast<int>(run.ncl);
            row.tcd_mm[j] = run.tcd_mm;
        }
        readings[i] = decodings(row, rules.tolerance_mm,
                                chord_bounds(table_directions[direction], rules));
    }
    return readings;
}

NullTest null_test(const EconomyTables& printed, const DecodingRules& rules, int triples,
                   std::uint32_t seed)
{
    PortableUniform uniform{seed};
    NullTest test{3 * triples, 0, triples, 0};
    for (int k = 0; k < triples; ++k) {
        const Parameter direction = table_directions[k % 2];
        const double chord = width_along(direction) * uniform(1.2, 2.4);
        const SyntheticPart part{direction, chord, uniform(100, 500)};
        std::array<std::vector<Decoding>, 3> readings;
        for (int i = 0; i < 3; ++i) {
            readings[i] = decodings(synthetic_row(printed, part, i, uniform),
                                    rules.tolerance_mm, chord_bounds(direction, rules));
            test.rows_read += readings[i].empty() ? 0 : 1;
        }
        test.triples_read += one_chord_triples(readings, rules.chord_spread) > 0 ? 1 : 0;
    }
    return test;
}

}  // namespace endmill
