// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/planar.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "endmill/core/parallel.h"
#include "endmill/strategy/detail/section_march.h"

namespace endmill {
namespace {

constexpr double pi = std::numbers::pi;

// Share of the height at which passes are laid. The pitch of a pass is limited by its worst
// place only, so that passes can be mended there.
constexpr double planar_share = 0.985;
// Share of the height by which a sample may miss its cover.
constexpr double planar_slack_share = 0.002;
// Samples across a strip for the search of the direction, and for the result.
constexpr double search_samples_across = 2.5;
constexpr double planar_samples_across = 8;
// The search uses about so many samples. If strips are too narrow for that, it uses a
// greater height.
constexpr double search_samples = 20'000;
// The greatest height of the search, as a share of the radius.
constexpr double greatest_search_height = 0.25;
// Equal steps of the direction over half a turn, 5 degrees. The first estimate takes every
// third one.
constexpr std::size_t equal_steps = 36;
constexpr std::size_t first_steps = 3;
// Valleys of the travel in which the search continues, and its steps.
constexpr std::size_t valleys = 3;
constexpr int golden_steps = 4;
// Directions that are laid on the fine net; only the best one with more than `most_samples_for_several`.
constexpr std::size_t laid_directions = 3;
constexpr std::size_t most_samples_for_several = 200'000;
// Directions of parameter lines that differ by less are the same, and directions that are
// laid on the fine net differ by more, rad.
constexpr double same_turn = 0.01 * pi / 180;
constexpr double least_turn = 2 * pi / 180;
// Share of the work until the direction is found, and of that for the first estimate.
constexpr double searched_share = 0.6;
constexpr double coarse_share = 0.5;

// The direction between 0 and half a turn.
double half_turn(double angle)
{
    const double rest = std::fmod(angle, pi);
    const double positive = rest < 0 ? rest + pi : rest;
    return positive < pi ? positive : 0;
}

double equal_angle(std::size_t step)
{
    return static_cast<double>(step) * pi / equal_steps;
}

std::size_t nearest_step(double angle)
{
    return static_cast<std::size_t>(std::lround(angle * equal_steps / pi)) % equal_steps;
}

// The height of the search: the scallop height, or one for which the samples are few enough.
double search_height(const CoveredPart& part, const BallCutter& cutter,
                     const StrategyOptions& options)
{
    const double radius = cutter.radius();
    const double area = part.rough_area(options.most_samples);
    const double half_strip = std::min(
        search_samples_across * std::sqrt(2 * area / search_samples) / 2, radius);
    const double few = radius - std::sqrt(radius * radius - half_strip * half_strip);
    return std::max(options.scallop_height,
                    std::min(few, greatest_search_height * radius));
}

}  // namespace

std::vector<Angle> parameter_directions(const Part& part)
{
    std::vector<Angle> directions;
    const auto* surfaces = std::get_if<std::vector<Surface>>(&part);
    if (!surfaces)
        return directions;
    for (const Surface& surface : *surfaces) {
        const Interval u = surface.range(Parameter::U);
        const Interval v = surface.range(Parameter::V);
        const SurfaceTangents middle =
            surface.tangents((u.low + u.high) / 2, (v.low + v.high) / 2);
        for (const Vec3& way : {middle.du, middle.dv})
            directions.push_back(Angle::radians(half_turn(std::atan2(way.y(), way.x()))));
    }
    return directions;
}

DirectionSearch::DirectionSearch(const CoveredPart& part, const BallCutter& cutter,
                                 const StrategyOptions& options,
                                 std::span<const Angle> further)
    : cutter_{cutter},
      distance_{options.distance},
      asked_height_{options.scallop_height},
      height_{search_height(part, cutter, options)},
      samples_{part.samples(strip_width(cutter, height_) / search_samples_across,
                            options.most_samples)},
      equal_(equal_steps)
{
    require_possible(part, strip_width(cutter, asked_height_) / planar_samples_across,
                     options.most_samples);
    std::vector<double> angles;
    for (std::size_t k = 0; k < equal_steps; k += first_steps)
        angles.push_back(equal_angle(k));
    for (const Angle direction : further) {
        double angle = half_turn(direction.radians());
        const double nearest = equal_angle(nearest_step(angle));
        if (std::abs(nearest - angle) < same_turn)
            angle = nearest;
        if (std::none_of(angles.begin(), angles.end(), [&](double other) {
                return std::abs(other - angle) < same_turn;
            }))
            angles.push_back(angle);
    }
    for (const Tried& one : tried(angles, options.progress)) {
        const std::size_t nearest = nearest_step(one.angle);
        if (one.angle == equal_angle(nearest))
            equal_[nearest] = one;
        else
            further_.push_back(one);
    }
}

DirectionSearch::Tried DirectionSearch::tried(double angle) const
{
    Coverage coverage{samples_, cutter_, planar_share * height_};
    const std::vector<LaidPass> passes =
        SectionMarch{coverage, Angle::radians(angle), planar_slack_share * height_,
                     SectionContacts::OnNet}
            .passes();
    const PassLengths lengths = pass_lengths(passes, cutter_.radius());
    const double travel =
        distance_ == TravelKind::Tip ? lengths.tip_mm : lengths.contact_mm;
    return {angle, travel, lengths, passes.size()};
}

std::vector<DirectionSearch::Tried> DirectionSearch::tried(
    std::span<const double> angles, const std::function<void(double)>& progress) const
{
    std::vector<Tried> found(angles.size());
    std::atomic<std::size_t> done = 0;
    parallel_for(angles.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            found[k] = tried(angles[k]);
            if (progress)
                progress(static_cast<double>(++done) /
                         static_cast<double>(angles.size()));
        }
    });
    return found;
}

// Those that have been tried, by rising angle.
std::vector<DirectionSearch::Tried> DirectionSearch::all() const
{
    std::vector<Tried> found = further_;
    for (const std::optional<Tried>& one : equal_)
        if (one)
            found.push_back(*one);
    std::stable_sort(found.begin(), found.end(),
                     [](const Tried& a, const Tried& b) { return a.angle < b.angle; });
    return found;
}

double DirectionSearch::coarse_travel() const
{
    double least = std::numeric_limits<double>::infinity();
    for (const Tried& one : all())
        least = std::min(least, one.travel);
    return scaled_travel(least, cutter_, height_, asked_height_);
}

// Equal steps at which the travel is less than at both neighbours; the best few.
std::vector<std::size_t> DirectionSearch::best_valleys() const
{
    const auto travel = [&](std::size_t k) { return equal_[k % equal_steps]->travel; };
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < equal_steps; ++k)
        if (travel(k) <= travel(k + equal_steps - 1) && travel(k) <= travel(k + 1))
            found.push_back(k);
    std::stable_sort(found.begin(), found.end(),
                     [&](std::size_t a, std::size_t b) { return travel(a) < travel(b); });
    found.resize(std::min(found.size(), valleys));
    return found;
}

// Trials between the two neighbours of a direction.
std::vector<DirectionSearch::Tried> DirectionSearch::golden_section(
    const Tried& middle) const
{
    constexpr double golden = 0.3819660112501051;  // (3 - sqrt 5) / 2
    std::vector<Tried> found;
    double low = middle.angle - pi / equal_steps;
    double high = middle.angle + pi / equal_steps;
    double best = middle.angle;
    double least = middle.travel;
    for (int step = 0; step < golden_steps; ++step) {
        const bool is_upper = high - best > best - low;
        const double angle = std::lerp(best, is_upper ? high : low, golden);
        found.push_back(tried(half_turn(angle)));
        const bool is_better = found.back().travel < least;
        (is_upper == is_better ? low : high) = is_better ? best : angle;
        if (is_better) {
            best = angle;
            least = found.back().travel;
        }
    }
    return found;
}

PlanarDirections DirectionSearch::directions(const std::function<void(double)>& progress)
{
    std::vector<double> rest;
    for (std::size_t k = 0; k < equal_steps; ++k)
        if (!equal_[k])
            rest.push_back(equal_angle(k));
    for (const Tried& one : tried(rest, progress))
        equal_[nearest_step(one.angle)] = one;
    const std::vector<std::size_t> best = best_valleys();
    std::vector<std::vector<Tried>> between(best.size());
    parallel_for(best.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            between[k] = golden_section(*equal_[best[k]]);
    });
    for (const std::vector<Tried>& own : between)
        further_.insert(further_.end(), own.begin(), own.end());

    std::vector<Tried> known = all();
    PlanarDirections result;
    for (const Tried& one : known)
        result.compared.push_back({Angle::radians(one.angle), one.lengths.contact_mm,
                                   one.lengths.tip_mm, one.passes});
    std::stable_sort(known.begin(), known.end(),
                     [](const Tried& a, const Tried& b) { return a.travel < b.travel; });
    result.travel = scaled_travel(known.front().travel, cutter_, height_, asked_height_);
    for (const Tried& one : known) {
        const bool is_new = std::ranges::none_of(result.best, [&](Angle other) {
            const double turn = std::abs(other.radians() - one.angle);
            return std::min(turn, pi - turn) < least_turn;
        });
        if (is_new && result.best.size() < laid_directions)
            result.best.push_back(Angle::radians(one.angle));
    }
    return result;
}

PlanarDirections planar_directions(const CoveredPart& part, const BallCutter& cutter,
                                   const StrategyOptions& options,
                                   std::span<const Angle> further)
{
    if (options.direction)
        return {{*options.direction}, {}, {}};
    const auto share_of = [&](double from, double to) {
        StrategyOptions own = options;
        if (options.progress)
            own.progress = [&, from, to](double share) {
                options.progress(searched_share * std::lerp(from, to, share));
            };
        return own;
    };
    DirectionSearch search{part, cutter, share_of(0, coarse_share), further};
    return search.directions(share_of(coarse_share, 1).progress);
}

PlanarPasses planar_passes(const CoveredPart& part, const BallCutter& cutter,
                           const StrategyOptions& options,
                           std::span<const Angle> directions)
{
    const double height = options.scallop_height;
    PartSamples samples = part.samples(
        strip_width(cutter, height) / planar_samples_across, options.most_samples);
    if (samples.size() > most_samples_for_several)
        directions = directions.first(1);
    std::vector<std::vector<LaidPass>> laid(directions.size());
    std::vector<double> travel(directions.size());
    parallel_for(directions.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            Coverage coverage{samples, cutter, planar_share * height};
            laid[k] = SectionMarch{coverage, directions[k], planar_slack_share * height,
                                   SectionContacts::OnSurface}
                          .passes();
            const PassLengths lengths = pass_lengths(laid[k], cutter.radius());
            travel[k] =
                options.distance == TravelKind::Tip ? lengths.tip_mm : lengths.contact_mm;
        }
    });
    const auto best = static_cast<std::size_t>(
        std::min_element(travel.begin(), travel.end()) - travel.begin());
    return {{std::move(samples), std::move(laid[best])}, directions[best]};
}

}  // namespace endmill
