// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/lay_by_strategy.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/tolerance.h"
#include "endmill/planning/verified_plan.h"
#include "endmill/strategy/detail/field.h"

namespace endmill {
namespace {

using Surfaces = std::vector<Surface>;

// Shares of the scallop height for passes along parameter lines: between passes, and along
// a pass.
constexpr double between_share = 0.98;
constexpr double along_share = 0.02;

// Share of the work until passes are laid; they are then made a path.
constexpr double laid_share = 0.8;

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

Parameter parameter_of(Strategy strategy)
{
    return strategy == Strategy::IsoU ? Parameter::U : Parameter::V;
}

// The path, if it does not enter the protected part.
CoveringPath clear_of_protected(CoveringPath covering, const StrategyOptions& options)
{
    if (options.protected_part)
        options.protected_part->require_clear(covering.path);
    return covering;
}

}  // namespace

StrategyOptions with_progress(const StrategyOptions& options, double from, double to)
{
    StrategyOptions result = options;
    if (options.progress)
        result.progress = [whole = options.progress, from, to](double share) {
            whole(std::lerp(from, to, share));
        };
    return result;
}

bool follows_parameters(Strategy strategy)
{
    return strategy == Strategy::IsoU || strategy == Strategy::IsoV;
}

void require_upright(const StrategyOptions& options)
{
    if ((options.link.axis - Vec3::UnitZ()).norm() > unit_vector_rounding)
        throw GeometryError{"planar, iso-scallop and field plan along the axis +z only"};
}

CoveredPart covered_part(const Part& part, const BallCutter& cutter,
                         const StrategyOptions& options)
{
    require_upright(options);
    return {part,
            cutter,
            {options.inner_tolerance, options.scallop_height},
            options.protected_part};
}

Trials trials_of(Strategy strategy, const Part& part, const CoveredPart& covered,
                 const StrategyOptions& options)
{
    Trials trials;
    if (strategy == Strategy::Planar) {
        trials.directions = planar_directions(covered, covered.cutter(), options,
                                              parameter_directions(part));
        trials.travel = trials.directions->travel;
    } else if (strategy == Strategy::IsoScallop) {
        trials.starts = scallop_starts(covered, covered.cutter(), options);
        trials.travel = trials.starts->travel;
    }
    return trials;
}

CoveringPath covering_after(const Trials& trials, const CoveredPart& covered,
                            const StrategyOptions& options)
{
    const BallCutter& cutter = covered.cutter();
    StrategyOptions laying = with_progress(options, 0, laid_share);
    StrategyOptions making = with_progress(options, laid_share, 1);
    for (StrategyOptions* own : {&laying, &making})
        own->scallop_height = covered.aimed_height(options.scallop_height);
    if (trials.directions) {
        PlanarPasses planar =
            planar_passes(covered, cutter, laying, trials.directions->best);
        CoveringPath path =
            covering_path(std::move(planar.laid), covered, cutter, making);
        path.direction = planar.direction;
        path.compared = trials.directions->compared;
        return clear_of_protected(std::move(path), options);
    }
    LaidPasses laid = trials.starts
                          ? iso_scallop_passes(covered, cutter, laying, *trials.starts)
                          : field_passes(covered, cutter, laying);
    return clear_of_protected(covering_path(std::move(laid), covered, cutter, making),
                              options);
}

CoveringPath covering_by(Strategy strategy, const Part& part, const BallCutter& cutter,
                         const StrategyOptions& options)
{
    if (follows_parameters(strategy)) {
        const auto* surfaces = std::get_if<Surfaces>(&part);
        if (!surfaces)
            throw GeometryError{std::string{strategy_name(strategy)} +
                                " follows parameter lines, which a mesh does not have"};
        if (options.protected_part)
            require_upright(options);
        return clear_of_protected(
            along_parameter(parameter_of(strategy), *surfaces, cutter, options), options);
    }
    const CoveredPart covered = covered_part(part, cutter, options);
    return covering_after(trials_of(strategy, part, covered, options), covered, options);
}

}  // namespace endmill
