// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/strategy.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/core/tolerance.h"
#include "endmill/planning/detail/piece_order.h"
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
constexpr double layout_share = 0.97;
// Share of it by which a sample may miss its cover.
constexpr double slack_share = 0.005;
// Share of it by which moves may miss what the rolling balls cover.
constexpr double move_share = 0.015;
// Samples across a strip for the choice of the start, and for the result.
constexpr double few_samples_across = 4;
constexpr double samples_across = 8;
// Rounds in which a pass is bent, for the choice and for the result.
constexpr int few_rounds = 1;
constexpr int rounds = 12;
// Rounds in which passes are bent towards places that their moves miss.
constexpr int mending_rounds = 10;
// Starts that are tried with many samples.
constexpr std::size_t finalists = 3;
// Memory of a sample with its triangles and the coverage by several starts at once, bytes.
constexpr double bytes_per_sample = 1200;
constexpr double bytes_per_gib = 1024.0 * 1024 * 1024;
// Shares of the work: starts on few samples, starts on many, moves.
constexpr double ranked_share = 0.4;
constexpr double laid_share = 0.9;

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

// Passes, and the samples on which they are laid.
struct LaidPasses {
    PartSamples samples;
    std::vector<LaidPass> passes;
};

LaidPasses best_passes(std::span<const Surface> surfaces, std::span<const double> sides,
                       const BallCutter& cutter, const StrategyOptions& options)
{
    const double height = options.scallop_height;
    const double width = strip_width(cutter, height);
    const PartSamples few{surfaces, sides, width / few_samples_across,
                          options.most_samples};
    const std::vector<MarchStart> starts = best_starts(few, cutter, options);
    PartSamples samples{surfaces, sides, width / samples_across, options.most_samples};
    std::vector<Trial> trials(starts.size());
    ShareCounter counter{options.progress, ranked_share, laid_share, starts.size()};
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

// All passes divided into moves, in their order.
std::vector<LaidPass> divided(std::span<const LaidPass> passes,
                              const PartSamples& samples, const ClearMoves& clear,
                              double height)
{
    const MoveLimits limits{layout_share * height, move_share * height};
    std::vector<std::vector<LaidPass>> parts(passes.size());
    parallel_for(passes.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            parts[k] = divided_into_moves(passes[k], samples, clear, limits);
    });
    std::vector<LaidPass> pieces;
    for (std::vector<LaidPass>& own : parts)
        for (LaidPass& piece : own)
            pieces.push_back(std::move(piece));
    return pieces;
}

// The contacts of a piece in the order of cutting. A closed piece returns to its start.
Pass contacts_of(const LaidPass& piece, const OrderedPiece& order)
{
    Pass contacts;
    contacts.reserve(piece.contacts.size() + 1);
    for (const PassContact& contact : piece.contacts)
        contacts.push_back(contact.at);
    if (piece.is_closed) {
        std::rotate(contacts.begin(),
                    contacts.begin() + static_cast<std::ptrdiff_t>(order.start),
                    contacts.end());
        contacts.push_back(contacts.front());
    }
    if (order.is_reversed)
        std::reverse(contacts.begin(), contacts.end());
    return contacts;
}

// The pieces in an order with short links.
std::vector<PassPiece> in_cutting_order(std::span<const LaidPass> pieces,
                                        const BallCutter& cutter,
                                        const LinkOptions& options)
{
    const auto tip = [&](const PassContact& contact) {
        return locate(cutter, contact.at.contact, options.axis).tip;
    };
    std::vector<PieceEnds> ends;
    ends.reserve(pieces.size());
    for (const LaidPass& piece : pieces) {
        if (piece.is_closed) {
            ClosedPiece closed;
            for (const PassContact& contact : piece.contacts)
                closed.starts.push_back(tip(contact));
            ends.emplace_back(std::move(closed));
        } else {
            ends.emplace_back(OpenPiece{tip(piece.contacts.front()),
                                        tip(piece.contacts.back()),
                                        options.order != PassOrder::OneWay});
        }
    }
    std::vector<PassPiece> ordered;
    for (const OrderedPiece& place : order_pieces(ends).pieces)
        ordered.push_back(
            {static_cast<int>(ordered.size()), contacts_of(pieces[place.piece], place)});
    return ordered;
}

// A triangle in which a place is not covered, and the worst of the places found in it.
struct UncoveredTriangle {
    double area_mm2;
    MissedPlace worst;
};

// What the pieces leave uncovered at `height`.
std::vector<UncoveredTriangle> uncovered_by(std::span<const LaidPass> pieces,
                                            const PartSamples& samples,
                                            const BallCutter& cutter, double height)
{
    Coverage coverage{samples, cutter, height};
    for (const LaidPass& piece : pieces)
        coverage.add(piece.contacts, piece.is_closed);
    std::vector<UncoveredTriangle> found;
    for (std::size_t number = 0; number < samples.triangles().size(); ++number) {
        const Triangle& triangle = samples.triangles()[number];
        std::optional<MissedPlace> worst;
        for (const std::int32_t i : triangle)
            if (const double gap = coverage.gaps()[i];
                gap > 0 && (!worst || gap > worst->gap))
                worst = {samples.parameters(i), i, gap};
        if (!worst)
            for (const MissedPlace& place :
                 coverage.missed(std::array{static_cast<std::int32_t>(number)}, 0))
                if (!worst || place.gap > worst->gap)
                    worst = place;
        if (!worst)
            continue;
        const Vec3& a = samples.point(triangle[0]);
        const Vec3 across =
            (samples.point(triangle[1]) - a).cross(samples.point(triangle[2]) - a);
        found.push_back({across.norm() / 2, *worst});
    }
    return found;
}

// The contact of a list of passes that is nearest to a place.
struct NearestContact {
    std::size_t pass;
    std::size_t contact;
    double distance;  // mm
};

NearestContact nearest_contact(std::span<const LaidPass> passes, const Vec3& place,
                               int surface)
{
    NearestContact nearest{0, 0, std::numeric_limits<double>::infinity()};
    for (std::size_t pass = 0; pass < passes.size(); ++pass)
        for (std::size_t k = 0; k < passes[pass].contacts.size(); ++k) {
            const PassContact& contact = passes[pass].contacts[k];
            const double distance = (contact.at.contact.point - place).norm();
            if (contact.surface == surface && distance < nearest.distance)
                nearest = {pass, k, distance};
        }
    return nearest;
}

// Bends the nearest pass towards each place just so far that its ball reaches the place.
// \param excess by what factor the bend exceeds its first-order value.
void bend_passes(std::vector<LaidPass>& passes,
                 std::span<const UncoveredTriangle> uncovered, const PartSamples& samples,
                 const BallCutter& cutter, double height, double excess)
{
    // the gap decreases by about half_width / R per mm of bend
    const double half_width = strip_width(cutter, height) / 2;
    for (const auto& [area, place] : uncovered) {
        const PassContact aim = samples.contact(place.at, place.near);
        const NearestContact nearest =
            nearest_contact(passes, aim.at.contact.point, aim.surface);
        if (!(nearest.distance > 0) || nearest.distance > 2 * half_width ||
            place.gap > height)
            continue;
        std::vector<PassContact>& contacts = passes[nearest.pass].contacts;
        const PassContact& from = contacts[nearest.contact];
        if (!samples.is_joined(from, aim))
            continue;
        const double bend = excess * place.gap * cutter.radius() / half_width;
        const double share = std::min(1.0, bend / nearest.distance);
        PassContact bent = samples.contact({std::lerp(from.at.u, aim.at.u, share),
                                            std::lerp(from.at.v, aim.at.v, share)},
                                           from.near);
        bent.is_required = true;
        contacts.insert(
            contacts.begin() + static_cast<std::ptrdiff_t>(nearest.contact) + 1, bent);
    }
}

void require_sound(const BallCutter& cutter, const StrategyOptions& options)
{
    require(0 < options.inner_tolerance && options.inner_tolerance < cutter.radius(),
            "plan_iso_scallop: need 0 < inner tolerance < cutter radius");
    require(0 < options.scallop_height && options.scallop_height < cutter.radius(),
            "plan_iso_scallop: need 0 < scallop height < cutter radius");
    require((options.link.axis - Vec3::UnitZ()).norm() < unit_vector_rounding,
            "plan_iso_scallop: the axis must be +z");
}

}  // namespace

std::size_t most_part_samples(double memory_gib)
{
    return static_cast<std::size_t>(
        std::clamp(memory_gib * bytes_per_gib / bytes_per_sample, 1.0, 1e9));
}

StrategyPlan plan_iso_scallop(std::span<const Surface> surfaces, const BallCutter& cutter,
                              const StrategyOptions& options)
{
    require_sound(cutter, options);
    const double height = options.scallop_height;
    const std::vector<double> sides = tool_side_signs(surfaces, options.link.axis);
    require_reachable(surfaces, options.link.axis, sides);
    LaidPasses laid = best_passes(surfaces, sides, cutter, options);
    const ClearMoves clear{surfaces, sides, cutter, options.link.axis,
                           options.inner_tolerance};
    std::vector<LaidPass> pieces;
    std::vector<UncoveredTriangle> uncovered;
    for (int round = 0;; ++round) {
        pieces = divided(laid.passes, laid.samples, clear, height);
        uncovered = uncovered_by(pieces, laid.samples, cutter, height);
        if (uncovered.empty() || round == mending_rounds)
            break;
        if (options.progress)
            options.progress(std::lerp(laid_share, 1.0, (round + 1.0) / mending_rounds));
        bend_passes(laid.passes, uncovered, laid.samples, cutter, height, 1.5 + round);
    }

    StrategyPlan plan;
    plan.passes = laid.passes.size();
    plan.pieces = pieces.size();
    // a lift by t takes t cos(a) from the reach of the points around a contact
    plan.stray_mm =
        std::max(options.inner_tolerance,
                 move_share * height * cutter.radius() / (cutter.radius() - height));
    for (const auto& [area, place] : uncovered) {
        plan.uncovered_mm2 += area;
        plan.uncovered.push_back(
            {laid.samples.surface(place.near), place.at,
             laid.samples.contact(place.at, place.near).at.contact.point});
    }
    const auto is_clear = [&](const SurfaceContact& from, const SurfaceContact& to) {
        FinerPieces finer;
        return clear.is_clear({ball_centre(from, cutter), ball_centre(to, cutter)},
                              finer);
    };
    LinkedPath linked = link_pieces(in_cutting_order(pieces, cutter, options.link),
                                    cutter, options.link, is_clear);
    plan.path = std::move(linked.path);
    plan.lifted_links = linked.lifted_links;
    if (plan.path.points.empty())
        throw GeometryError{
            "the ball fits nowhere on the part without entering it by more "
            "than the inner tolerance"};
    return plan;
}

}  // namespace endmill
