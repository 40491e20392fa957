// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/iso_scallop.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/strategy/detail/front_march.h"
#include "endmill/strategy/detail/starts.h"

namespace endmill {
namespace {

// Share of the layout height by which a sample may miss its cover.
constexpr double slack_share = 0.005;
// Samples across a strip for the result, and fewer for a part that would have very many,
// where the strips are narrow for the ball. Errors between samples are of third order in
// their distance, and the scallop height is of second order in the width of a strip. Thus the
// share of the height that is missed grows with the distance of samples over the radius.
constexpr double samples_across = 5;
constexpr double least_samples_across = 2.5;
constexpr std::size_t most_dense_samples = 200'000;
constexpr double coarse_spacing = 0.14;  // in radii
// Rounds in which a pass is bent, for the choice and for the result.
constexpr int few_rounds = 0;
constexpr int rounds = 4;
// Starts that are tried with many samples; only one with more than `most_compared_samples`.
constexpr std::size_t finalists = 3;
constexpr std::size_t most_compared_samples = 80'000;
// Starts are chosen on about this many samples at most.
constexpr FewSamplesLimits trial_samples{2.5, 40'000};
// Share of the work until starts are ranked on few samples.
constexpr double ranked_share = 0.4;

// The way between two places, mm, by the distance that counts.
double way(const PartSamples& samples, const SampleEdge& from, const SampleEdge& to,
           double radius, TravelKind distance)
{
    return distance == TravelKind::Tip
               ? (samples.near_centre(to, radius) - samples.near_centre(from, radius))
                     .norm()
               : (samples.near_place(to).point - samples.near_place(from).point).norm();
}

double length(const LevelLine& line, const PartSamples& samples, double radius,
              TravelKind distance)
{
    double sum = 0;
    for (std::size_t k = 0; k + 1 < line.places.size(); ++k)
        sum += way(samples, line.places[k], line.places[k + 1], radius, distance);
    if (line.is_closed)
        sum += way(samples, line.places.back(), line.places.front(), radius, distance);
    return sum;
}

// What a pass costs beyond its length, in widths of a strip: it needs a link. A pass shorter
// than a strip is wide is often left out later.
constexpr double pass_price = 1;
constexpr double short_pass_price = 0.5;

// Reports the share of some work, from one share of all work to another.
class ShareCounter {
public:
    ShareCounter(const std::function<void(double)>& progress, double from, double to,
                 std::size_t items)
        : progress_{&progress},
          from_{from},
          to_{to},
          items_{items}
    {
    }

    void finish_item()
    {
        const std::size_t done = ++done_;
        if (*progress_)
            (*progress_)(std::lerp(
                from_, to_, static_cast<double>(done) / static_cast<double>(items_)));
    }

private:
    const std::function<void(double)>* progress_;
    double from_;
    double to_;
    std::size_t items_;
    std::atomic<std::size_t> done_ = 0;
};

struct Trial {
    std::vector<LevelLine> lines;
    double travel = 0;  // length of the lines, mm
    double cost = 0;
};

// How the passes of a trial are laid and measured.
struct TrialRules {
    double height;        // scallop height, mm
    TravelKind distance;  // whose length counts
    int bending_rounds;
};

Trial trial(const PartSamples& samples, const MarchStart& start, const BallCutter& cutter,
            const TrialRules& rules)
{
    Coverage coverage{samples, cutter, layout_share * rules.height};
    Trial result{
        lay_lines(coverage, start, slack_share * rules.height, rules.bending_rounds)};
    const double width = strip_width(cutter, rules.height);
    for (const LevelLine& line : result.lines) {
        const double own = length(line, samples, cutter.radius(), rules.distance);
        result.travel += own;
        result.cost += own + (own < width ? short_pass_price : pass_price) * width;
    }
    return result;
}

// A start and its passes on few samples.
struct RankedStart {
    MarchStart start;
    double travel;
    double cost;
};

std::vector<RankedStart> ranked(const std::vector<MarchStart>& starts,
                                const FewSamples& few, const BallCutter& cutter,
                                TravelKind distance, ShareCounter& counter)
{
    std::vector<RankedStart> ranked(starts.size());
    parallel_for(starts.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const Trial tried =
                trial(few.samples, starts[k], cutter, {few.height, distance, few_rounds});
            ranked[k] = {starts[k], tried.travel, tried.cost};
            counter.finish_item();
        }
    });
    return ranked;
}

void sort_by_cost(std::vector<RankedStart>& starts)
{
    std::stable_sort(
        starts.begin(), starts.end(),
        [](const RankedStart& a, const RankedStart& b) { return a.cost < b.cost; });
}

PartSamples samples_for_march(const CoveredPart& part, double height,
                              std::size_t most_samples)
{
    const double width = strip_width(part.cutter(), height);
    const double dense = width / samples_across;
    const double coarse = width / least_samples_across;
    const std::array trials{
        std::pair{dense, std::min(most_samples, most_dense_samples)},
        std::pair{std::clamp(coarse_spacing * part.cutter().radius(), dense, coarse),
                  most_samples}};
    for (const auto& [spacing, most] : trials)
        try {
            return part.samples(spacing, most);
        } catch (const LimitError&) {
            continue;  // with fewer samples
        }
    return part.samples(coarse, most_samples);
}

}  // namespace

// Sections in other places are tried in the best directions only.
ScallopStarts scallop_starts(const CoveredPart& part, const BallCutter& cutter,
                             const StrategyOptions& options)
{
    require_possible(part,
                     strip_width(cutter, options.scallop_height) / least_samples_across,
                     options.most_samples);
    const FewSamples few =
        few_samples(part, trial_samples, options.scallop_height, options.most_samples);
    const std::vector<MarchStart> starts = march_starts(few.samples);
    ShareCounter counter{options.progress, 0, ranked_share,
                         starts.size() + 2 * finalists};
    std::vector<RankedStart> known =
        ranked(starts, few, cutter, options.distance, counter);
    sort_by_cost(known);
    std::vector<MarchStart> further;
    std::size_t directions = 0;
    for (const RankedStart& candidate : known)
        if (const auto* line = std::get_if<LineStart>(&candidate.start);
            line && directions < finalists) {
            ++directions;
            for (const double share : {0.25, 0.75})
                further.push_back(LineStart{line->angle, share});
        }
    for (const RankedStart& candidate :
         ranked(further, few, cutter, options.distance, counter))
        known.push_back(candidate);
    sort_by_cost(known);
    ScallopStarts result{
        {},
        scaled_travel(known.front().travel, cutter, few.height, options.scallop_height)};
    for (std::size_t k = 0; k < std::min(finalists, known.size()); ++k)
        result.best.push_back(known[k].start);
    return result;
}

LaidPasses iso_scallop_passes(const CoveredPart& part, const BallCutter& cutter,
                              const StrategyOptions& options, const ScallopStarts& starts)
{
    const double height = options.scallop_height;
    PartSamples samples = samples_for_march(part, height, options.most_samples);
    std::vector<Trial> trials(
        samples.size() > most_compared_samples ? 1 : starts.best.size());
    ShareCounter counter{options.progress, ranked_share, 1, trials.size()};
    parallel_for(trials.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            trials[k] = trial(samples, starts.best[k], cutter,
                              {height, options.distance, rounds});
            counter.finish_item();
        }
    });
    const auto best =
        std::min_element(trials.begin(), trials.end(),
                         [](const Trial& a, const Trial& b) { return a.cost < b.cost; });
    std::vector<LaidPass> passes = passes_on(best->lines, samples);
    return {std::move(samples), std::move(passes)};
}

}  // namespace endmill
