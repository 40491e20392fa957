// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/front_march.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <unordered_map>

#include "endmill/strategy/detail/reach.h"

namespace endmill {
namespace {

// An island is a notch that the pass should bend into if the pass covered at least this
// share of its surroundings.
constexpr double notch_share = 0.25;
// Distance over which a bend decreases by the factor e, as a multiple of the half width of
// a strip. The line that is bent runs about two half widths from the island.
constexpr double bend_decay = 4;
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

// The contacts of a line, without those that are too close together.
LaidPass pass_on(const LevelLine& line, const PartSamples& samples)
{
    LaidPass pass{{}, line.is_closed};
    const double least = least_step * samples.spacing();
    for (std::size_t k = 0; k < line.places.size(); ++k) {
        const PassContact contact = samples.contact(line.places[k]);
        const bool is_last = k + 1 == line.places.size();
        if (pass.contacts.empty() ||
            (contact.at.contact.point - pass.contacts.back().at.contact.point).norm() >=
                least)
            pass.contacts.push_back(contact);
        else if (is_last && !line.is_closed && pass.contacts.size() > 1)
            pass.contacts.back() = contact;
    }
    return pass;
}

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
      wanted_(coverage.samples().size(), 0),
      is_new_(coverage.samples().size(), false),
      is_seen_(coverage.samples().size(), false),
      bent_(reach_)
{
}

std::vector<LevelLine> FrontMarch::current_front()
{
    std::erase_if(front_samples_, [&](std::int32_t i) {
        return std::ranges::none_of(samples_->neighbours(i), [&](std::int32_t neighbour) {
            return is_uncovered(neighbour);
        });
    });
    if (front_samples_.empty())
        return {};
    return level_lines(*samples_, coverage_->gaps(), front_samples_, slack_);
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
            for (const LevelLine& line : current_front())
                front.insert(front.end(), line.places.begin(), line.places.end());
        if (front.empty() || !step(front))
            return;
        front.clear();
    }
}

void FrontMarch::lay(std::span<const LevelLine> lines)
{
    std::vector<LaidPass> passes;
    for (const LevelLine& line : where_positive(lines, coverage_->gaps(), slack_)) {
        passes.push_back(pass_on(line, *samples_));
        coverage_->add(passes.back().contacts, passes.back().is_closed);
    }
    accept(std::move(passes));
}

void FrontMarch::measure_reach(std::span<const SampleEdge> front)
{
    const double radius = coverage_->cutter().radius();
    for (const SampleEdge& place : front) {
        const Vec3 raised = (1 - place.share) * coverage_->raised(place.from) +
                            place.share * coverage_->raised(place.to);
        walk_.from(std::array{place.from, place.to}, [&](std::int32_t i) {
            const Vec3 centre = coverage_->centre(i);
            const double x = raised.x() - centre.x();
            const double y = raised.y() - centre.y();
            const double z = std::min(0.0, raised.z() - centre.z());
            const double beyond = beyond_reach(x * x + y * y + z * z, radius);
            if (reach_[i] == radius)
                measured_.push_back(i);
            reach_[i] = std::min(reach_[i], beyond);
            return beyond < 0 && is_uncovered(i);
        });
    }
}

void FrontMarch::forget_reach()
{
    for (const std::int32_t i : measured_)
        bent_[i] = reach_[i] = coverage_->cutter().radius();
    measured_.clear();
}

std::vector<LaidPass> FrontMarch::trial_passes(std::span<const double> bend)
{
    for (std::size_t k = 0; k < measured_.size(); ++k)
        bent_[measured_[k]] = reach_[measured_[k]] + bend[k];
    std::vector<LaidPass> passes;
    for (const LevelLine& line : where_positive(level_lines(*samples_, bent_, measured_),
                                                coverage_->gaps(), slack_))
        passes.push_back(pass_on(line, *samples_));
    return passes;
}

std::vector<LaidPass> FrontMarch::try_passes(std::span<const double> bend)
{
    coverage_->withdraw();
    std::vector<LaidPass> passes = trial_passes(bend);
    for (const LaidPass& pass : passes)
        coverage_->add(pass.contacts, pass.is_closed);
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

bool FrontMarch::step(std::span<const SampleEdge> front)
{
    measure_reach(front);
    std::sort(measured_.begin(), measured_.end());
    measured_.erase(std::unique(measured_.begin(), measured_.end()), measured_.end());
    coverage_->watch(front);
    std::vector<double> bend(measured_.size(), 0);
    std::vector<double> best_bend = bend;
    double least_missed = std::numeric_limits<double>::infinity();
    double missed_before = least_missed;
    std::vector<LaidPass> passes;
    for (int round = 0; round <= rounds_; ++round) {
        passes = try_passes(bend);
        const std::vector<Island> left = islands();
        if (rounds_ > 1)
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
    if (bend != best_bend)
        passes = try_passes(best_bend);
    const std::vector<Island> left = islands();
    bool covers_more = accept(std::move(passes));
    for (const Island& island : left) {
        std::vector<LaidPass> middle{middle_pass(island)};
        coverage_->add(middle.front().contacts, false);
        covers_more = accept(std::move(middle)) || covers_more;
    }
    forget_reach();
    return covers_more;
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
        Island island{{}, 0};
        bool is_open = false;
        double around = 0;
        double around_new = 0;
        inner_walk_.from(std::array{start}, [&](std::int32_t i) {
            if (!is_uncovered(i)) {
                around += 1;
                around_new += is_new_[i] ? 1 : 0;
                return false;
            }
            if (reach_[i] >= 0) {
                is_open = true;
                return false;
            }
            is_seen_[i] = true;
            island.samples.push_back(i);
            return true;
        });
        if (is_open)
            continue;
        island.beside_pass = around > 0 ? around_new / around : 0;
        found.push_back(std::move(island));
    }
    for (const std::int32_t i : measured_)
        is_seen_[i] = false;
    for (const std::int32_t i : covered_now)
        is_new_[i] = false;
    return found;
}

bool FrontMarch::bend_towards(std::span<const Island> islands,
                              std::span<const SampleEdge> front,
                              std::vector<double>& bend)
{
    const double radius = coverage_->cutter().radius();
    const double height = coverage_->height();
    // half the width of a strip on a plane
    const double half_width = std::sqrt(height * (2 * radius - height));
    using Entry = std::pair<double, std::int32_t>;  // wanted bend and sample
    std::priority_queue<Entry> queue;
    const auto want = [&](std::int32_t i, double value) {
        if (value > wanted_[i]) {
            if (wanted_[i] == 0)
                wanting_.push_back(i);
            wanted_[i] = value;
            queue.emplace(value, i);
        }
    };
    for (const Island& island : islands)
        for (const std::int32_t i : is_notch(island)
                                        ? std::span<const std::int32_t>{island.samples}
                                        : std::span<const std::int32_t>{})
            want(i, std::min(bend_excess * (coverage_->gaps()[i] - slack_) + slack_,
                             greatest_bend * height));
    for (std::size_t k = 0; k < front.size(); ++k) {
        const double gap = coverage_->watched_gaps()[k];
        if (gap <= slack_ || gap > greatest_bend * height)
            continue;
        want(front[k].from, bend_excess * gap);
        want(front[k].to, bend_excess * gap);
    }
    for (const MissedPlace& place : missed_places_)
        want(place.at.near, bend_excess * std::min(place.gap, greatest_bend * height));
    if (queue.empty())
        return false;
    const double least = least_bend_share * queue.top().first;
    while (!queue.empty()) {
        const auto [value, i] = queue.top();
        queue.pop();
        if (value < wanted_[i])
            continue;
        for (const std::int32_t neighbour : samples_->neighbours(i)) {
            const double distance =
                (samples_->point(neighbour) - samples_->point(i)).norm();
            // 1 / (1 + d + d^2 / 2) is close to exp(-d) and quicker
            const double decay = distance / (bend_decay * half_width);
            const double less = value / (1 + decay + decay * decay / 2);
            if (less > least && reach_[neighbour] < radius)
                want(neighbour, less);
        }
    }
    for (std::size_t k = 0; k < measured_.size(); ++k)
        bend[k] = std::min(bend[k] + wanted_[measured_[k]], greatest_total_bend * height);
    for (const std::int32_t i : wanting_)
        wanted_[i] = 0;
    wanting_.clear();
    return true;
}

// Keeps the passes that were added. Whether they cover a sample that was not covered: the
// march ends without one, so that it cannot go on for ever.
bool FrontMarch::accept(std::vector<LaidPass> passes)
{
    const std::vector<std::int32_t> covered = coverage_->newly_covered(slack_);
    front_samples_.insert(front_samples_.end(), covered.begin(), covered.end());
    coverage_->accept();
    for (LaidPass& pass : passes)
        passes_.push_back(std::move(pass));
    return !covered.empty();
}

LaidPass FrontMarch::middle_pass(const Island& island)
{
    std::unordered_map<std::int32_t, double> gap_of;
    double deepest = 0;
    for (const std::int32_t i : island.samples) {
        gap_of[i] = coverage_->gaps()[i];
        deepest = std::max(deepest, gap_of[i]);
    }
    // Distances over the island; a step costs more where the gap is smaller, so that the
    // shortest way runs in the middle.
    using Entry = std::pair<double, std::int32_t>;
    std::unordered_map<std::int32_t, std::int32_t> before;
    const auto farthest_from = [&](std::int32_t start, double penalty) {
        std::unordered_map<std::int32_t, double> distance{{start, 0.0}};
        before = {{start, start}};
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
        queue.emplace(0.0, start);
        std::int32_t last = start;
        while (!queue.empty()) {
            const auto [so_far, i] = queue.top();
            queue.pop();
            if (so_far > distance[i])
                continue;
            last = i;
            for (const std::int32_t neighbour : samples_->neighbours(i)) {
                const auto gap = gap_of.find(neighbour);
                if (gap == gap_of.end())
                    continue;
                const double step =
                    (samples_->point(neighbour) - samples_->point(i)).norm() *
                    (1 + penalty * (1 - gap->second / deepest));
                const auto known = distance.find(neighbour);
                if (known == distance.end() || so_far + step < known->second) {
                    distance[neighbour] = so_far + step;
                    before[neighbour] = i;
                    queue.emplace(so_far + step, neighbour);
                }
            }
        }
        return last;
    };
    const std::int32_t end = farthest_from(island.samples.front(), 0);
    const std::int32_t other = farthest_from(end, 4);
    LaidPass pass;
    for (std::int32_t i = other;; i = before[i]) {
        pass.contacts.push_back(samples_->contact({i, i, 0}));
        if (before[i] == i)
            break;
    }
    return pass;
}

}  // namespace endmill
