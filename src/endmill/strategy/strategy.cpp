// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/strategy.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/drop_cutter/clearance.h"
#include "endmill/strategy/detail/dropped_path.h"
#include "endmill/strategy/detail/lay_by_strategy.h"
#include "endmill/strategy/detail/strategy_comparison.h"
#include "endmill/verification/verification.h"

namespace endmill {
namespace {

// Memory of a sample with its triangles and the coverage by several starts at once, bytes.
constexpr double bytes_per_sample = 1200;
constexpr double bytes_per_gib = 1024.0 * 1024 * 1024;

// Share of the scallop height by which a path of dropped passes is made again, and trials at
// most.
constexpr double dropped_share = 0.8;
constexpr int most_dropped_trials = 4;

// A path that leaves more than the scallop height by at most a little, a share of it, is laid
// again, so often at most. Each time the height is lower by a multiple of what is left beyond,
// and by at least a share of the height, but never below another share.
constexpr double little_beyond = 0.3;
constexpr int most_laid_again = 3;
constexpr double lowered_by = 1.5;
constexpr double least_lowered_share = 0.002;
constexpr double least_height_share = 0.5;

void require_sound(double radius, const StrategyOptions& options)
{
    require(0 < options.inner_tolerance && options.inner_tolerance < radius,
            "plan_by_strategy: need 0 < inner tolerance < cutter radius");
    require(0 < options.scallop_height && options.scallop_height < radius,
            "plan_by_strategy: need 0 < scallop height < cutter radius");
    require(
        !options.protected_part || options.protected_part->cutter().radius() == radius,
        "plan_by_strategy: the protected part is for another ball");
}

// The cost of a path whose contacts are not known.
PathEconomy economy_of_tips(const ToolPath& path)
{
    PathEconomy economy{0, 0, {0, 0}, {0, 0}};
    const PathPoint* previous = nullptr;
    for (const PathPoint& point : path.points) {
        if (!previous || point.pass != previous->pass)
            ++economy.passes;
        if (point.move != Move::Rapid && point.move != Move::Retract)
            ++economy.ncl;
        if (previous && (point.move == Move::Cut || point.move == Move::Link))
            (point.move == Move::Cut ? economy.cut : economy.link).tip_mm +=
                (point.location.tip - previous->location.tip).norm();
        previous = &point;
    }
    return economy;
}

StrategyPlan judged(Strategy strategy, CoveringPath covering, const Part& part,
                    const Cutter& cutter, const StrategyOptions& options)
{
    const DeviationLimits limits{options.inner_tolerance, options.scallop_height};
    PathDeviationOptions judgement{limits};
    if (!cutter.is_ball())
        judgement.proof = LimitProof::GougeProved;  // by the drop cutter
    judgement.progress = options.progress;
    const double near = reached_share * limits.scallop;
    const ProtectedPart* const guard = options.protected_part.get();
    std::optional<DropCutter> drop;
    if (const auto* mesh = std::get_if<TriangleMesh>(&part))
        drop.emplace(*mesh, cutter);
    if (drop || guard)
        judgement.is_accessible = [&](const PartRay& ray) {
            const CutterContact place{ray.point, ray.normal};
            return (!drop || is_accessible(*drop, place, near)) &&
                   (!guard || guard->is_accessible(place, near));
        };
    Deviation deviation = deviation_of_path(part, covering.path, cutter, judgement);
    if (follows_parameters(strategy) || !cutter.is_ball())
        covering.uncovered_mm2 = deviation.uncut_area_mm2;
    const PathEconomy economy =
        cutter.is_ball() ? path_economy(covering.path) : economy_of_tips(covering.path);
    StrategyPlan plan{strategy, std::move(covering), economy, std::move(deviation),
                      Verdict::Clean};
    plan.verdict = verdict(plan.deviation, limits);
    if (guard) {
        plan.of_protected = guard->deviation(plan.covering.path);
        plan.verdict = guard->verdict(*plan.of_protected, plan.verdict);
    }
    return plan;
}

// What is wrong with a path, the worst first: whether it gouges, the gouged and the uncut
// area in mm^2. What is uncut can be cut later.
std::tuple<bool, double, double> faults_of(const StrategyPlan& plan)
{
    double gouged = plan.deviation.gouge_area_mm2;
    if (plan.of_protected)
        gouged += plan.of_protected->gouge_area_mm2;
    return {plan.verdict == Verdict::Gouged, gouged, plan.deviation.uncut_area_mm2};
}

// The plan; if it leaves a little more than the scallop height, laid again for a lower one.
// Places are found covered on samples, and the surface between them may differ.
StrategyPlan laid_again_if_uncut(StrategyPlan plan, const Part& part,
                                 const BallCutter& cutter, const StrategyOptions& options)
{
    const double height = options.scallop_height;
    StrategyOptions silent = options;
    silent.progress = {};
    silent.direction = plan.covering.direction;
    StrategyOptions lowered = silent;
    double beyond = plan.deviation.max_scallop_mm - height;
    const bool is_a_little = plan.verdict != Verdict::Gouged &&
                             beyond + plan.deviation.scallop_bound_mm > 0 &&
                             beyond <= little_beyond * height;
    for (int trial = 0; is_a_little && !plan.is_good() && trial < most_laid_again;
         ++trial) {
        lowered.scallop_height -=
            std::max(lowered_by * beyond, least_lowered_share * height);
        if (lowered.scallop_height < least_height_share * height)
            break;
        try {
            StrategyPlan again =
                judged(plan.strategy, covering_by(plan.strategy, part, cutter, lowered),
                       part, Cutter::ball(cutter.radius()), silent);
            again.covering.compared = plan.covering.compared;
            beyond = again.deviation.max_scallop_mm - height;
            // The planner looked for places that keep more than the lower height.
            if (again.verdict == Verdict::Clean) {
                again.covering.uncovered.clear();
                again.covering.uncovered_mm2 = 0;
            }
            if (again.is_good() || faults_of(again) < faults_of(plan))
                plan = std::move(again);
        } catch (const LimitError&) {
            break;  // a lower height needs more samples
        } catch (const GeometryError&) {
            break;  // that path enters a protected part
        }
    }
    return plan;
}

}  // namespace

std::size_t most_part_samples(double memory_gib)
{
    return static_cast<std::size_t>(
        std::clamp(memory_gib * bytes_per_gib / bytes_per_sample, 1.0, 1e9));
}

StrategyPlan plan_by_strategy(Strategy strategy, const Part& part,
                              const BallCutter& cutter, const StrategyOptions& options)
{
    require_sound(cutter.radius(), options);
    CoveringPath covering =
        covering_by(strategy, part, cutter, with_progress(options, 0, made_share));
    return laid_again_if_uncut(
        judged(strategy, std::move(covering), part, Cutter::ball(cutter.radius()),
               with_progress(options, made_share, 1)),
        part, cutter, options);
}

CoveringPath covering_by_strategy(Strategy strategy, const Part& part,
                                  const BallCutter& cutter,
                                  const StrategyOptions& options)
{
    require_sound(cutter.radius(), options);
    return covering_by(strategy, part, cutter, options);
}

StrategyPlan plan_by_strategy(Strategy strategy, const Part& part, const Cutter& cutter,
                              const StrategyOptions& options)
{
    if (cutter.is_ball())
        return plan_by_strategy(strategy, part, BallCutter{cutter.radius()}, options);
    require_sound(cutter.radius(), options);
    if (strategy != Strategy::Planar)
        throw GeometryError{std::string{strategy_name(strategy)} +
                            " plans for ball-end mills only; planar plans for others"};
    require(!options.protected_part,
            "plan_by_strategy: only a ball keeps off a protected part");
    require_upright(options);
    // Planes are placed by samples. Where the judge finds more between them, the planes are
    // laid for a smaller height.
    StrategyOptions aimed = with_progress(options, 0, made_share);
    for (int trial = 1;; ++trial) {
        StrategyPlan plan = judged(strategy, dropped_path(part, cutter, aimed), part,
                                   cutter, with_progress(options, made_share, 1));
        if (plan.is_good() || trial == most_dropped_trials)
            return plan;
        aimed.scallop_height *= dropped_share;
        aimed.direction = plan.covering.direction;
    }
}

BestPlan plan_by_best_strategy(const Part& part, const BallCutter& cutter,
                               const StrategyOptions& options)
{
    require_sound(cutter.radius(), options);
    StrategyComparison comparison{part, cutter, options};
    comparison.run();
    const auto travel_of = [&](const StrategyPlan& plan) {
        return counted_travel(plan.economy, options.distance, CountedMoves::Cuts);
    };
    std::optional<StrategyPlan> best;
    const auto judge = [&](Candidate& candidate) {
        StrategyPlan plan = laid_again_if_uncut(
            judged(candidate.strategy, std::move(candidate.covering), part,
                   Cutter::ball(cutter.radius()), with_progress(options, made_share, 1)),
            part, cutter, options);
        comparison.tried(plan.strategy).travel_mm = travel_of(plan);
        const bool is_better =
            !best || (plan.is_good() != best->is_good() ? plan.is_good()
                      : plan.is_good() ? travel_of(plan) < travel_of(*best)
                                       : faults_of(plan) < faults_of(*best));
        if (is_better)
            best = std::move(plan);
    };
    for (Candidate& candidate : comparison.candidates())
        if (!best || !best->is_good() || candidate.travel < travel_of(*best))
            judge(candidate);
    while (!best->is_good()) {
        std::optional<Candidate> candidate = comparison.next();
        if (!candidate)
            break;
        judge(*candidate);
    }
    return {std::move(*best), std::move(comparison.tried())};
}

}  // namespace endmill
