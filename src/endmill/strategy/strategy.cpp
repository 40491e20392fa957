// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/strategy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/tolerance.h"
#include "endmill/drop_cutter/clearance.h"
#include "endmill/strategy/detail/covering_path.h"
#include "endmill/strategy/detail/dropped_path.h"
#include "endmill/strategy/detail/field.h"
#include "endmill/strategy/detail/iso_scallop.h"
#include "endmill/strategy/detail/planar.h"
#include "endmill/verification/verification.h"

namespace endmill {
namespace {

using Surfaces = std::vector<Surface>;
using Progress = std::function<void(double share)>;

// Memory of a sample with its triangles and the coverage by several starts at once, bytes.
constexpr double bytes_per_sample = 1200;
constexpr double bytes_per_gib = 1024.0 * 1024 * 1024;

// Shares of the scallop height for passes along parameter lines: between passes, and along
// a pass.
constexpr double between_share = 0.98;
constexpr double along_share = 0.02;

// Shares of the work until passes are laid, until they are a path, and until it is judged.
constexpr double laid_share = 0.8;
constexpr double made_share = 0.9;

// Share of the scallop height by which a path of dropped passes is made again, and trials at
// most.
constexpr double dropped_share = 0.8;
constexpr int most_dropped_trials = 4;

// Reports the share of a part of some work as a share of the whole.
Progress part_of(const Progress& whole, double from, double to)
{
    if (!whole)
        return {};
    return [whole, from, to](double share) { whole(std::lerp(from, to, share)); };
}

StrategyOptions with_progress(const StrategyOptions& options, double from, double to)
{
    StrategyOptions result = options;
    result.progress = part_of(options.progress, from, to);
    return result;
}

void require_sound(double radius, const StrategyOptions& options)
{
    require(0 < options.inner_tolerance && options.inner_tolerance < radius,
            "plan_by_strategy: need 0 < inner tolerance < cutter radius");
    require(0 < options.scallop_height && options.scallop_height < radius,
            "plan_by_strategy: need 0 < scallop height < cutter radius");
}

// The number of runs of cuts.
std::size_t runs_of_cuts(const ToolPath& path)
{
    std::size_t runs = 0;
    bool is_cut = false;
    for (const PathPoint& point : path.points) {
        const bool was_cut = std::exchange(is_cut, point.move == Move::Cut);
        runs += is_cut && !was_cut ? 1 : 0;
    }
    return runs;
}

CoveringPath along_parameter(Parameter along, const Surfaces& surfaces,
                             const BallCutter& cutter, const StrategyOptions& options)
{
    VerifiedOptions verified;
    verified.direction = along;
    verified.tolerances = {options.inner_tolerance, along_share * options.scallop_height};
    verified.scallop_height = between_share * options.scallop_height;
    verified.link = options.link;
    verified.most_points = options.most_points;
    verified.progress = options.progress;
    VerifiedPlan plan = plan_verified(surfaces, cutter, verified);
    CoveringPath result;
    result.passes = path_economy(plan.path).passes;
    result.pieces = runs_of_cuts(plan.path);
    result.stray_mm = std::max(options.inner_tolerance, verified.tolerances.outer);
    result.lifted_links = plan.lifted_links;
    result.uncovered = std::move(plan.uncovered);
    result.path = std::move(plan.path);
    return result;
}

void require_upright(Strategy strategy, const StrategyOptions& options)
{
    if ((options.link.axis - Vec3::UnitZ()).norm() > unit_vector_rounding)
        throw GeometryError{std::string{strategy_name(strategy)} +
                            " plans along the axis +z only"};
}

CoveringPath covering_by(Strategy strategy, const Part& part, const BallCutter& cutter,
                         const StrategyOptions& options)
{
    if (strategy == Strategy::IsoU || strategy == Strategy::IsoV) {
        const auto* surfaces = std::get_if<Surfaces>(&part);
        if (!surfaces)
            throw GeometryError{std::string{strategy_name(strategy)} +
                                " follows parameter lines, which a mesh does not have"};
        return along_parameter(strategy == Strategy::IsoU ? Parameter::U : Parameter::V,
                               *surfaces, cutter, options);
    }
    require_upright(strategy, options);
    const CoveredPart covered{
        part, cutter, {options.inner_tolerance, options.scallop_height}};
    if (strategy == Strategy::Planar) {
        PlanarPasses planar =
            planar_passes(covered, cutter, with_progress(options, 0, laid_share),
                          parameter_directions(part));
        CoveringPath path = covering_path(std::move(planar.laid), covered, cutter,
                                          with_progress(options, laid_share, 1));
        path.direction = planar.direction;
        path.compared = std::move(planar.compared);
        return path;
    }
    const StrategyOptions laying = with_progress(options, 0, laid_share);
    LaidPasses laid = strategy == Strategy::Field
                          ? field_passes(covered, cutter, laying)
                          : iso_scallop_passes(covered, cutter, laying);
    return covering_path(std::move(laid), covered, cutter,
                         with_progress(options, laid_share, 1));
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
    std::optional<DropCutter> drop;
    if (const auto* mesh = std::get_if<TriangleMesh>(&part)) {
        drop.emplace(*mesh, cutter);
        judgement.is_accessible = [&](const PartRay& ray) {
            return is_accessible(*drop, {ray.point, ray.normal},
                                 reached_share * limits.scallop);
        };
    }
    Deviation deviation = deviation_of_path(part, covering.path, cutter, judgement);
    if (strategy == Strategy::IsoU || strategy == Strategy::IsoV || !cutter.is_ball())
        covering.uncovered_mm2 = deviation.uncut_area_mm2;
    const PathEconomy economy =
        cutter.is_ball() ? path_economy(covering.path) : economy_of_tips(covering.path);
    const Verdict found = verdict(deviation, limits);
    return {strategy, std::move(covering), economy, std::move(deviation), found};
}

// A path that has not been judged, and the length by which it is compared.
struct Candidate {
    Strategy strategy;
    CoveringPath covering;
    double travel;  // mm
};

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
    return judged(strategy, std::move(covering), part, Cutter::ball(cutter.radius()),
                  with_progress(options, made_share, 1));
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
    require_upright(strategy, options);
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
    std::vector<TriedStrategy> tried;
    std::vector<Candidate> candidates;
    std::exception_ptr failure;
    constexpr double share_of_one = made_share / every_strategy.size();
    for (const Strategy strategy : every_strategy) {
        const double begin = share_of_one * static_cast<double>(tried.size());
        try {
            CoveringPath covering =
                covering_by(strategy, part, cutter,
                            with_progress(options, begin, begin + share_of_one));
            const double travel = counted_travel(path_economy(covering.path),
                                                 options.distance, CountedMoves::Cuts);
            tried.push_back({strategy, travel, {}});
            candidates.push_back({strategy, std::move(covering), travel});
        } catch (const GeometryError& error) {
            tried.push_back({strategy, {}, error.what()});
            failure = std::current_exception();
        } catch (const LimitError& error) {
            tried.push_back({strategy, {}, error.what()});
            failure = std::current_exception();
        }
    }
    if (candidates.empty())
        std::rethrow_exception(failure);
    std::stable_sort(
        candidates.begin(), candidates.end(),
        [](const Candidate& a, const Candidate& b) { return a.travel < b.travel; });
    std::optional<StrategyPlan> shortest;
    for (Candidate& candidate : candidates) {
        StrategyPlan plan =
            judged(candidate.strategy, std::move(candidate.covering), part,
                   Cutter::ball(cutter.radius()), with_progress(options, made_share, 1));
        if (plan.is_good())
            return {std::move(plan), std::move(tried)};
        if (!shortest)
            shortest = std::move(plan);
    }
    return {std::move(*shortest), std::move(tried)};
}

}  // namespace endmill
