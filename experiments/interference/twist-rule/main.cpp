// SPDX-License-Identifier: GPL-3.0-or-later
// The rules by which Jang, Kim and Jeong recognise a twist, on curves that are known to
// cross themselves or not; and method 3 with the two ranges of its search.
//
//   interference-twist-rule OUTPUT_FOLDER
//
// Deterministic, under 5 s. Columns and verdicts: README.md beside this.

#include "endmill/core/text.h"
#include "endmill/files/input_csv.h"
#include "interference/twist-rule/twist_counts.h"
#include "support/experiment.h"
#include "support/named_cells.h"
#include "support/trimming_families.h"

using namespace endmill;

namespace {

CsvCell cell(std::size_t count)
{
    return static_cast<std::int64_t>(count);
}

void add_family(CsvTable& result, const std::string& name,
                const std::vector<TrimmingTrial>& trials)
{
    const TwistCounts counts = twist_counts(trials);
    add_named(result, name,
              {{"curves", cell(trials.size())},
               {"crossing", cell(counts.crossing)},
               {"crossing_without_three_changes", cell(counts.without_three_changes)},
               {"three_runs", cell(counts.three_runs)},
               {"three_runs_without_crossing", cell(counts.three_runs_without_crossing)},
               {"crossing_but_no_line_meets_a", cell(counts.no_line_meets_a)},
               {"wrong_search_to_run_end", cell(counts.wrong_to_run_end)},
               {"wrong_search_to_curve_end", cell(counts.wrong_to_curve_end)}});
}

// The curves of datasets/offset-curves/vectors with the tolerances of planar curves.
std::vector<TrimmingTrial> vector_trials(const std::vector<std::string>& names)
{
    std::vector<TrimmingTrial> trials;
    for (const std::string& name : names)
        for (const SectionCurve& curve :
             read_polylines("datasets/offset-curves/vectors/" + name + ".csv"))
            trials.push_back(planar_trial(curve));
    return trials;
}

// What method 3 as printed deletes from a curve without interference.
void add_good_path(CsvTable& result, const std::string& name, const TrimmingTrial& trial)
{
    constexpr double percent = 100;
    const TwistCounts counts = twist_counts({trial});
    add_named(result, name,
              {{"curves", cell(1)},
               {"crossing", cell(counts.crossing)},
               {"three_runs", cell(counts.three_runs)},
               {"depth_below_envelope_mm", depth_below_envelope(trial.curve)},
               {"path_lost_percent", percent * path_lost_as_printed(trial.curve)}});
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "interference/twist-rule", [](Experiment& run) {
        CsvTable result{{"row", "curves", "crossing", "crossing_without_three_changes",
                         "three_runs", "three_runs_without_crossing",
                         "crossing_but_no_line_meets_a", "wrong_search_to_run_end",
                         "wrong_search_to_curve_end", "depth_below_envelope_mm",
                         "path_lost_percent"}};
        const int points = static_cast<int>(run.number("points"));
        const auto hard = hard_trials(points);
        add_family(result, "hard cases", hard);
        add_family(result, "vectors", vector_trials(run.texts("vectors")));
        add_family(result, "wavy", wavy_trials(points));
        for (const double feed : run.numbers("feeds_deg"))
            add_family(result, "sections at " + to_text(feed) + " deg",
                       section_trials({run.text("surface"),
                                       Cutter::ball(run.number("radius_mm")), feed}));
        for (const std::string& name : run.texts("good_paths"))
            add_good_path(result, name, hard.at(hard_profile_number(name)));
        run.write_result(result);
    });
}
