// SPDX-License-Identifier: GPL-3.0-or-later
// The paths of Kim & Choi and verified ones over all surfaces, judged by what their straight
// motions leave.
//
//   verification-paths-judged OUTPUT_FOLDER
//
// Deterministic, about 30 s on two cores. Columns: README.md beside this.

#include "endmill/core/numbers.h"
#include "endmill/planning/plan_defaults.h"
#include "support/experiment.h"
#include "support/judged_path.h"

using namespace endmill;

namespace {

std::int64_t count(std::size_t number)
{
    return static_cast<std::int64_t>(number);
}

void add_path(CsvTable& result, const std::string& name, const Surface& surface,
              const PlanToJudge& plan)
{
    const double diameter = 2 * plan.ball.radius();
    const std::string direction = plan.direction == Parameter::U ? "u" : "v";
    const std::string mode = plan.is_verified ? "verified" : "paper";
    const JudgedPath judged = judged_path(surface, plan);
    const Deviation& left = judged.left;
    result.add_row({name + " D=" + to_text(diameter) + " " + direction + " " + mode,
                    name,
                    diameter,
                    plan.tolerance,
                    direction,
                    mode,
                    count(judged.economy.passes),
                    count(judged.economy.ncl),
                    judged.economy.cut.contact_mm + judged.economy.link.contact_mm,
                    count(judged.lifted_links),
                    count(judged.uncovered),
                    judged.chord.greatest_mm,
                    judged.motion.gouge.greatest_mm,
                    judged.motion.left.greatest_mm,
                    left.max_gouge_mm,
                    left.gouge_bound_mm,
                    left.gouge_area_mm2,
                    left.max_scallop_mm,
                    left.scallop_bound_mm,
                    left.p99_scallop_mm,
                    left.mean_scallop_mm,
                    left.uncut_area_mm2,
                    std::string{verdict_name(judged.verdict)},
                    std::string{keeps_name(judged.keeps)}});
}

void add_surface(CsvTable& result, const std::string& name, double diameter)
{
    const Surface surface = dataset_surface(name);
    const BallCutter ball{diameter / 2};
    for (const Parameter direction : {Parameter::U, Parameter::V})
        for (const bool is_verified : {false, true})
            add_path(result, name, surface,
                     {ball, default_tolerance(ball), direction, is_verified});
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "verification/paths-judged", [](Experiment& run) {
        CsvTable result{{"row",
                         "surface",
                         "diameter_mm",
                         "tolerance_mm",
                         "direction",
                         "mode",
                         "passes",
                         "ncl",
                         "tcd_mm",
                         "lifted_links",
                         "uncovered",
                         "max_chord_error_mm",
                         "max_motion_gouge_mm",
                         "max_motion_left_mm",
                         "max_gouge_mm",
                         "gouge_bound_mm",
                         "gouge_area_mm2",
                         "max_scallop_mm",
                         "scallop_bound_mm",
                         "p99_scallop_mm",
                         "mean_scallop_mm",
                         "uncut_area_mm2",
                         "verdict",
                         "holds"}};
        for (const std::string& name : run.texts("surfaces"))
            add_surface(result, name, run.number("diameter_mm"));
        for (const std::string& name : run.texts("narrow_surfaces"))
            add_surface(result, name, run.number("narrow_diameter_mm"));
        run.write_result(result);
    });
}
