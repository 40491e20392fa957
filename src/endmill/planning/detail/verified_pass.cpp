// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/verified_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/tolerance.h"
#include "endmill/planning/detail/segment_distance.h"

// A pass is built step by step:
// 1. The first contact of a piece is the first place at which the ball fits.
// 2. The longest step from a contact is searched in two stages. The first considers only
//    the line of the pass: a quick sampled gouge test, the demands, and the outer
//    tolerance. If the complete gouge test also accepts this step, it is taken.
// 3. Otherwise the part beside the pass limits the step, and a second search includes the
//    complete test. It starts at the same share of the first result as in the step
//    before.
// 4. A search first multiplies or divides the step by a growing factor until it has one
//    sound and one unsound step, then halves the difference.
// 5. Where no step is possible the piece ends, and the scan for a place where the ball
//    fits continues.
// 6. With a one-sided tolerance a contact has one of two offsets. A piece starts at the
//    higher one, where the ball fits if it does at all. Each step is searched for both
//    offsets of its end, and the longer one is taken.

namespace endmill {
namespace {

// Shortest step, in widths of a patch.
constexpr double least_step = 1e-4;
// Accuracy of the longest step, as a share of it.
constexpr double step_precision = 1e-3;
// First factor of the search for a step that is too long, and the greatest. The factor is
// squared each time, because neighbouring steps are usually almost equal.
constexpr double least_growth = 1.04;
constexpr double most_growth = 2;
// Intervals of a step in the quick gouge test.
constexpr int line_samples = 8;
// First trial step of a piece, in widths of a patch.
constexpr double first_step = 1.0 / 16;
// Spacing of the scan for a place where the ball fits, in widths of a patch.
constexpr double gap_scan = 1.0 / 256;
// Accuracy of that place, as a share of the spacing.
constexpr double gap_precision = 1.0 / 64;

// Least share of a pass that is reported as progress.
constexpr double reported_share = 1.0 / 256;

// Builds one pass.
class PassBuilder {
public:
    PassBuilder(const VerifiedSurface& surface, double v,
                std::span<const CoverDemand> demands,
                const std::function<void(double)>& advance)
        : surface_{surface},
          line_{surface.marched, v, surface.direction},
          demands_{demands},
          advance_{advance},
          reported_u_{line_.range().low}
    {
    }

    VerifiedPass build()
    {
        VerifiedPass pass{line_.v(), {}};
        const double end = line_.range().high;
        if (line_.is_point()) {
            const SurfaceContact contact = first_at(line_.range().low);
            if (fits(contact))
                pass.pieces.push_back({contact});
            if (advance_)
                advance_(1);
            return pass;
        }
        std::optional<double> u = fitting_from(line_.range().low);
        while (u) {
            Pass piece = piece_from(*u);
            const double last = piece.back().u;
            pass.pieces.push_back(std::move(piece));
            u = last < end ? fitting_from(last + least_step * width(last)) : std::nullopt;
        }
        report(end);
        return pass;
    }

private:
    double width(double u) const
    {
        return surface_.marched.surface.patch_width(Parameter::U, u);
    }

    // The contact at which a piece starts.
    SurfaceContact first_at(double u) const
    {
        return offset_contact(line_.at(u), surface_.offsets.front());
    }

    bool fits(const SurfaceContact& contact) { return is_clear(contact, contact); }

    bool is_clear(const SurfaceContact& from, const SurfaceContact& to)
    {
        return surface_.clear.is_clear(
            {ball_centre(from, surface_.cutter()), ball_centre(to, surface_.cutter())},
            finer_);
    }

    // The first parameter from `u` on at which the ball fits. Places narrower than the
    // scan may be missed.
    std::optional<double> fitting_from(double u)
    {
        const double end = line_.range().high;
        if (u >= end)
            return std::nullopt;
        if (fits(first_at(u)))
            return u;
        while (u < end) {
            const double scan = gap_scan * width(u);
            double next = std::min(end, u + scan);
            if (!fits(first_at(next))) {
                u = next;
                continue;
            }
            while (next - u > gap_precision * scan) {
                const double middle = (u + next) / 2;
                (fits(first_at(middle)) ? next : u) = middle;
            }
            return next;
        }
        return std::nullopt;
    }

    // The longest piece that starts at `u`, where the ball fits.
    Pass piece_from(double u)
    {
        Pass piece{first_at(u)};
        double guess = first_step * width(u);
        while (const auto next = longest_step(piece.back(), guess)) {
            guess = next->u - piece.back().u;
            piece.push_back(*next);
            if (++points_ > surface_.most_points)
                throw LimitError{"a pass has more than " +
                                 std::to_string(surface_.most_points) +
                                 " points, the limit"};
            report(next->u);
        }
        return piece;
    }

    // Reports that the pass is built up to `u`, if that is enough to report.
    void report(double u)
    {
        const auto [low, high] = line_.range();
        const double share = (u - reported_u_) / (high - low);
        if (!advance_ || (share < reported_share && u < high))
            return;
        advance_(share);
        reported_u_ = u;
    }

    // The greatest parameter to which a step from `u` may lead.
    double farthest(double u) const
    {
        const double end = line_.range().high;
        if (surface_.patch_borders == PatchBorders::Cross)
            return end;
        const auto breaks = surface_.marched.surface.breaks(Parameter::U);
        return *std::ranges::upper_bound(breaks.first(breaks.size() - 1), u);
    }

    // The longest step over all offsets of its end; of equally long ones that to the
    // higher end.
    std::optional<SurfaceContact> longest_step(const SurfaceContact& from, double guess)
    {
        std::optional<SurfaceContact> best;
        for (const double offset : surface_.offsets)
            if (const auto found = longest_step(from, offset, guess);
                found && (!best || found->u > best->u))
                best = found;
        return best;
    }

    std::optional<SurfaceContact> longest_step(const SurfaceContact& from, double offset,
                                               double guess)
    {
        const double most = farthest(from.u);
        if (from.u >= most)
            return std::nullopt;
        const double least = std::min(least_step * width(from.u), most - from.u);
        auto beside_line =
            longest(from, offset, {least, std::max(guess, least), most},
                    [&](const SurfaceContact& to) { return keeps_line(from, to); });
        if (!beside_line || is_clear(from, *beside_line))
            return beside_line;
        // The part beside the pass limits the step. The guess is its share in the step
        // before.
        const double limit = beside_line->u - from.u;
        auto clear = longest(from, offset,
                             {least, std::max(share_ * limit, least), beside_line->u},
                             [&](const SurfaceContact& to) {
                                 return keeps_line(from, to) && is_clear(from, to);
                             });
        if (clear)
            share_ = (clear->u - from.u) / limit;
        return clear;
    }

    // The steps in u among which to search.
    struct StepRange {
        double least;
        double guess;
        double most_u;  // parameter at which the longest step ends
    };

    // The longest sound step to a contact of this offset. It is assumed that a step
    // shorter than a sound one is sound; the returned step is tested in any case.
    template <class IsSound>
    std::optional<SurfaceContact> longest(const SurfaceContact& from, double offset,
                                          const StepRange& range,
                                          const IsSound& is_sound) const
    {
        const auto& [least, guess, most] = range;
        std::optional<SurfaceContact> best;
        std::optional<double> too_far;
        double step = guess;
        double growth = least_growth;
        while (!too_far || !best) {
            const SurfaceContact to =
                offset_contact(line_.at(std::min(from.u + step, most)), offset);
            if (is_sound(to)) {
                best = to;
                if (to.u == most)
                    return best;
                step *= growth;
            } else {
                too_far = to.u;
                if (step <= least)
                    return best;
                step = std::max(least, std::min(step, to.u - from.u) / growth);
            }
            growth = std::min(growth * growth, most_growth);
        }
        while (*too_far - best->u > step_precision * (best->u - from.u)) {
            const SurfaceContact to =
                offset_contact(line_.at((best->u + *too_far) / 2), offset);
            if (is_sound(to))
                best = to;
            else
                too_far = to.u;
        }
        return best;
    }

    // Whether a step is sound as far as the line of the pass is concerned. The gouge test
    // here is sampled; it rejects many unsound steps before the complete test, at low
    // cost.
    bool keeps_line(const SurfaceContact& from, const SurfaceContact& to) const
    {
        const SweptSegment move{from.u, to.u, ball_centre(from, surface_.cutter()),
                                ball_centre(to, surface_.cutter())};
        return !gouges_line(move) && reaches_demands(move) &&
               surface_.line_cover.covers_line(move, line_.v());
    }

    bool gouges_line(const SweptSegment& move) const
    {
        const double least = surface_.cutter().radius() - surface_.tolerances.inner;
        for (int k = 1; k < line_samples; ++k) {
            const double u = std::lerp(move.from_u, move.to_u, k / double(line_samples));
            if (segment_distance(line_.point(u), move.start, move.end) < least)
                return true;
        }
        return false;
    }

    bool reaches_demands(const SweptSegment& move) const
    {
        const double reach = surface_.cutter().radius() * (1 + radius_rounding_share);
        auto demand =
            std::ranges::lower_bound(demands_, move.from_u, {}, &CoverDemand::foot_u);
        for (; demand != demands_.end() && demand->foot_u <= move.to_u; ++demand)
            if (segment_distance(demand->point, move.start, move.end) > reach)
                return false;
        return true;
    }

    const VerifiedSurface& surface_;
    ContactLine line_;
    std::span<const CoverDemand> demands_;
    FinerPieces finer_;
    // Length of the last limited step, as a share of the step that its line alone would
    // allow.
    double share_ = 1;
    std::size_t points_ = 1;
    const std::function<void(double)>& advance_;
    double reported_u_;
};

// Whether the moves from one contact to the next but one keep the tolerances.
bool keep_tolerances(const std::array<SurfaceContact, 3>& contacts, double v,
                     const VerifiedSurface& surface)
{
    FinerPieces finer;
    for (const std::size_t k : {0, 1}) {
        const SweptSegment half{contacts[k].u, contacts[k + 1].u,
                                ball_centre(contacts[k], surface.cutter()),
                                ball_centre(contacts[k + 1], surface.cutter())};
        if (!surface.clear.is_clear({half.start, half.end}, finer) ||
            !surface.line_cover.covers_line(half, v))
            return false;
    }
    return true;
}

}  // namespace

std::vector<double> contact_offsets(const MotionTolerances& tolerances)
{
    if (!tolerances.is_one_sided())
        return {0};
    const double margin = offset_margin * (tolerances.inner + tolerances.outer);
    return {tolerances.outer - margin, margin - tolerances.inner};
}

VerifiedPass verified_pass(const VerifiedSurface& surface, double v,
                           std::span<const CoverDemand> demands,
                           const std::function<void(double)>& advance)
{
    return PassBuilder{surface, v, demands, advance}.build();
}

SweptPass swept(const VerifiedPass& pass, const BallCutter& cutter)
{
    SweptPass moves;
    for (const Pass& piece : pass.pieces) {
        if (piece.size() == 1) {
            const Vec3 centre = ball_centre(piece.front(), cutter);
            moves.push_back({piece.front().u, piece.front().u, centre, centre});
        }
        for (std::size_t k = 1; k < piece.size(); ++k)
            moves.push_back({piece[k - 1].u, piece[k].u,
                             ball_centre(piece[k - 1], cutter),
                             ball_centre(piece[k], cutter)});
    }
    return moves;
}

bool halve_step(VerifiedPass& pass, std::size_t step, const VerifiedSurface& surface)
{
    for (Pass& piece : pass.pieces) {
        const std::size_t steps = std::max<std::size_t>(piece.size() - 1, 1);
        if (step >= steps) {
            step -= steps;
            continue;
        }
        if (piece.size() == 1)
            return false;
        const SurfaceContact& from = piece[step];
        const SurfaceContact& to = piece[step + 1];
        const double middle = (from.u + to.u) / 2;
        if (!(from.u +
                  least_step * surface.marched.surface.patch_width(Parameter::U, from.u) <
              middle))
            return false;
        const SurfaceContact on_line =
            ContactLine{surface.marched, pass.v, surface.direction}.at(middle);
        // The lowest contact that keeps the tolerances removes the most material.
        for (auto offset = surface.offsets.rbegin(); offset != surface.offsets.rend();
             ++offset) {
            const SurfaceContact contact = offset_contact(on_line, *offset);
            if (!keep_tolerances({from, contact, to}, pass.v, surface))
                continue;
            piece.insert(piece.begin() + static_cast<std::ptrdiff_t>(step) + 1, contact);
            return true;
        }
        return false;
    }
    return false;
}

}  // namespace endmill
