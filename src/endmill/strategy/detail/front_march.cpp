// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/front_march.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "endmill/strategy/detail/middle_way.h"
#include "endmill/strategy/detail/reach.h"

namespace endmill {
namespace {

// An island is a notch that the pass should bend into if the pass covered at least this
// share of its surroundings.
constexpr double notch_share = 0.25;
// Distance over which a bend decreases by the factor e, as a multiple of the half width of
// a strip. A longer one bends more of the line than the island needs.
constexpr double bend_decay = 1.2;
// A bend is not followed below this share of the island's own.
constexpr double least_bend_share = 0.1;
// A bend exceeds the gap that asks for it by this factor, so that few rounds are needed.
constexpr double bend_excess = 1.6;
// Greatest bend of a round, as a share of the scallop height.
constexpr double greatest_bend = 0.5;
// Greatest sum of the bends of all rounds, in scallop heights. At 1 a pass would return to
// its front.
constexpr double greatest_total_bend = 0.7;

// Least distance of the contacts of a pass, as a share of the distance of samples.
constexpr double least_step = 0.9;

// An island with fewer samples is small enough to bend to, whatever surrounds it.
constexpr std::size_t small_island = 12;

}  // namespace

bool FrontMarch::is_notch(const Island& island)
{
    return island.beside_pass >= notch_share ||
           (island.beside_pass > 0 && island.samples.size() < small_island);
}

FrontMarch::FrontMarch(Coverage& coverage, double slack, int rounds)
    : coverage_{&coverage},
      samples_{&coverage.samples()},
      slack_{slack},
      rounds_{rounds},
      walk_{coverage.samples()},
      inner_walk_{coverage.samples()},
      reach_(coverage.samples().size(), coverage.cutter().radius()),
      nearest_front_(coverage.samples().size(), -1),
      wanted_(coverage.samples().size(), 0),
      is_new_(coverage.samples().size(), false),
      is_seen_(coverage.samples().size(), false),
      bent_(reach_),
      bend_of_(coverage.samples().size(), 0)
{
}

std::vector<SampleEdge> FrontMarch::current_front()
{
    std::erase_if(front_samples_, [&](std::int32_t i) {
        return std::ranges::none_of(samples_->neighbours(i), [&](std::int32_t neighbour) {
            return is_uncovered(neighbour);
        });
    });
    std::vector<SampleEdge> front;
    if (front_samples_.empty())
        return front;
    for (LevelLine& line :
         level_lines(*samples_, coverage_->gaps(), front_samples_, slack_))
        for (SampleEdge& place : line.places) {
            place.share = crossing_share([&](double share) {
                return coverage_->gap_at({place.from, place.to, share}) - slack_;
            });
            front.push_back(place);
        }
    return front;
}

std::size_t FrontMarch::uncovered_samples() const
{
    return static_cast<std::size_t>(
        std::count_if(coverage_->gaps().begin(), coverage_->gaps().end(),
                      [&](double gap) { return gap > slack_; }));
}

std::int32_t FrontMarch::first_uncovered() const
{
    const std::span<const double> gaps = coverage_->gaps();
    return static_cast<std::int32_t>(
        std::find_if(gaps.begin(), gaps.end(), [&](double gap) { return gap > slack_; }) -
        gaps.begin());
}

void FrontMarch::run(std::vector<SampleEdge> front)
{
    for (;;) {
        if (front.empty())
            front = current_front();
        if (front.empty() || !step(front))
            return;
        front.clear();
    }
}

// The line without places that are too close together.
LevelLine FrontMarch::thinned(const LevelLine& line) const
{
    LevelLine thin{{}, line.is_closed};
    const double least = least_step * samples_->spacing();
    Vec3 last = Vec3::Zero();
    for (std::size_t k = 0; k < line.places.size(); ++k) {
        const Vec3 point = samples_->near_place(line.places[k]).point;
        const bool is_end = k + 1 == line.places.size() && !line.is_closed;
        const bool is_far = thin.places.empty() || (point - last).norm() >= least;
        if (!is_far && !(is_end && thin.places.size() > 1))
            continue;
        if (!is_far)
            thin.places.pop_back();
        thin.places.push_back(line.places[k]);
        last = point;
    }
    return thin;
}

void FrontMarch::lay(std::span<const LevelLine> lines)
{
    std::vector<LevelLine> passes;
    for (const LevelLine& line : where_positive(lines, coverage_->gaps(), slack_)) {
        passes.push_back(thinned(line));
        coverage_->add(passes.back().places, passes.back().is_closed);
    }
    accept(std::move(passes));
}

// Measures the reach of a front point.
void FrontMarch::reach_from(std::int32_t front, const SampleEdge& place)
{
    const double radius = coverage_->cutter().radius();
    const Vec3& raised = front_raised_[front];
    walk_.from(std::array{place.from, place.to}, [&](std::int32_t i) {
        const double beyond = point_reach(coverage_->centre(i), raised, radius);
        if (nearest_front_[i] < 0)
            measured_.push_back(i);
        if (nearest_front_[i] < 0 || beyond < reach_[i]) {
            reach_[i] = std::min(reach_[i], beyond);
            nearest_front_[i] = front;
        }
        return beyond < 0 && is_uncovered(i);
    });
}

void FrontMarch::measure_reach(std::span<const SampleEdge> front)
{
    front_raised_.clear();
    for (const SampleEdge& place : front) {
        front_raised_.push_back(coverage_->raised(place));
        reach_from(static_cast<std::int32_t>(front_raised_.size() - 1), place);
    }
    std::sort(measured_.begin(), measured_.end());
}

void FrontMarch::forget_reach()
{
    for (const std::int32_t i : measured_) {
        bent_[i] = reach_[i] = coverage_->cutter().radius();
        nearest_front_[i] = -1;
        bend_of_[i] = 0;
    }
    measured_.clear();
}

// The reach at a place between samples, from the front points that are nearest to them.
double FrontMarch::reach_at(const SampleEdge& place) const
{
    const double radius = coverage_->cutter().radius();
    const Vec3 centre = samples_->near_centre(place, radius);
    double reach = radius;
    for (const std::int32_t i : {place.from, place.to})
        if (const std::int32_t front = nearest_front_[i]; front >= 0)
            reach = std::min(reach, point_reach(centre, front_raised_[front], radius));
    return reach;
}

double FrontMarch::bent_reach_at(const SampleEdge& place) const
{
    return reach_at(place) +
           std::lerp(bend_of_[place.from], bend_of_[place.to], place.share);
}

std::vector<LevelLine> FrontMarch::trial_passes(std::span<const double> bend)
{
    for (std::size_t k = 0; k < measured_.size(); ++k) {
        bend_of_[measured_[k]] = bend[k];
        bent_[measured_[k]] = reach_[measured_[k]] + bend[k];
    }
    std::vector<LevelLine> passes;
    for (LevelLine& line : where_positive(level_lines(*samples_, bent_, measured_),
                                          coverage_->gaps(), slack_)) {
        for (SampleEdge& place : line.places)
            place.share = crossing_share([&](double share) {
                return bent_reach_at({place.from, place.to, share});
            });
        passes.push_back(thinned(line));
    }
    return passes;
}

std::vector<LevelLine> FrontMarch::try_passes(std::span<const double> bend)
{
    coverage_->withdraw();
    std::vector<LevelLine> passes = trial_passes(bend);
    for (const LevelLine& pass : passes)
        coverage_->add(pass.places, pass.is_closed);
    return passes;
}

std::vector<std::int32_t> FrontMarch::strip_triangles() const
{
    std::vector<std::int32_t> triangles;
    for (const std::int32_t i : measured_)
        for (const std::int32_t number : samples_->triangles_at(i))
            if (std::ranges::min(samples_->triangles()[number]) == i)
                triangles.push_back(number);
    return triangles;
}

double FrontMarch::missed_by(std::span<const Island> left) const
{
    auto missed = static_cast<double>(missed_places_.size());
    for (const Island& island : left)
        missed += static_cast<double>(island.samples.size());
    for (const double gap : coverage_->watched_gaps())
        if (gap > slack_ && gap <= greatest_bend * coverage_->height())
            missed += 1;
    return missed;
}

// Adds the passes ahead of the front, bent so that they miss as little as possible.
std::vector<LevelLine> FrontMarch::bent_passes(std::span<const SampleEdge> front)
{
    std::vector<double> bend(measured_.size(), 0);
    std::vector<double> best_bend = bend;
    double least_missed = std::numeric_limits<double>::infinity();
    double missed_before = least_missed;
    std::vector<LevelLine> passes;
    for (int round = 0; round <= rounds_; ++round) {
        passes = try_passes(bend);
        const std::vector<Island> left = islands();
        if (rounds_ > 0)
            missed_places_ = coverage_->missed(strip_triangles(), slack_);
        const double missed = missed_by(left);
        const bool is_stuck = missed == missed_before;
        missed_before = missed;
        if (missed < least_missed) {
            least_missed = missed;
            best_bend = bend;
        }
        if (round == rounds_ || missed == 0 || is_stuck ||
            !bend_towards(left, front, bend))
            break;
    }
    return bend == best_bend ? passes : try_passes(best_bend);
}

bool FrontMarch::step(std::span<const SampleEdge> front)
{
    measure_reach(front);
    coverage_->watch(front);
    std::vector<LevelLine> passes = bent_passes(front);
    const std::vector<Island> left = islands();
    bool covers_more = accept(std::move(passes));
    for (const Island& island : left) {
        // the pass along another island may cover this one too
        if (std::ranges::none_of(island.samples,
                                 [&](std::int32_t i) { return is_uncovered(i); }))
            continue;
        std::vector<LevelLine> middle{middle_pass(island)};
        coverage_->add(middle.front().places, false);
        covers_more = accept(std::move(middle)) || covers_more;
    }
    forget_reach();
    return covers_more;
}

// The uncovered samples that are connected with `start`, as far as the front reaches.
FrontMarch::Island FrontMarch::island_around(std::int32_t start)
{
    Island island;
    double around = 0;
    double around_new = 0;
    inner_walk_.from(std::array{start}, [&](std::int32_t i) {
        if (!is_uncovered(i)) {
            around += 1;
            around_new += is_new_[i] ? 1 : 0;
            return false;
        }
        if (reach_[i] >= 0) {
            island.is_open = true;
            return false;
        }
        is_seen_[i] = true;
        island.samples.push_back(i);
        return true;
    });
    island.beside_pass = around > 0 ? around_new / around : 0;
    return island;
}

std::vector<FrontMarch::Island> FrontMarch::islands()
{
    const std::vector<std::int32_t> covered_now = coverage_->newly_covered(slack_);
    for (const std::int32_t i : covered_now)
        is_new_[i] = true;
    std::vector<Island> found;
    for (const std::int32_t start : measured_) {
        if (!is_uncovered(start) || reach_[start] >= 0 || is_seen_[start])
            continue;
        Island island = island_around(start);
        if (!island.is_open)
            found.push_back(std::move(island));
    }
    for (const std::int32_t i : measured_)
        is_seen_[i] = false;
    for (const std::int32_t i : covered_now)
        is_new_[i] = false;
    return found;
}

void FrontMarch::want(std::int32_t i, double bend)
{
    if (bend <= wanted_[i])
        return;
    if (wanted_[i] == 0)
        wanting_.push_back(i);
    wanted_[i] = bend;
    spreading_.emplace(bend, i);
}

// Wants a bend where the passes of the last trial miss something.
void FrontMarch::want_bends(std::span<const Island> islands,
                            std::span<const SampleEdge> front)
{
    const double greatest = greatest_bend * coverage_->height();
    for (const Island& island : islands)
        if (is_notch(island))
            for (const std::int32_t i : island.samples)
                want(i, std::min(bend_excess * (coverage_->gaps()[i] - slack_) + slack_,
                                 greatest));
    for (std::size_t k = 0; k < front.size(); ++k)
        if (const double gap = coverage_->watched_gaps()[k];
            gap > slack_ && gap <= greatest) {
            want(front[k].from, bend_excess * gap);
            want(front[k].to, bend_excess * gap);
        }
    for (const MissedPlace& place : missed_places_)
        want(sample_beside(*samples_, place),
             bend_excess * std::min(place.gap, greatest));
}

// Spreads the bends that are wanted to the samples around, less with the distance.
void FrontMarch::spread_wanted()
{
    const double radius = coverage_->cutter().radius();
    const double height = coverage_->height();
    // half the width of a strip on a plane
    const double half_width = std::sqrt(height * (2 * radius - height));
    const double least = least_bend_share * spreading_.top().first;
    while (!spreading_.empty()) {
        const auto [value, i] = spreading_.top();
        spreading_.pop();
        if (value < wanted_[i])
            continue;
        for (const std::int32_t neighbour : samples_->neighbours(i)) {
            if (reach_[neighbour] >= radius)
                continue;
            const double distance =
                (samples_->point(neighbour) - samples_->point(i)).norm();
            // 1 / (1 + d + d^2 / 2) is close to exp(-d) and quicker
            const double decay = distance / (bend_decay * half_width);
            const double less = value / (1 + decay + decay * decay / 2);
            if (less > least)
                want(neighbour, less);
        }
    }
}

bool FrontMarch::bend_towards(std::span<const Island> islands,
                              std::span<const SampleEdge> front,
                              std::vector<double>& bend)
{
    want_bends(islands, front);
    if (spreading_.empty())
        return false;
    spread_wanted();
    const double greatest = greatest_total_bend * coverage_->height();
    for (std::size_t k = 0; k < measured_.size(); ++k)
        bend[k] = std::min(bend[k] + wanted_[measured_[k]], greatest);
    for (const std::int32_t i : wanting_)
        wanted_[i] = 0;
    wanting_.clear();
    return true;
}

// Keeps the passes that were added. Whether they cover a sample that was not covered: the
// march ends without one, so that it cannot go on for ever.
bool FrontMarch::accept(std::vector<LevelLine> passes)
{
    const std::vector<std::int32_t> covered = coverage_->newly_covered(slack_);
    front_samples_.insert(front_samples_.end(), covered.begin(), covered.end());
    coverage_->accept();
    for (LevelLine& pass : passes)
        passes_.push_back(std::move(pass));
    return !covered.empty();
}

LevelLine FrontMarch::middle_pass(const Island& island) const
{
    LevelLine pass{{}, false};
    for (const std::int32_t i : middle_way(*samples_, island.samples, coverage_->gaps()))
        pass.places.push_back({i, i, 0});
    return pass;
}

}  // namespace endmill
