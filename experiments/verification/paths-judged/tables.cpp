// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/paths-judged/tables.h"

#include <cstdint>
#include <vector>

#include "endmill/core/text.h"
#include "endmill/planning/iso_parametric.h"

namespace endmill {
namespace {

std::int64_t count(std::size_t number)
{
    return static_cast<std::int64_t>(number);
}

std::vector<CsvCell> planned_cells(const std::string& name, const PlanToJudge& plan)
{
    const double diameter = 2 * plan.ball.radius();
    const std::string direction = plan.direction == Parameter::U ? "u" : "v";
    const std::string mode = plan.planner == Planner::Verified ? "verified" : "paper";
    return {name + " D=" + to_text(diameter) + " " + direction + " " + mode,
            name,
            diameter,
            plan.tolerance,
            direction,
            mode};
}

std::vector<CsvCell> measured_cells(const JudgedPath& judged)
{
    const PathEconomy& economy = judged.economy;
    const Deviation& left = judged.left;
    return {count(economy.passes),
            count(economy.ncl),
            economy.cut.contact_mm + economy.link.contact_mm,
            economy.cut.tip_mm + economy.link.tip_mm,
            count(judged.lifted_links),
            count(judged.uncovered),
            judged.chord.greatest_mm,
            judged.motion.gouge.greatest_mm,
            judged.motion.remaining.greatest_mm,
            left.max_gouge_mm,
            left.gouge_bound_mm,
            left.gouge_area_mm2,
            left.max_scallop_mm,
            left.scallop_bound_mm,
            left.p99_scallop_mm,
            left.mean_scallop_mm,
            left.uncut_area_mm2,
            std::string{verdict_name(judged.verdict)},
            std::string{keeps_name(judged.keeps)}};
}

}  // namespace

CsvTable judged_table()
{
    return CsvTable{{"row",
                     "surface",
                     "diameter_mm",
                     "tolerance_mm",
                     "direction",
                     "mode",
                     "passes",
                     "ncl",
                     "tcd_mm",
                     "tcd_cl_mm",
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
}

void add_judged_paths(CsvTable& table, const std::string& name, const Surface& surface,
                      const BallCutter& ball)
{
    for (const Parameter direction : {Parameter::U, Parameter::V})
        for (const Planner planner : {Planner::Paper, Planner::Verified}) {
            const PlanToJudge plan{ball, default_tolerance(ball), direction, planner};
            std::vector<CsvCell> cells = planned_cells(name, plan);
            for (CsvCell& cell : measured_cells(judged_path(surface, plan)))
                cells.push_back(std::move(cell));
            table.add_row(cells);
        }
}

}  // namespace endmill
