// SPDX-License-Identifier: GPL-3.0-or-later
#include "economic-cl-data/decode/tables.h"

#include <algorithm>
#include <array>
#include <string>

#include "endmill/core/text.h"
#include "support/printed_tables.h"

namespace endmill {
namespace {

using Readings = std::vector<Decoding>;

CostRow printed_row(const EconomyTables& printed, Parameter direction, int tolerance)
{
    CostRow row{};
    for (int j = 0; j < 3; ++j) {
        row.ncl[j] =
            static_cast<int>(printed.cell(TableQuantity::Ncl, direction, tolerance, j));
        row.tcd_mm[j] = printed.cell(TableQuantity::Tcd, direction, tolerance, j);
    }
    return row;
}

void add_reading(CsvTable& table, const std::string& label, const Decoding& reading)
{
    const auto [a, b, c] = reading.passes;
    CsvCell forward;
    if (reading.points_forward)
        forward = std::int64_t{*reading.points_forward};
    table.add_row({label + ": " + std::to_string(reading.points_a_pair) + " a pair",
                   {},
                   {},
                   std::int64_t{reading.points_a_pair},
                   forward,
                   std::int64_t{a},
                   std::int64_t{b},
                   std::int64_t{c},
                   reading.chord_mm,
                   reading.link_mm,
                   reading.residual_mm});
}

void add_count(CsvTable& table, const std::string& label, std::int64_t readings,
               std::int64_t tried)
{
    table.add_row({label, readings, tried, {}, {}, {}, {}, {}, {}, {}, {}});
}

Readings add_readings(CsvTable& table, const std::string& label, const CostRow& row,
                      const Interval& chord_mm, double tolerance_mm)
{
    Readings readings = decodings(row, tolerance_mm, chord_mm);
    add_count(table, label, static_cast<std::int64_t>(readings.size()), 1);
    for (const Decoding& reading : readings)
        add_reading(table, label, reading);
    return readings;
}

}  // namespace

CsvTable decoding_csv(const EconomyTables& printed, const DecodingRules& rules,
                      const NullTestPlan& null)
{
    CsvTable table{{"row", "readings", "tried", "points_a_pair", "points_forward",
                    "passes_d10", "passes_d15", "passes_d20", "chord_mm", "link_mm",
                    "residual_mm"}};
    std::array<std::array<Readings, 3>, 2> readings;
    for (const Parameter direction : table_directions)
        for (int i = 0; i < 3; ++i)
            readings[direction == Parameter::U ? 0 : 1][i] = add_readings(
                table, table_row_label("print", table_tolerances_mm[i], direction),
                printed_row(printed, direction, i), chord_bounds(direction, rules),
                rules.tolerance_mm);

    constexpr int middle = 1;  // delta = 0.5 mm
    const Interval bounds = chord_bounds(Parameter::V, rules);
    CostRow edited = printed_row(printed, Parameter::V, middle);
    edited.ncl[0] = 1008;
    std::array<Readings, 3> with_edit = readings[1];
    with_edit[middle] =
        add_readings(table, "1008 for 1009 d=0.5 v", edited, bounds, rules.tolerance_mm);
    CostRow caption = printed_row(printed, Parameter::V, middle);
    caption.ncl[1] = 828;
    add_readings(table, "828 for 820 d=0.5 v", caption, bounds,
                 *std::ranges::max_element(null.tolerances_mm));

    const double spread = rules.chord_spread;
    add_count(table, "one L in all rows u", one_chord_triples(readings[0], spread), 1);
    add_count(table, "one L in all rows v", one_chord_triples(readings[1], spread), 1);
    add_count(table, "one L in all rows v with 1008",
              one_chord_triples(with_edit, spread), 1);

    for (const double tolerance : null.tolerances_mm) {
        DecodingRules null_rules = rules;
        null_rules.tolerance_mm = tolerance;
        const NullTest test = null_test(printed, null_rules, null.triples, null.seed);
        const std::string within = " within " + to_text(tolerance) + " mm";
        add_count(table, "null test rows" + within, test.rows_read, test.rows);
        add_count(table, "null test triples" + within, test.triples_read, test.triples);
    }
    return table;
}

}  // namespace endmill
