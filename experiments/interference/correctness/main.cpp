// SPDX-License-Identifier: GPL-3.0-or-later
// Number of curves that each trimming method gets wrong, judged by the segments of the
// curves.
//
//   interference-correctness OUTPUT_FOLDER
//
// Deterministic, under 40 s. Columns: README.md beside this.

#include "endmill/core/text.h"
#include "interference/correctness/family_table.h"
#include "support/trimming_families.h"

using namespace endmill;

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
