// SPDX-License-Identifier: GPL-3.0-or-later
// Number of curves that each trimming method gets wrong, judged by the segments of the
// curves.
//
//   interference-correctness OUTPUT_FOLDER
//
// Deterministic, under 30 s. Columns: README.md beside this.

#include <cstdint>

#include "endmill/core/text.h"
#include "interference/correctness/trimming_families.h"
#include "support/experiment.h"

using namespace endmill;

namespace {

CsvCell count_cell(std::size_t count)
{
    return static_cast<std::int64_t>(count);
}

// Adds the counts of a family, and below them the reference counts of
// docs/mathematics/interference.md, section 9.
class FamilyTable {
public:
    explicit FamilyTable(Experiment& run) : run_{run}, table_{columns()} {}

    void add(const std::string& name, std::span<const TrimmingTrial> trials,
             const std::string& stated)
    {
        std::vector<CsvCell> found{name, count_cell(trials.size()),
                                   count_cell(crossing_curves(trials))};
        for (const TriedMethod& method : tried_methods())
            found.push_back(count_cell(wrong_curves(trials, method)));
        table_.add_row(found);
        add_stated(name, stated);
    }

    // The methods as printed, without the sentence that + - + is a twist.
    void add_without_three_runs(const std::string& name,
                                std::span<const TrimmingTrial> trials,
                                const std::string& stated)
    {
        std::vector<CsvCell> found{name, count_cell(trials.size()),
                                   count_cell(crossing_curves(trials))};
        for (TriedMethod method : tried_methods()) {
            method.patterns = FoldPatterns::P4;
            found.push_back(method.detection == FoldDetection::Literal
                                ? count_cell(wrong_curves(trials, method))
                                : CsvCell{});
        }
        table_.add_row(found);
        add_stated(name, stated);
    }

    const CsvTable& table() const { return table_; }

private:
    void add_stated(const std::string& name, const std::string& stated)
    {
        std::vector<CsvCell> specified{name + ", stated"};
        for (const double count : run_.numbers(stated))
            specified.emplace_back(count);
        specified.resize(columns().size());
        table_.add_row(specified);
    }

    static std::vector<std::string> columns()
    {
        std::vector<std::string> names{"row", "curves", "self-crossing"};
        for (const TriedMethod& method : tried_methods())
            names.push_back(method.label);
        return names;
    }

    Experiment& run_;
    CsvTable table_;
};

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "interference/correctness", [](Experiment& run) {
        FamilyTable table{run};
        const int points = static_cast<int>(run.number("points"));
        table.add("hard cases", hard_trials(points), "stated_hard");
        const std::vector<TrimmingTrial> wavy = wavy_trials(points);
        table.add("wavy", wavy, "stated_wavy");
        table.add_without_three_runs("wavy, + - + no twist", wavy,
                                     "stated_wavy_without_three_runs");
        for (const double count : run.numbers("convex_points"))
            table.add("convex, " + to_text(count) + " points",
                      convex_trials(static_cast<int>(count)),
                      "stated_convex_" + to_text(count));
        const double radius = run.number("radius_mm");
        for (const double feed : run.numbers("feeds_deg"))
            for (const double corner : run.numbers("corner_radii_mm")) {
                const std::string key = to_text(feed) + "_" + to_text(corner);
                table.add("sections at " + to_text(feed) + " deg, r = " + to_text(corner),
                          section_trials({run.text("surface"), {radius, corner}, feed}),
                          "stated_sections_" + key);
            }
        run.write_result(table.table());
    });
}
