// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/covering_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/planning/detail/piece_order.h"
#include "endmill/strategy/detail/coverage.h"
#include "endmill/strategy/detail/pass_moves.h"

namespace endmill {
namespace {

// Share of the scallop height by which moves may miss what the rolling balls cover.
constexpr double move_share = 0.015;
// Rounds in which passes are bent towards places that their moves miss.
constexpr int mending_rounds = 10;

// All passes divided into moves, in their order.
std::vector<LaidPass> divided(std::span<const LaidPass> passes,
                              const PartSamples& samples, const CoveredPart& part,
                              double height)
{
    const MoveLimits limits{layout_share * height, move_share * height};
    std::vector<std::vector<LaidPass>> parts(passes.size());
    parallel_for(passes.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            parts[k] = divided_into_moves(passes[k], samples, part, limits);
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
                worst = {samples.contact({i, i, 0}), gap};
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
        const PassContact& aim = place.at;
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
        PassContact bent = samples.between(from, aim, share);
        bent.is_required = true;
        contacts.insert(
            contacts.begin() + static_cast<std::ptrdiff_t>(nearest.contact) + 1, bent);
    }
}

}  // namespace

CoveringPath covering_path(LaidPasses laid, const CoveredPart& part,
                           const BallCutter& cutter, const StrategyOptions& options)
{
    const double height = options.scallop_height;
    std::vector<LaidPass> pieces;
    std::vector<UncoveredTriangle> uncovered;
    for (int round = 0;; ++round) {
        pieces = divided(laid.passes, laid.samples, part, height);
        uncovered = uncovered_by(pieces, laid.samples, cutter, height);
        if (uncovered.empty() || round == mending_rounds)
            break;
        if (options.progress)
            options.progress((round + 1.0) / mending_rounds);
        bend_passes(laid.passes, uncovered, laid.samples, cutter, height, 1.5 + round);
    }

    CoveringPath plan;
    plan.passes = laid.passes.size();
    plan.pieces = pieces.size();
    plan.unreached_mm2 = laid.samples.unwanted_area();
    // a lift by t takes t cos(a) from the reach of the points around a contact
    plan.stray_mm =
        std::max(options.inner_tolerance,
                 move_share * height * cutter.radius() / (cutter.radius() - height));
    for (const auto& [area, place] : uncovered) {
        plan.uncovered_mm2 += area;
        plan.uncovered.push_back({place.at.surface,
                                  {place.at.at.u, place.at.at.v},
                                  place.at.at.contact.point});
    }
    const auto is_clear = [&](const SurfaceContact& from, const SurfaceContact& to) {
        MoveTestState state;
        return part.is_clear(ball_centre(from, cutter), ball_centre(to, cutter), state);
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
