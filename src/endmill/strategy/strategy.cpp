// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/strategy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/core/tolerance.h"
#include "endmill/strategy/detail/front_march.h"
#include "endmill/strategy/detail/pass_moves.h"
#include "endmill/strategy/detail/starts.h"
#include "endmill/surface/tool_side.h"

// The steps of plan_iso_scallop:
// 1. The part is sampled; the samples carry normals.
// 2. From each start, FrontMarch lays passes until all samples are covered.
// 3. The passes of the shortest result are divided into moves.
// 4. The pieces are ordered and linked.

namespace endmill {
namespace {

// Share of the scallop height at which passes are laid out. The rest is for what lies
// between samples and for the chords of moves.
constexpr double layout_share = 0.96;
// Share of it by which a sample may miss its cover.
constexpr double slack_share = 0.01;
// Share of it by which moves may miss what the rolling balls cover.
constexpr double move_share = 0.02;
// Samples across a strip for the choice of the start, and for the result.
constexpr double few_samples_across = 4;
constexpr double samples_across = 8;
// Rounds in which a pass is bent, for the choice and for the result.
constexpr int few_rounds = 1;
constexpr int rounds = 6;
// Starts that are tried with many samples.
constexpr std::size_t finalists = 3;
// Memory of a sample with its triangles and coverage, bytes.
constexpr std::size_t bytes_per_sample = 400;

// Width of a strip on a plane, mm.
double strip_width(const BallCutter& cutter, double height)
{
    return 2 * std::sqrt(height * (2 * cutter.radius() - height));
}

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

struct Trial {
    std::vector<LaidPass> passes;
    double cost;
};

Trial trial(const PartSamples& samples, const MarchStart& start, const BallCutter& cutter,
            double height, int bending_rounds)
{
    Coverage coverage{samples, cutter, layout_share * height};
    std::vector<LaidPass> passes = lay_passes(coverage, start, slack_share * height, bending_rounds);
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
                                double height)
{
    std::vector<RankedStart> ranked(starts.size());
    parallel_for(starts.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            ranked[k] = {starts[k],
                         trial(samples, starts[k], cutter, height, few_rounds).cost};
    });
    std::stable_sort(
        ranked.begin(), ranked.end(),
        [](const RankedStart& a, const RankedStart& b) { return a.cost < b.cost; });
    return ranked;
}

// The starts that cost least on few samples, the best one first. Sections in other places
// are tried in the best directions only.
std::vector<MarchStart> best_starts(const PartSamples& samples, const BallCutter& cutter,
                                    double height)
{
    std::vector<RankedStart> known = ranked(march_starts(samples), samples, cutter, height);
    std::vector<MarchStart> further;
    std::size_t directions = 0;
    for (const RankedStart& candidate : known)
        if (const auto* line = std::get_if<LineStart>(&candidate.start);
            line && directions < finalists) {
            ++directions;
            for (const double share : {0.25, 0.75})
                further.push_back(LineStart{line->angle, share});
        }
    for (RankedStart& candidate : ranked(further, samples, cutter, height))
        known.push_back(std::move(candidate));
    std::stable_sort(
        known.begin(), known.end(),
        [](const RankedStart& a, const RankedStart& b) { return a.cost < b.cost; });
    std::vector<MarchStart> best;
    for (std::size_t k = 0; k < std::min(finalists, known.size()); ++k)
        best.push_back(known[k].start);
    return best;
}

// Passes, and the samples on which they are laid.
struct LaidPasses {
    PartSamples samples;
    std::vector<LaidPass> passes;
};

LaidPasses best_passes(std::span<const Surface> surfaces,
                                  std::span<const double> sides, const BallCutter& cutter,
                                  const StrategyOptions& options)
{
    const double height = options.scallop_height;
    const double width = strip_width(cutter, height);
    const PartSamples few{surfaces, sides, width / few_samples_across, 20'000'000};
    const std::vector<MarchStart> starts = best_starts(few, cutter, height);
    PartSamples samples{surfaces, sides, width / samples_across, 20'000'000};
    std::vector<Trial> trials(starts.size());
    parallel_for(starts.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            trials[k] = trial(samples, starts[k], cutter, height, rounds);
    });
    const auto best =
        std::min_element(trials.begin(), trials.end(),
                         [](const Trial& a, const Trial& b) { return a.cost < b.cost; });
    return {std::move(samples), std::move(best->passes)};
}

// The nearest-neighbour order of pieces, with directions.
std::vector<PassPiece> in_cutting_order(std::vector<LaidPass> pieces)
{
    std::vector<PassPiece> ordered;
    std::vector<bool> is_done(pieces.size(), false);
    Vec3 at = Vec3::Zero();
    for (std::size_t count = 0; count < pieces.size(); ++count) {
        std::size_t best = pieces.size();
        bool is_reversed = false;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < pieces.size(); ++k) {
            if (is_done[k])
                continue;
            const Vec3& front = pieces[k].contacts.front().at.contact.point;
            const Vec3& back = pieces[k].contacts.back().at.contact.point;
            if (const double d = (front - at).squaredNorm(); d < least)
                least = d, best = k, is_reversed = false;
            if (const double d = (back - at).squaredNorm(); d < least)
                least = d, best = k, is_reversed = true;
        }
        is_done[best] = true;
        Pass contacts;
        for (const PassContact& contact : pieces[best].contacts)
            contacts.push_back(contact.at);
        if (is_reversed)
            std::reverse(contacts.begin(), contacts.end());
        at = contacts.back().contact.point;
        ordered.push_back({static_cast<int>(count), std::move(contacts)});
    }
    return ordered;
}

}  // namespace

StrategyPlan plan_iso_scallop(std::span<const Surface> surfaces, const BallCutter& cutter,
                              const StrategyOptions& options)
{
    const std::vector<double> sides = tool_side_signs(surfaces, options.link.axis);
    require_reachable(surfaces, options.link.axis, sides);
    const LaidPasses best = best_passes(surfaces, sides, cutter, options);
    const std::vector<LaidPass>& passes = best.passes;
    const ClearMoves clear{surfaces, sides, cutter, options.link.axis,
                           options.inner_tolerance};
    const MoveLimits limits{layout_share * options.scallop_height,
                            move_share * options.scallop_height};
    std::vector<std::vector<LaidPass>> divided(passes.size());
    parallel_for(passes.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            divided[k] = divided_into_moves(passes[k], best.samples, clear, limits);
    });
    std::vector<LaidPass> pieces;
    for (std::vector<LaidPass>& own : divided)
        for (LaidPass& piece : own)
            pieces.push_back(std::move(piece));
    StrategyPlan plan;
    plan.passes = pieces.size();
    const auto is_clear = [&](const SurfaceContact& from, const SurfaceContact& to) {
        FinerPieces finer;
        return clear.is_clear({ball_centre(from, cutter), ball_centre(to, cutter)}, finer);
    };
    LinkedPath linked =
        link_pieces(in_cutting_order(std::move(pieces)), cutter, options.link, is_clear);
    plan.path = std::move(linked.path);
    plan.lifted_links = linked.lifted_links;
    return plan;
}

}  // namespace endmill
