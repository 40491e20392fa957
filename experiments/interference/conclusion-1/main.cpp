// SPDX-License-Identifier: GPL-3.0-or-later
// Conclusion 1 of Jang, Kim and Jeong: the offset of every parametric surface by its
// normals gives data for machining. All surfaces of this project with the three cutters.
//
//   interference-conclusion-1 OUTPUT_FOLDER
//
// Deterministic, under 60 s. Columns and verdicts: README.md beside this.

#include <algorithm>

#include "interference/conclusion-1/offset_data.h"
#include "support/experiment.h"
#include "support/named_cells.h"

using namespace endmill;

namespace {

CsvCell cell(std::ptrdiff_t count)
{
    return static_cast<std::int64_t>(count);
}

void add_case(CsvTable& result, const OffsetCase& one)
{
    NamedCells cells{
        {"cases", cell(1)},
        {"not_made", cell(one.data ? 0 : 1)},
        {"not_usable", cell(one.is_usable() ? 0 : 1)},
        {"not_usable_with_envelope", cell(one.is_usable_with_envelope() ? 0 : 1)},
        {"contacts_without_normal", cell(one.contacts_without_normal)}};
    if (one.data) {
        cells.emplace_back("gouge_mm", one.data->gouge_mm);
        cells.emplace_back("gouge_with_envelope_mm", one.data->gouge_with_envelope_mm);
    }
    add_named(result, one.surface + ", " + one.cutter, cells);
}

// The sums over the cases for which `test` holds.
template <typename Test>
void add_sum(CsvTable& result, const std::string& name,
             const std::vector<OffsetCase>& cases, const Test& test)
{
    std::ptrdiff_t count = 0;
    std::ptrdiff_t not_made = 0;
    std::ptrdiff_t not_usable = 0;
    std::ptrdiff_t with_envelope = 0;
    std::ptrdiff_t without_normal = 0;
    for (const OffsetCase& one : cases)
        if (test(one)) {
            ++count;
            not_made += one.data ? 0 : 1;
            not_usable += one.is_usable() ? 0 : 1;
            with_envelope += one.is_usable_with_envelope() ? 0 : 1;
            without_normal += one.contacts_without_normal;
        }
    add_named(result, name,
              {{"cases", cell(count)},
               {"not_made", cell(not_made)},
               {"not_usable", cell(not_usable)},
               {"not_usable_with_envelope", cell(with_envelope)},
               {"contacts_without_normal", cell(without_normal)}});
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "interference/conclusion-1", [](Experiment& run) {
        CsvTable result{{"row", "cases", "not_made", "not_usable",
                         "not_usable_with_envelope", "contacts_without_normal",
                         "gouge_mm", "gouge_with_envelope_mm"}};
        const std::vector<OffsetCase> cases = offset_cases(run);
        const auto facing_up = run.texts("bezier_and_b_spline_facing_up");
        for (const std::string& cutter : run.texts("cutters"))
            add_sum(result, "all surfaces, " + cutter, cases,
                    [&](const OffsetCase& one) { return one.cutter == cutter; });
        add_sum(result, "all surfaces and cutters", cases,
                [](const OffsetCase&) { return true; });
        add_sum(result, "Bezier and B-spline surfaces that face up", cases,
                [&](const OffsetCase& one) {
                    return std::ranges::find(facing_up, one.surface) != facing_up.end();
                });
        for (const OffsetCase& one : cases)
            add_case(result, one);
        run.write_result(result);
    });
}
