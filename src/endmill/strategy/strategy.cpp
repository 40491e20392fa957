// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/strategy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <iomanip>
#include <limits>
#include <memory>
#include <sstream>
#include <tuple>
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

// A path that leaves more than the scallop height by at most a little, a share of it, is laid
// again, so often at most. Each time the height is lower by a multiple of what is left beyond,
// and by at least a share of the height, but never below another share.
constexpr double little_beyond = 0.3;
constexpr int most_laid_again = 3;
constexpr double lowered_by = 1.5;
constexpr double least_lowered_share = 0.002;
constexpr double least_height_share = 0.5;

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
    require(
        !options.protected_part || options.protected_part->cutter().radius() == radius,
        "plan_by_strategy: the protected part is for another ball");
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

void require_upright(const StrategyOptions& options)
{
    if ((options.link.axis - Vec3::UnitZ()).norm() > unit_vector_rounding)
        throw GeometryError{"planar, iso-scallop and field plan along the axis +z only"};
}

Parameter parameter_of(Strategy strategy)
{
    return strategy == Strategy::IsoU ? Parameter::U : Parameter::V;
}

// The part for strategies that plan on its samples.
CoveredPart covered_part(const Part& part, const BallCutter& cutter,
                         const StrategyOptions& options)
{
    require_upright(options);
    return {part,
            cutter,
            {options.inner_tolerance, options.scallop_height},
            options.protected_part};
}

// What a strategy finds out by trials on few samples before it lays passes.
struct Trials {
    std::optional<PlanarDirections> directions = {};  // of Strategy::Planar
    std::optional<ScallopStarts> starts = {};         // of Strategy::IsoScallop
    std::optional<double> travel = {};                // of the cuts, mm; an estimate
};

bool follows_parameters(Strategy strategy)
{
    return strategy == Strategy::IsoU || strategy == Strategy::IsoV;
}

// The trials that Strategy::Planar and IsoScallop cannot do without.
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

// The path, if it does not enter the protected part.
CoveringPath clear_of_protected(CoveringPath covering, const StrategyOptions& options)
{
    if (options.protected_part)
        options.protected_part->require_clear(covering.path);
    return covering;
}

// The path of a strategy that plans on samples.
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
            if (again.is_good() || faults_of(again) < faults_of(plan))
                plan = std::move(again);
        } catch (const LimitError&) {
            break;  // a lower height needs more samples
        }
    }
    return plan;
}

// A path that has not been judged, and the length by which it is compared.
struct Candidate {
    Strategy strategy;
    CoveringPath covering;
    double travel;  // mm
};

// A strategy is not laid if its estimated length exceeds the least one by this factor.
// Estimates differ from lengths by some per cent.
constexpr double worth_laying = 1.08;
// The direction of plane sections is not searched for if their length in few directions exceeds
// the least one by this factor.
constexpr double worth_searching = 1.15;
// The same for passes along parameter lines on a large part.
constexpr double worth_following = 1.25;

// A part is large if it has more squares with the side of a strip's width. On a large part
// one strategy is laid on samples at most, and a still larger one is not sampled where there
// are parameter lines: a steep part of many patches takes about 3 ms of processor time for
// each square.
constexpr double most_squares_compared = 4000;
constexpr double most_squares_sampled = 20'000;
// Passes along parameter lines are estimated for so many squares.
constexpr double squares_for_estimate = 1000;
// A height is doubled for such an estimate, up to this share of the radius.
constexpr double greatest_estimated_share = 0.2;

// Distance of samples that no part exceeds, mm.
constexpr double no_spacing = 1e9;

// Area of a part by the first net of each of its patches, or by its mesh, mm^2.
double area_of(const CoveredPart& part, std::size_t most_samples)
{
    const PartSamples first = part.samples(no_spacing, most_samples);
    double area = 0;
    for (const auto& [a, b, c] : first.triangles())
        area += (first.point(b) - first.point(a))
                    .cross(first.point(c) - first.point(a))
                    .norm() /
                2;
    return area;
}

// Compares strategies by estimates on few samples, and lays the promising ones.
class StrategyComparison {
public:
    StrategyComparison(const Part& part, const BallCutter& cutter,
                       const StrategyOptions& options)
        : part_{part},
          cutter_{cutter},
          options_{options}
    {
        for (const Strategy strategy : every_strategy)
            tried_.push_back({strategy, {}, {}, {}});
    }

    void run()
    {
        attempt(Strategy::Planar, [&] { cover(); });
        for (const Strategy strategy : every_strategy)
            attempt(strategy, [&] { try_one(strategy); });
        attempt(Strategy::Planar, [&] { search_further(); });
        std::stable_sort(estimated_.begin(), estimated_.end(),
                         [](const Estimated& a, const Estimated& b) {
                             return a.travel() < b.travel();
                         });
        // passes along parameter lines are planned last on a large part: the length of
        // another path tells whether they are worth it
        for (const bool follows : {false, true})
            for (Estimated& one : estimated_)
                if (follows_parameters(one.strategy) == follows)
                    attempt(one.strategy, [&] { lay(one); });
        if (candidates_.empty())
            std::rethrow_exception(failure_);
        std::stable_sort(
            candidates_.begin(), candidates_.end(),
            [](const Candidate& a, const Candidate& b) { return a.travel < b.travel; });
    }

    // Lays the most promising of the strategies that have only been estimated; nothing if
    // there is none left.
    std::optional<Candidate> next()
    {
        candidates_.clear();
        for (Estimated& one : estimated_) {
            TriedStrategy& own = tried(one.strategy);
            if (!std::exchange(own.estimated_mm, std::nullopt))
                continue;
            attempt(one.strategy,
                    [&] { lay(one, with_progress(options_, made_share, 1)); });
            if (!candidates_.empty())
                return std::move(candidates_.front());
        }
        return std::nullopt;
    }

    // The paths, the shortest one first.
    std::vector<Candidate>& candidates() { return candidates_; }
    std::vector<TriedStrategy>& tried() { return tried_; }
    TriedStrategy& tried(Strategy strategy)
    {
        return *std::find_if(tried_.begin(), tried_.end(), [&](const TriedStrategy& one) {
            return one.strategy == strategy;
        });
    }

private:
    struct Estimated {
        Strategy strategy;
        Trials trials;
        // of Strategy::Planar, as long as it has only been estimated
        std::unique_ptr<DirectionSearch> search = {};

        double travel() const { return trials.travel.value_or(0); }
    };

    template <typename Step>
    void attempt(Strategy strategy, const Step& step)
    {
        try {
            step();
        } catch (const GeometryError& error) {
            refuse(strategy, error.what());
        } catch (const LimitError& error) {
            refuse(strategy, error.what());
        }
    }

    void refuse(Strategy strategy, std::string message)
    {
        tried(strategy).refusal = std::move(message);
        failure_ = std::current_exception();
    }

    StrategyOptions next_share()
    {
        // two steps for each strategy
        constexpr double share = made_share / (2 * every_strategy.size());
        const double begin = share * static_cast<double>(steps_++);
        return with_progress(options_, begin, begin + share);
    }

    // Prepares the part for strategies that plan on its samples, if it suits them.
    void cover()
    {
        if (covered_)
            return;
        CoveredPart covered = covered_part(part_, cutter_, options_);
        area_ = area_of(covered, options_.most_samples);
        covered_.emplace(std::move(covered));
    }

    // The number of squares of a strip's width on the part; 0 if it suits none of these
    // strategies.
    double squares(double height) const
    {
        const double width = strip_width(cutter_, height);
        return area_ / (width * width);
    }

    bool is_large() const
    {
        return squares(options_.scallop_height) > most_squares_compared;
    }

    void add(Strategy strategy, CoveringPath covering)
    {
        const double travel = counted_travel(path_economy(covering.path),
                                             options_.distance, CountedMoves::Cuts);
        tried(strategy).travel_mm = travel;
        candidates_.push_back({strategy, std::move(covering), travel});
    }

    void try_one(Strategy strategy)
    {
        const StrategyOptions own = next_share();
        if (!follows_parameters(strategy)) {
            cover();
            require_few_squares();
            Estimated estimated{strategy, {}};
            if (strategy == Strategy::Planar && !own.direction) {
                estimated.search = std::make_unique<DirectionSearch>(
                    *covered_, cutter_, own, parameter_directions(part_));
                estimated.trials.travel = estimated.search->coarse_travel();
            } else {
                estimated.trials = trials_of(strategy, part_, *covered_, own);
            }
            if (strategy == Strategy::Field)
                estimated.trials.travel = field_travel(*covered_, cutter_, own);
            estimated_.push_back(std::move(estimated));
        } else if (is_large()) {
            Trials trials;
            trials.travel = estimated_along(strategy, own);
            estimated_.push_back({strategy, std::move(trials)});
        } else {
            add(strategy, covering_by(strategy, part_, cutter_, own));
        }
    }

    // Refuses a part that would need too many samples, if there are parameter lines.
    void require_few_squares() const
    {
        const double needed = squares(options_.scallop_height);
        if (needed <= most_squares_sampled || !std::holds_alternative<Surfaces>(part_))
            return;
        std::ostringstream message;
        message << std::fixed << std::setprecision(0) << "the part has " << needed
                << " squares of a strip's width, and best samples parts of at most "
                << most_squares_sampled
                << ", to save time; name this strategy to plan by it, or allow a larger "
                   "scallop height";
        throw LimitError{message.str()};
    }

    // The length of passes along parameter lines, from that for a greater height.
    double estimated_along(Strategy strategy, StrategyOptions options) const
    {
        while (squares(options.scallop_height) > squares_for_estimate &&
               2 * options.scallop_height < greatest_estimated_share * cutter_.radius())
            options.scallop_height *= 2;
        const CoveringPath path = covering_by(strategy, part_, cutter_, options);
        const double travel =
            counted_travel(path_economy(path.path), options.distance, CountedMoves::Cuts);
        return scaled_travel(travel, cutter_, options.scallop_height,
                             options_.scallop_height);
    }

    // The least length of a path, or estimate for a strategy that has not been refused, mm.
    double least_travel() const
    {
        double least = std::numeric_limits<double>::infinity();
        for (const Candidate& one : candidates_)
            least = std::min(least, one.travel);
        for (const Estimated& one : estimated_)
            if (is_possible(one))
                least = std::min(least, one.trials.travel.value_or(least));
        return least;
    }

    bool is_possible(const Estimated& one) const
    {
        return std::any_of(tried_.begin(), tried_.end(), [&](const TriedStrategy& other) {
            return other.strategy == one.strategy && other.refusal.empty();
        });
    }

    static void search_directions(Estimated& one)
    {
        one.trials.directions = std::exchange(one.search, nullptr)->directions({});
        one.trials.travel = one.trials.directions->travel;
    }

    // Searches for the direction of Strategy::Planar where it may give the shortest path.
    void search_further()
    {
        for (Estimated& one : estimated_)
            if (one.search && one.travel() <= worth_searching * least_travel())
                search_directions(one);
    }

    // Whether a strategy may give the shortest path, by its estimate.
    bool is_promising(const Estimated& one) const
    {
        const double travel = one.travel();
        if (follows_parameters(one.strategy))
            return travel <= worth_following * least_travel();
        return travel <= worth_laying * least_travel() &&
               (candidates_.empty() || !is_large());
    }

    void lay(Estimated& one)
    {
        const StrategyOptions own = next_share();
        if (is_promising(one))
            lay(one, own);
        else
            tried(one.strategy).estimated_mm = one.travel();
    }

    void lay(Estimated& one, const StrategyOptions& options)
    {
        if (one.search)
            search_directions(one);
        if (follows_parameters(one.strategy))
            add(one.strategy, covering_by(one.strategy, part_, cutter_, options));
        else
            add(one.strategy, covering_after(one.trials, *covered_, options));
    }

    const Part& part_;
    BallCutter cutter_;
    const StrategyOptions& options_;
    std::optional<CoveredPart> covered_;
    double area_ = 0;  // mm^2
    std::vector<Estimated> estimated_;
    std::vector<Candidate> candidates_;
    std::vector<TriedStrategy> tried_;
    std::exception_ptr failure_;
    std::size_t steps_ = 0;
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
