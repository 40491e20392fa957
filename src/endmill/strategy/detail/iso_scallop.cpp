// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/iso_scallop.h"

#include <algorithm>
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

// Share of it by which a sample may miss its cover.
constexpr double slack_share = 0.005;
// Samples across a strip for the choice of the start, and for the result.
constexpr double few_samples_across = 2;
constexpr double samples_across = 5;
// Rounds in which a pass is bent, for the choice and for the result.
constexpr int few_rounds = 0;
constexpr int rounds = 4;
// Starts that are tried with many samples; only one with more than `many_samples`.
constexpr std::size_t finalists = 3;
constexpr std::size_t many_samples = 80'000;
// Starts are chosen on at most this many samples. A low scallop height is raised for the choice,
// by this factor as often as needed, up to a share of the radius.
constexpr std::size_t most_few_samples = 80'000;
constexpr double raising_factor = 2;
constexpr double greatest_raised_share = 0.2;
// Share of the work until starts are ranked on few samples.
constexpr double ranked_share = 0.4;

double length(const LevelLine& line, const PartSamples& samples)
{
    double sum = 0;
    const auto point = [&](std::size_t k) {
        return samples.near_place(line.places[k]).point;
    };
    for (std::size_t k = 0; k + 1 < line.places.size(); ++k)
        sum += (point(k + 1) - point(k)).norm();
    if (line.is_closed)
        sum += (point(0) - point(line.places.size() - 1)).norm();
    return sum;
}

// What a pass costs beyond its length, in widths of a strip: it needs a link. A pass shorter
// than a strip is wide is often left out later.
constexpr double pass_price = 1;
constexpr double short_pass_price = 0.5;

double cost(std::span<const LevelLine> lines, const PartSamples& samples, double width)
{
    double sum = 0;
    for (const LevelLine& line : lines) {
        const double own = length(line, samples);
        sum += own + (own < width ? short_pass_price : pass_price) * width;
    }
    return sum;
}

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
    double cost;
};

Trial trial(const PartSamples& samples, const MarchStart& start, const BallCutter& cutter,
            double height, int bending_rounds)
{
    Coverage coverage{samples, cutter, layout_share * height};
    std::vector<LevelLine> lines =
        lay_lines(coverage, start, slack_share * height, bending_rounds);
    const double sum = cost(lines, samples, strip_width(cutter, height));
    return {std::move(lines), sum};
}

// A start and what it costs on few samples.
struct RankedStart {
    MarchStart start;
    double cost;
};

std::vector<RankedStart> ranked(const std::vector<MarchStart>& starts,
                                const PartSamples& samples, const BallCutter& cutter,
                                double height, ShareCounter& counter)
{
    std::vector<RankedStart> ranked(starts.size());
    parallel_for(starts.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            ranked[k] = {starts[k],
                         trial(samples, starts[k], cutter, height, few_rounds).cost};
            counter.finish_item();
        }
    });
    std::stable_sort(
        ranked.begin(), ranked.end(),
        [](const RankedStart& a, const RankedStart& b) { return a.cost < b.cost; });
    return ranked;
}

// Samples for the choice of the start, and the scallop height for which they are dense enough.
struct FewSamples {
    PartSamples samples;
    double height;  // mm
};

FewSamples few_samples(const CoveredPart& part, const BallCutter& cutter,
                       const StrategyOptions& options)
{
    const std::size_t most = std::min(most_few_samples, options.most_samples);
    double height = options.scallop_height;
    for (; raising_factor * height < greatest_raised_share * cutter.radius();
         height *= raising_factor)
        try {
            return {part.samples(strip_width(cutter, height) / few_samples_across, most),
                    height};
        } catch (const LimitError&) {
            continue;
        }
    return {part.samples(strip_width(cutter, height) / few_samples_across,
                         options.most_samples),
            height};
}

// The starts that cost least on few samples, the best one first. Sections in other places
// are tried in the best directions only.
std::vector<MarchStart> best_starts(const FewSamples& few, const BallCutter& cutter,
                                    const StrategyOptions& options)
{
    const auto& [samples, height] = few;
    const std::vector<MarchStart> starts = march_starts(samples);
    ShareCounter counter{options.progress, 0, ranked_share,
                         starts.size() + 2 * finalists};
    std::vector<RankedStart> known = ranked(starts, samples, cutter, height, counter);
    std::vector<MarchStart> further;
    std::size_t directions = 0;
    for (const RankedStart& candidate : known)
        if (const auto* line = std::get_if<LineStart>(&candidate.start);
            line && directions < finalists) {
            ++directions;
            for (const double share : {0.25, 0.75})
                further.push_back(LineStart{line->angle, share});
        }
    for (const RankedStart& candidate : ranked(further, samples, cutter, height, counter))
        known.push_back(candidate);
    std::stable_sort(
        known.begin(), known.end(),
        [](const RankedStart& a, const RankedStart& b) { return a.cost < b.cost; });
    std::vector<MarchStart> best;
    for (std::size_t k = 0; k < std::min(finalists, known.size()); ++k)
        best.push_back(known[k].start);
    return best;
}

}  // namespace

LaidPasses iso_scallop_passes(const CoveredPart& part, const BallCutter& cutter,
                              const StrategyOptions& options)
{
    const double height = options.scallop_height;
    const double width = strip_width(cutter, height);
    std::vector<MarchStart> starts =
        best_starts(few_samples(part, cutter, options), cutter, options);
    PartSamples samples = part.samples(width / samples_across, options.most_samples);
    if (samples.size() > many_samples)
        starts.resize(1);
    std::vector<Trial> trials(starts.size());
    ShareCounter counter{options.progress, ranked_share, 1, starts.size()};
    parallel_for(starts.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            trials[k] = trial(samples, starts[k], cutter, height, rounds);
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
