// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/weaknesses/tables.h"

#include <algorithm>

#include "endmill/planning/detail/continuum_travel.h"
#include "endmill/planning/detail/scallop_between.h"
#include "endmill/planning/detail/step_study.h"
#include "support/median.h"

namespace endmill {
namespace {

// Number of pieces of a step that approximates rolling along it. The chord error of a piece is
// 1 / 32^2 of that of the step: below a thousandth of the scallop height, except on the few steps
// with gross errors.
constexpr int rolled_pieces = 32;

// Limit of the area column, as a share of the scallop height. The 2 % exclude rounding.
constexpr double above_scallop = 1.02;

double percent_above(const std::vector<double>& values, double limit)
{
    const auto count =
        std::ranges::count_if(values, [limit](double value) { return value > limit; });
    return 100 * double(count) / double(values.size());
}

// Share in percent of the area of the first-level cells whose remaining material is higher than
// `height` mm.
double area_above_percent(const Deviation& left, double height)
{
    double above = 0;
    for (std::size_t cell = 0; cell < left.left.size(); ++cell)
        if (left.left[cell] > height)
            above += left.area[cell];
    return 100 * above / left.area_mm2;
}

void add_steps(NamedNumbers& numbers, const std::vector<StepErrors>& steps,
               double tolerance)
{
    std::vector<double> chords;
    std::vector<double> gouges;
    for (const StepErrors& step : steps) {
        chords.push_back(step.chord / tolerance);
        gouges.push_back(step.gouge / tolerance);
    }
    numbers.emplace_back("steps", double(steps.size()));
    numbers.emplace_back("chord > delta, % of steps", percent_above(chords, 1));
    numbers.emplace_back("chord > 1.1 delta, % of steps", percent_above(chords, 1.1));
    numbers.emplace_back("chord > 2 delta, % of steps", percent_above(chords, 2));
    numbers.emplace_back("median chord / delta", median(chords));
    numbers.emplace_back("worst chord / delta", std::ranges::max(chords));
    numbers.emplace_back("gouge > delta, % of steps", percent_above(gouges, 1));
    numbers.emplace_back("worst gouge / delta", std::ranges::max(gouges));
}

void add_scallop(NamedNumbers& numbers, const std::string& how, const Deviation& left,
                 double scallop_height)
{
    numbers.emplace_back(how + ": max scallop / h", left.max_scallop_mm / scallop_height);
    numbers.emplace_back(how + ": p99 scallop / h", left.p99_scallop_mm / scallop_height);
    numbers.emplace_back(how + ": mean scallop / h",
                         left.mean_scallop_mm / scallop_height);
    numbers.emplace_back(how + ": area above 1.02 h, %",
                         area_above_percent(left, above_scallop * scallop_height));
}

// Samples of the integrals along each parameter: with twice as many, the integrals change by less
// than half a percent.
constexpr int continuum_samples = 500;
constexpr int planar_feeds = 36;  // directions of drive planes

// `planned_mm` is the travel of the planned path without links.
void add_continuum(NamedNumbers& numbers, const Surface& surface, const PlanToJudge& plan,
                   double planned_mm)
{
    const ScallopRequest request{plan.ball, plan.tolerance};
    const ContinuumTravel travel =
        continuum_travel(surface, request, plan.direction, continuum_samples);
    const PlanarExtremes planes =
        planar_extremes(surface, request, planar_feeds, continuum_samples);
    numbers.emplace_back("continuum: iso-parametric, mm", travel.iso);
    numbers.emplace_back("continuum: own interval everywhere, mm", travel.local);
    numbers.emplace_back("continuum: best direction everywhere, mm",
                         travel.best_direction);
    numbers.emplace_back("continuum: planes, least, mm", planes.least);
    numbers.emplace_back("continuum: planes, direction of the least, deg",
                         planes.least_at_deg);
    numbers.emplace_back("continuum: planes, most, mm", planes.greatest);
    numbers.emplace_back("continuum: iso-parametric saves, %",
                         100 * (1 - travel.iso / planned_mm));
    numbers.emplace_back("continuum: own interval everywhere saves, %",
                         100 * (1 - travel.local / travel.iso));
    numbers.emplace_back("continuum: best planes save, %",
                         100 * (1 - planes.least / travel.iso));
}

}  // namespace

NamedNumbers weaknesses(const Surface& surface, const PlanToJudge& plan, double rays)
{
    PlanToJudge as_paper = plan;
    as_paper.planner = Planner::Paper;
    PlanToJudge as_verified = plan;
    as_verified.planner = Planner::Verified;
    const PassSettings settings{plan.ball, plan.tolerance, plan.direction};
    const JudgedPath judged = judged_path(surface, as_paper);
    const JudgedPath verified = judged_path(surface, as_verified);
    const ToolPath rolled = rolled_path(surface, judged.path, plan.ball, rolled_pieces);
    const double pitch = pitch_of(surface, rays);

    NamedNumbers numbers;
    add_steps(numbers, step_errors(surface, judged.path, settings), plan.tolerance);
    add_scallop(numbers, "rolled", deviation_of(surface, rolled, plan, pitch),
                plan.tolerance);
    add_scallop(numbers, "straight", deviation_of(surface, judged.path, plan, pitch),
                plan.tolerance);
    const auto points = double(judged.economy.ncl);
    const auto fewest = double(verified_points(surface, judged.path, settings));
    numbers.emplace_back("points", points);
    numbers.emplace_back("points, verified steps on these passes", fewest);
    numbers.emplace_back("points, verified steps save, %", 100 * (1 - fewest / points));
    const auto chords = double(greedy_points(surface, judged.path, settings, {}));
    numbers.emplace_back("points, chords that hold on these passes", chords);
    numbers.emplace_back("points, chords that hold save, %", 100 * (1 - chords / points));
    numbers.emplace_back("points, chords and motions that hold on these passes",
                         double(greedy_points(surface, judged.path, settings,
                                              {LimitedCurves::ContactsAndCentres})));
    numbers.emplace_back(
        "points, the paper's steps, shortened where these do not hold",
        double(greedy_points(surface, judged.path, settings,
                             {LimitedCurves::ContactsAndCentres, LongestStep::Paper})));
    numbers.emplace_back("points, verified plan", double(verified.economy.ncl));
    numbers.emplace_back("passes", double(judged.economy.passes));
    numbers.emplace_back("passes, verified plan", double(verified.economy.passes));
    numbers.emplace_back("travel without links, mm", judged.economy.cut.contact_mm);
    add_continuum(numbers, surface, plan, judged.economy.cut.contact_mm);
    return numbers;
}

}  // namespace endmill
