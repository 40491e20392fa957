// SPDX-License-Identifier: GPL-3.0-or-later
// Effect of each choice that the paper leaves open: each is changed alone, against the
// defaults, over the nine cells of a table and direction.
//
//   economic-cl-data-policies OUTPUT_FOLDER
//
// Deterministic, under 2 s. Columns: README.md beside this.

#include <functional>

#include "endmill/planning/detail/economy_scaling.h"
#include "support/experiment.h"
#include "support/printed_tables.h"

using namespace endmill;

namespace {

struct PolicyChange {
    const char* label;  // an option of `endmill plan`, without its dashes
    std::function<void(TablePolicies&)> apply;
};

const PolicyChange changes[] = {
    {"count-links no", [](TablePolicies& p) { p.counted = CountedMoves::Cuts; }},
    {"distance cl", [](TablePolicies& p) { p.distance = TravelKind::Tip; }},
    {"stop-at-borders yes",
     [](TablePolicies& p) { p.plan.patch_borders = PatchBorders::Stop; }},
    {"end-point free", [](TablePolicies& p) { p.plan.end_point = EndPoint::Free; }},
    {"last-path none", [](TablePolicies& p) { p.plan.last_path = LastPath::None; }},
    {"last-path half", [](TablePolicies& p) { p.plan.last_path = LastPath::Half; }},
    {"governing dense-min",
     [](TablePolicies& p) { p.plan.governing = Governing::DenseMin; }},
    {"governing first", [](TablePolicies& p) { p.plan.governing = Governing::First; }},
    {"governing mean", [](TablePolicies& p) { p.plan.governing = Governing::Mean; }},
    {"governing max", [](TablePolicies& p) { p.plan.governing = Governing::Max; }},
    {"step-curvature normal",
     [](TablePolicies& p) { p.plan.step_curvature = StepCurvature::Normal; }},
    {"march alternate", [](TablePolicies& p) { p.plan.march = March::Alternate; }},
    {"cross-curvature chord",
     [](TablePolicies& p) { p.plan.cross_curvature = CrossCurvature::Chord; }},
    {"scallop = tolerance / 2", [](TablePolicies& p) { p.scallop_per_tolerance = 0.5; }},
};

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "economic-cl-data/policies", [](Experiment& run) {
        const Surface surface = dataset_surface(run.text("surface"));
        const EconomyTables defaults = planned_tables(surface);
        CsvTable result{
            {"row", "ncl_u_percent", "ncl_v_percent", "tcd_u_percent", "tcd_v_percent"}};
        for (const PolicyChange& change : changes) {
            TablePolicies policies;
            change.apply(policies);
            const EconomyTables changed = planned_tables(surface, policies);
            std::vector<CsvCell> cells{change.label};
            for (const TableQuantity quantity : table_quantities)
                for (const Parameter direction : table_directions)
                    cells.emplace_back(
                        100 * mean_change(defaults, changed, quantity, direction));
            result.add_row(cells);
        }
        run.write_result(result);
    });
}
