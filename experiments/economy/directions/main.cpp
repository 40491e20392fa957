// SPDX-License-Identifier: GPL-3.0-or-later
// Length of the cuts against the direction of the passes, by contacts and by tips, and what
// a choice between u and v alone costs.
//
//   economy-directions OUTPUT_FOLDER
//
// Deterministic. Columns: README.md beside this.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "endmill/planning/planner_options.h"
#include "endmill/strategy/strategy.h"
#include "support/experiment.h"

using namespace endmill;

namespace {

struct Distance {
    const char* name;
    TravelKind kind;
};

constexpr std::array distances{Distance{"contact", TravelKind::Contact},
                               Distance{"cl", TravelKind::Tip}};

double cut_mm(const StrategyPlan& plan, TravelKind distance)
{
    return distance == TravelKind::Contact ? plan.economy.cut.contact_mm
                                           : plan.economy.cut.tip_mm;
}

// The parameter whose passes are shorter, if they differ by more than rounding.
std::string shorter_parameter(double u, double v)
{
    constexpr double rounding = 1e-9;
    if (std::abs(u - v) <= rounding * v)
        return "both";
    return u < v ? "u" : "v";
}

double percent_more(double length, double than)
{
    return 100 * (length / than - 1);
}

void add_angles(CsvTable& angles, const std::string& surface, const char* distance,
                const std::vector<ComparedDirection>& compared)
{
    for (const ComparedDirection& one : compared)
        angles.add_row({surface, distance, one.direction.degrees(),
                        one.cut_contact_mm.value(), one.cut_tip_mm,
                        static_cast<std::int64_t>(one.passes)});
}

void add_surface(CsvTable& result, CsvTable& angles, const std::string& name,
                 const BallCutter& ball, StrategyOptions options)
{
    const std::vector<Surface> part{dataset_surface(name)};
    options.link.safe_height = default_safe_height(part, options.link.axis);
    const StrategyPlan along_u = plan_by_strategy(Strategy::IsoU, part, ball, options);
    const StrategyPlan along_v = plan_by_strategy(Strategy::IsoV, part, ball, options);
    for (const Distance& distance : distances) {
        options.distance = distance.kind;
        const StrategyPlan planar =
            plan_by_strategy(Strategy::Planar, part, ball, options);
        const StrategyPlan iso_scallop =
            plan_by_strategy(Strategy::IsoScallop, part, ball, options);
        add_angles(angles, name, distance.name, planar.covering.compared);
        const double u = cut_mm(along_u, distance.kind);
        const double v = cut_mm(along_v, distance.kind);
        const double planes = cut_mm(planar, distance.kind);
        const double scallops = cut_mm(iso_scallop, distance.kind);
        const double shorter = std::min(u, v);
        const bool all_clean = along_u.is_good() && along_v.is_good() &&
                               planar.is_good() && iso_scallop.is_good();
        result.add_row({name + " " + distance.name, name, distance.name, u, v, planes,
                        planar.covering.direction.value().degrees(), scallops,
                        shorter_parameter(u, v), percent_more(std::max(u, v), shorter),
                        percent_more(shorter, std::min({shorter, planes, scallops})),
                        std::string{all_clean ? "yes" : "no"}});
    }
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "economy/directions", [](Experiment& run) {
        const BallCutter ball{run.number("diameter_mm") / 2};
        StrategyOptions options;
        options.scallop_height = run.number("scallop_mm");
        options.inner_tolerance = run.number("inner_tolerance_mm");
        CsvTable angles{{"surface", "distance", "angle_deg", "cut_contact_mm",
                         "cut_tip_mm", "passes"}};
        CsvTable result{{"row", "surface", "distance", "iso_u_mm", "iso_v_mm",
                         "planar_mm", "direction_deg", "iso_scallop_mm",
                         "shorter_parameter", "other_parameter_percent",
                         "parameters_only_percent", "all_clean"}};
        for (const std::string& name : run.texts("surfaces"))
            add_surface(result, angles, name, ball, options);
        run.write("angles.csv", angles.text());
        run.write_result(result);
    });
}
