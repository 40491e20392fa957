// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/strategy_comparison.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <utility>
#include <variant>

#include "endmill/core/error.h"
#include "endmill/strategy/detail/field.h"

namespace endmill {
namespace {

// A strategy is not laid if its estimated length exceeds the least one by this factor.
// Estimates differ from lengths by some per cent.
constexpr double worth_laying = 1.08;
// The same for passes along parameter lines on a large part.
constexpr double worth_following = 1.25;
// The direction of plane sections is not searched for if their length in few directions exceeds
// the least one by this factor.
constexpr double worth_searching = 1.15;

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
// Such passes are refused on more squares: planning them would take hours.
constexpr double most_squares_followed = 1e9;

// To a whole number of at most nine digits.
std::string rounded(double number)
{
    std::ostringstream text;
    text << std::setprecision(9) << std::round(number);
    return text.str();
}

}  // namespace

StrategyComparison::StrategyComparison(const Part& part, const BallCutter& cutter,
                                       const StrategyOptions& options)
    : part_{part},
      cutter_{cutter},
      options_{options}
{
    for (const Strategy strategy : every_strategy)
        tried_.push_back({strategy, {}, {}, {}});
}

void StrategyComparison::run()
{
    attempt(Strategy::Planar, [&] { cover(); });
    for (const Strategy strategy : every_strategy)
        attempt(strategy, [&] { try_one(strategy); });
    attempt(Strategy::Planar, [&] { search_further(); });
    std::stable_sort(
        estimated_.begin(), estimated_.end(),
        [](const Estimated& a, const Estimated& b) { return a.travel() < b.travel(); });
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

std::optional<Candidate> StrategyComparison::next()
{
    candidates_.clear();
    for (Estimated& one : estimated_) {
        TriedStrategy& own = tried(one.strategy);
        if (!std::exchange(own.estimated_mm, std::nullopt))
            continue;
        attempt(one.strategy, [&] { lay(one, with_progress(options_, made_share, 1)); });
        if (!candidates_.empty())
            return std::move(candidates_.front());
    }
    return std::nullopt;
}

TriedStrategy& StrategyComparison::tried(Strategy strategy)
{
    return *std::find_if(tried_.begin(), tried_.end(), [&](const TriedStrategy& one) {
        return one.strategy == strategy;
    });
}

void StrategyComparison::attempt(Strategy strategy, const std::function<void()>& step)
{
    try {
        step();
    } catch (const GeometryError& error) {
        refuse(strategy, error.what());
    } catch (const LimitError& error) {
        refuse(strategy, error.what());
    }
}

void StrategyComparison::refuse(Strategy strategy, std::string message)
{
    tried(strategy).refusal = std::move(message);
    // Planar plans every kind of part, so that its reason says most.
    if (!failure_ || strategy == Strategy::Planar)
        failure_ = std::current_exception();
}

StrategyOptions StrategyComparison::next_share()
{
    // two steps for each strategy
    constexpr double share = made_share / (2 * every_strategy.size());
    const double begin = share * static_cast<double>(steps_++);
    return with_progress(options_, begin, begin + share);
}

// Prepares the part for strategies that plan on its samples, if it suits them.
void StrategyComparison::cover()
{
    if (covered_)
        return;
    CoveredPart covered = covered_part(part_, cutter_, options_);
    area_ = covered.rough_area(options_.most_samples);
    covered_.emplace(std::move(covered));
}

// The number of squares of a strip's width on the part; 0 if it suits none of these
// strategies.
double StrategyComparison::squares(double height) const
{
    const double width = strip_width(cutter_, height);
    return area_ / (width * width);
}

bool StrategyComparison::is_large() const
{
    return squares(options_.scallop_height) > most_squares_compared;
}

void StrategyComparison::add(Strategy strategy, CoveringPath covering)
{
    const double travel = counted_travel(path_economy(covering.path), options_.distance,
                                         CountedMoves::Cuts);
    tried(strategy).travel_mm = travel;
    candidates_.push_back({strategy, std::move(covering), travel});
}

void StrategyComparison::try_one(Strategy strategy)
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
    } else if (const double needed = squares(options_.scallop_height);
               needed > most_squares_followed) {
        throw LimitError{"the part has " + rounded(needed) +
                         " squares of a strip's width, and best plans along parameter "
                         "lines for at most " +
                         rounded(most_squares_followed) +
                         "; expected a larger cutter or scallop height"};
    } else if (is_large()) {
        Trials trials;
        trials.travel = estimated_along(strategy, own);
        estimated_.push_back({strategy, std::move(trials)});
    } else {
        add(strategy, covering_by(strategy, part_, cutter_, own));
    }
}

// Refuses a part that would need too many samples, if there are parameter lines.
void StrategyComparison::require_few_squares() const
{
    const double needed = squares(options_.scallop_height);
    if (needed <= most_squares_sampled ||
        !std::holds_alternative<std::vector<Surface>>(part_))
        return;
    throw LimitError{
        "the part has " + rounded(needed) +
        " squares of a strip's width, and best samples parts of at most " +
        rounded(most_squares_sampled) +
        ", to save time; name this strategy to plan by it, or allow a larger "
        "scallop height"};
}

// The length of passes along parameter lines, from that for a greater height.
double StrategyComparison::estimated_along(Strategy strategy,
                                           StrategyOptions options) const
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
double StrategyComparison::least_travel() const
{
    double least = std::numeric_limits<double>::infinity();
    for (const Candidate& one : candidates_)
        least = std::min(least, one.travel);
    for (const Estimated& one : estimated_)
        if (is_possible(one))
            least = std::min(least, one.trials.travel.value_or(least));
    return least;
}

bool StrategyComparison::is_possible(const Estimated& one) const
{
    return std::any_of(tried_.begin(), tried_.end(), [&](const TriedStrategy& other) {
        return other.strategy == one.strategy && other.refusal.empty();
    });
}

void StrategyComparison::search_directions(Estimated& one)
{
    one.trials.directions = std::exchange(one.search, nullptr)->directions({});
    one.trials.travel = one.trials.directions->travel;
}

// Searches for the direction of Strategy::Planar where it may give the shortest path.
void StrategyComparison::search_further()
{
    for (Estimated& one : estimated_)
        if (one.search && one.travel() <= worth_searching * least_travel())
            search_directions(one);
}

// Whether a strategy may give the shortest path, by its estimate.
bool StrategyComparison::is_promising(const Estimated& one) const
{
    const double travel = one.travel();
    if (follows_parameters(one.strategy))
        return travel <= worth_following * least_travel();
    return travel <= worth_laying * least_travel() &&
           (candidates_.empty() || !is_large());
}

void StrategyComparison::lay(Estimated& one)
{
    const StrategyOptions own = next_share();
    if (is_promising(one))
        lay(one, own);
    else
        tried(one.strategy).estimated_mm = one.travel();
}

void StrategyComparison::lay(Estimated& one, const StrategyOptions& options)
{
    if (one.search)
        search_directions(one);
    if (follows_parameters(one.strategy))
        add(one.strategy, covering_by(one.strategy, part_, cutter_, options));
    else
        add(one.strategy, covering_after(one.trials, *covered_, options));
}

}  // namespace endmill
