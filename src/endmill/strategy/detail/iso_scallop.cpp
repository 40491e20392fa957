// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/iso_scallop.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <utility>

#include "endmill/core/parallel.h"
#include "endmill/strategy/detail/front_march.h"
#include "endmill/strategy/detail/starts.h"

namespace endmill {
namespace {

// Share of it by which a sample may miss its cover.
constexpr double slack_share = 0.005;
// Samples across a strip for the choice of the start, and for the result.
constexpr double few_samples_across = 4;
constexpr double samples_across = 8;
// Rounds in which a pass is bent, for the choice and for the result.
constexpr int few_rounds = 1;
constexpr int rounds = 12;
// Starts that are tried with many samples.
constexpr std::size_t finalists = 3;
// Share of the work until starts are ranked on few samples.
constexpr double ranked_share = 0.4;

double length(const LaidPass& pass)
{
    double sum = 0;
    const auto point = [&](std::size_t k) { return pass.contacts[k].at.contact.point; };
    for (std::size_t k = 0; k + 1 < pass.contacts.size(); ++k)
        sum += (point(k + 1) - point(k)).norm();
    if (pass.is_closed)
        sum += (point(0) - point(pass.contacts.size() - 1)).norm();
    return sum;
}

// What a start costs: its length, and the width of a strip for each pass, which is about
// the length of a link.
double cost(std::span<const LaidPass> passes, double width)
{
    double sum = 0;
    for (const LaidPass& pass : passes)
        sum += length(pass) + width;
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
    std::vector<LaidPass> passes;
    double cost;
};

Trial trial(const PartSamples& samples, const MarchStart& start, const BallCutter& cutter,
            double height, int bending_rounds)
{
    Coverage coverage{samples, cutter, layout_share * height};
    std::vector<LaidPass> passes =
        lay_passes(coverage, start, slack_share * height, bending_rounds);
    const double sum = cost(passes, strip_width(cutter, height));
    return {std::move(passes), sum};
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

// The starts that cost least on few samples, the best one first. Sections in other places
// are tried in the best directions only.
std::vector<MarchStart> best_starts(const PartSamples& samples, const BallCutter& cutter,
                                    const StrategyOptions& options)
{
    const double height = options.scallop_height;
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
    const PartSamples few =
        part.samples(width / few_samples_across, options.most_samples);
    const std::vector<MarchStart> starts = best_starts(few, cutter, options);
    PartSamples samples = part.samples(width / samples_across, options.most_samples);
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
    return {std::move(samples), std::move(best->passes)};
}

}  // namespace endmill
