// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/verified_strips.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/core/tolerance.h"
#include "endmill/planning/detail/cover_front.h"
#include "endmill/planning/detail/segment_distance.h"

// How the passes over one surface come about:
// 1. Passes are laid one after the other, as far apart as CoverFront computes for rolling
//    balls. The points of the front between two passes become demands on both.
// 2. The passes are divided into straight steps in batches, in parallel (verified_pass).
// 3. Where the ball fits nowhere on a pass, passes near the limit of where it fits
//    replace it.
// 4. StripCover tests the strips between neighbouring passes. In an uncovered strip, the
//    step beside the uncovered place is halved if a rolling ball would reach the place,
//    and the strip is tested again.
// 5. Strips that remain uncovered get further passes, if a ball fits in them.
// 6. What is still uncovered is reported.

namespace endmill {
namespace {

// Share of the scallop height at which passes are laid. The rest is a margin for the
// error of sampling; it makes intervals a two thousandth narrower.
constexpr double planned_share = 0.999;
// Greatest scallop height at which passes are laid, as a share of the radius. The
// interval is almost that of a scallop of R, and a margin for the error of sampling
// remains.
constexpr double widest_share = 0.98;
// Least interval between passes, in widths of a patch. Where it is too wide, more stock
// remains.
constexpr double least_interval = 1e-3;
// Number of passes that are divided into steps at the same time. It does not depend on
// the number of threads, and so neither does the result.
constexpr int batch = 32;
// Most rounds of halving steps beside uncovered strips.
constexpr int most_rounds = 64;
// Most halvings of an interval by further passes: down to an eighth.
constexpr int most_splits = 3;
// Share of the progress on a batch of passes that is reported while they are laid; the
// rest is reported while they are divided into steps.
constexpr double laying_share = 0.5;
// Bisections of the interval in which the ball ceases to fit.
constexpr int limit_bisections = 6;
// Places on a step at which a rolling ball is tested, to see whether halving the step may
// help.
constexpr int rolling_samples = 33;

// Plans the passes over one surface.
class StripPlanner {
public:
    StripPlanner(const MarchedSurface& marched, const ClearMoves& clear,
                 const VerifiedOptions& options)
        : marched_{marched},
          options_{options},
          total_height_{std::min(options.scallop_height + options.tolerances.outer,
                                 clear.cutter().radius())},
          bounds_{marched.surface},
          line_cover_{marched, bounds_, clear.cutter(), options.tolerances.outer},
          strip_cover_{marched, bounds_, clear.cutter(), total_height_},
          front_{marched, clear.cutter(),
                 planned_share * std::min(options.scallop_height,
                                          widest_share * clear.cutter().radius()),
                 options.direction, contact_offsets(options.tolerances).front()},
          surface_{marched,
                   clear,
                   line_cover_,
                   options.tolerances,
                   options.direction,
                   options.patch_borders,
                   options.most_points,
                   contact_offsets(options.tolerances)}
    {
    }

    VerifiedStrips plan()
    {
        std::optional<double> v = marched_.surface.range(Parameter::V).low;
        while (v) {
            v = lay_passes(*v);
            cut_passes();
            laid_.clear();
        }
        drop_empty_passes();
        cover_strips();
        return {std::move(passes_), std::move(uncovered_)};
    }

private:
    using Clock = std::chrono::steady_clock;

    // A pass that is not yet divided into steps, with the points that it must reach.
    struct LaidPass {
        double v;
        std::vector<CoverDemand> demands;
    };

    double end() const { return marched_.surface.range(Parameter::V).high; }

    // Lays a batch of passes from `v` on. Returns the parameter of the pass after them,
    // if there is one.
    std::optional<double> lay_passes(double v)
    {
        while (true) {
            const PassSamples samples = front_.samples(v);
            LaidPass pass{v, {}};
            demand(previous_front_, samples, pass);
            previous_front_.clear();
            if (v >= end()) {
                laid_.push_back(sorted(std::move(pass)));
                return std::nullopt;
            }
            previous_front_ = front_.front(samples, interval_guess(v));
            const double next = snapped(v, front_.next_pass(v, previous_front_));
            std::erase_if(previous_front_,
                          [&](const FrontPoint& f) { return f.contact.v >= next; });
            for (const FrontPoint& front : previous_front_)
                pass.demands.push_back({front.foot_u, raised(front.contact)});
            laid_.push_back(sorted(std::move(pass)));
            report_passes(laying_share, next);
            interval_ = next - v;
            v = next;
            if (laid_.size() == batch)
                return v;
        }
    }

    // Adds the points of `front`, that of the pass before, to the demands on `pass`.
    void demand(std::span<const FrontPoint> front, const PassSamples& samples,
                LaidPass& pass) const
    {
        for (const FrontPoint& point : front) {
            const auto start = std::ranges::lower_bound(samples.u, point.contact.u);
            const double foot =
                CoverFront::foot(samples, raised(point.contact),
                                 std::min<std::size_t>(start - samples.u.begin(),
                                                       samples.u.size() - 1))
                    .u;
            pass.demands.push_back({foot, raised(point.contact)});
        }
    }

    // The pass with its demands in the order of their feet.
    static LaidPass sorted(LaidPass pass)
    {
        std::ranges::stable_sort(pass.demands, {}, &CoverDemand::foot_u);
        return pass;
    }

    // The point at the greatest allowed height above a contact.
    Vec3 raised(const SurfaceContact& contact) const
    {
        return contact.contact.point + total_height_ * contact.contact.normal;
    }

    // First step of the search for the front, in v.
    double interval_guess(double v) const
    {
        return interval_ > 0 ? interval_ / 2
                             : marched_.surface.patch_width(Parameter::V, v) / 32;
    }

    // `next`, at least one least interval after `v`, and moved to the border if close to
    // it.
    double snapped(double v, double next) const
    {
        const double width = marched_.surface.patch_width(Parameter::V, v);
        next = std::max(next, v + least_interval * width);
        return next > end() - end_width * width ? end() : next;
    }

    // Divides the laid passes into steps.
    void cut_passes()
    {
        const std::size_t first = passes_.size();
        passes_.resize(first + laid_.size());
        std::atomic<double> done = 0;  // passes
        const auto advance = [&](double share) {
            const double before = done.fetch_add(share);
            const double divided = (before + share) / static_cast<double>(laid_.size());
            report_passes(std::lerp(laying_share, 1.0, divided), laid_.back().v);
        };
        parallel_for(laid_.size(), [&](std::size_t begin, std::size_t stop) {
            for (std::size_t k = begin; k < stop; ++k)
                passes_[first + k] =
                    verified_pass(surface_, laid_[k].v, laid_[k].demands, advance);
        });
        for (std::size_t k = first; k < passes_.size(); ++k)
            count_points(passes_[k]);
    }

    // Reports that a share of the work on the laid passes up to `last` is done.
    void report_passes(double share, double last) const
    {
        if (!options_.progress)
            return;
        const auto [low, high] = marched_.surface.range(Parameter::V);
        const double v = std::lerp(laid_.front().v, last, share);
        options_.progress((v - low) / (high - low));
    }

    // Reports that a share of the strips is tested. The time of the strips is not
    // proportional to that of the passes. Therefore the reported share is the time
    // since the start, divided by the time that all strips need at the present rate.
    void report_strips(double share, Clock::time_point strips_start) const
    {
        if (!options_.progress)
            return;
        const std::chrono::duration<double> for_passes = strips_start - start_;
        const std::chrono::duration<double> for_strips = Clock::now() - strips_start;
        options_.progress((for_passes + for_strips) / (for_passes + for_strips / share));
    }

    void count_points(const VerifiedPass& pass)
    {
        for (const Pass& piece : pass.pieces)
            points_ += piece.size();
        if (points_ > options_.most_points)
            throw LimitError{"the path has more than " +
                             std::to_string(options_.most_points) + " points, the limit"};
    }

    // Removes the passes on which the ball fits nowhere. In their place come passes as
    // close to them as the ball fits, one on each side.
    void drop_empty_passes()
    {
        std::vector<VerifiedPass> kept;
        for (std::size_t k = 0; k < passes_.size(); ++k) {
            if (!passes_[k].pieces.empty()) {
                kept.push_back(std::move(passes_[k]));
                continue;
            }
            const double v = passes_[k].v;
            if (!kept.empty() && k > 0 && kept.back().v == passes_[k - 1].v)
                keep_if_any(last_fitting(kept.back().v, v), kept);
            if (k + 1 < passes_.size() && !passes_[k + 1].pieces.empty())
                keep_if_any(last_fitting(passes_[k + 1].v, v), kept);
        }
        passes_ = std::move(kept);
    }

    static void keep_if_any(VerifiedPass pass, std::vector<VerifiedPass>& kept)
    {
        if (!pass.pieces.empty())
            kept.push_back(std::move(pass));
    }

    // The pass nearest to `bad` on which the ball fits, between `bad` where it does not
    // and `good` where it does. Empty if bisection finds none.
    VerifiedPass last_fitting(double good, double bad) const
    {
        VerifiedPass best;
        for (int k = 0; k < limit_bisections; ++k) {
            VerifiedPass pass = verified_pass(surface_, (good + bad) / 2, {});
            if (pass.pieces.empty()) {
                bad = pass.v;
            } else {
                good = pass.v;
                best = std::move(pass);
            }
        }
        return best;
    }

    std::optional<SurfacePoint> uncovered_between(Interval v, const VerifiedPass& below,
                                                  const VerifiedPass& above) const
    {
        return strip_cover_.find_uncovered(v, swept(below, surface_.cutter()),
                                           swept(above, surface_.cutter()));
    }

    // Makes the strips covered as far as possible, and notes the places that are not.
    void cover_strips()
    {
        if (passes_.empty())
            return;
        mend_steps();
        const auto [low, high] = marched_.surface.range(Parameter::V);
        std::vector<VerifiedPass> passes = std::exchange(passes_, {});
        if (passes.front().v > low)
            note(uncovered_between({low, passes.front().v}, {}, passes.front()));
        for (std::size_t k = 0; k + 1 < passes.size(); ++k) {
            passes_.push_back(passes[k]);
            if (open_[k])
                lay_between(passes[k], passes[k + 1], most_splits);
        }
        passes_.push_back(passes.back());
        if (passes.back().v < high)
            note(uncovered_between({passes.back().v, high}, passes.back(), {}));
    }

    // Halves steps beside uncovered strips until no step is worth halving. Leaves in
    // open_ the strips that are still uncovered.
    void mend_steps()
    {
        open_.assign(passes_.size(), std::nullopt);
        std::vector<char> is_due(passes_.size(),
                                 1);  // whether to test the strip above a pass
        const Clock::time_point strips_start = Clock::now();
        std::atomic<std::size_t> tested = 0;  // strips of the first round
        for (int round = 0; round < most_rounds; ++round) {
            parallel_for(passes_.size() - 1, [&](std::size_t begin, std::size_t stop) {
                for (std::size_t k = begin; k < stop; ++k) {
                    if (is_due[k] == 0)
                        continue;
                    open_[k] = uncovered_between({passes_[k].v, passes_[k + 1].v},
                                                 passes_[k], passes_[k + 1]);
                    if (round == 0)
                        report_strips(double(++tested) / double(passes_.size() - 1),
                                      strips_start);
                }
            });
            is_due = mend_beside_open();
            if (std::ranges::count(is_due, 1) == 0)
                return;
        }
    }

    // Tries to mend both passes beside each open strip. Returns the strips beside a
    // changed pass.
    std::vector<char> mend_beside_open()
    {
        std::vector<char> is_due(passes_.size(), 0);
        for (std::size_t k = 0; k + 1 < passes_.size(); ++k)
            for (const std::size_t pass : {k, k + 1})
                if (open_[k] && mend(passes_[pass], *open_[k]))
                    is_due[pass] = is_due[pass == 0 ? 0 : pass - 1] = 1;
        return is_due;
    }

    // The centre of a ball that rolls at the greatest offset over the surface.
    Vec3 rolling_centre(const SurfaceContact& contact) const
    {
        return ball_centre(offset_contact(contact, surface_.offsets.front()),
                           surface_.cutter());
    }

    // Halves the step beside `place` if a ball that rolls along the step would cover the
    // place. Returns whether the step was halved.
    bool mend(VerifiedPass& pass, const SurfacePoint& place) const
    {
        const SweptPass moves = swept(pass, surface_.cutter());
        const Vec3 point = raised(contact_at(marched_, place, options_.direction));
        const auto distance = [&](const SweptSegment& move) {
            return segment_distance(point, move.start, move.end);
        };
        const auto nearest = std::ranges::min_element(moves, {}, distance);
        const ContactLine line{marched_, pass.v, options_.direction};
        for (int k = 0; k < rolling_samples; ++k) {
            const double u = std::lerp(nearest->from_u, nearest->to_u,
                                       k / double(rolling_samples - 1));
            const Vec3 centre = rolling_centre(line.at(u));
            if ((centre - point).norm() <= surface_.cutter().radius())
                return halve_step(pass, nearest - moves.begin(), surface_);
        }
        return false;
    }

    // Inserts passes between two that leave their strip uncovered, if a ball fits at the
    // uncovered place. Otherwise the place is noted.
    void lay_between(const VerifiedPass& below, const VerifiedPass& above, int splits)
    {
        const auto place = uncovered_between({below.v, above.v}, below, above);
        if (!place)
            return;
        const Vec3 centre =
            rolling_centre(contact_at(marched_, *place, options_.direction));
        FinerPieces finer;
        if (!surface_.clear.is_clear({centre, centre}, finer) || splits == 0)
            return note(place);
        const VerifiedPass middle = verified_pass(surface_, (below.v + above.v) / 2, {});
        if (middle.pieces.empty())
            return note(place);
        count_points(middle);
        lay_between(below, middle, splits - 1);
        passes_.push_back(middle);
        lay_between(middle, above, splits - 1);
    }

    void note(const std::optional<SurfacePoint>& place)
    {
        if (place)
            uncovered_.push_back(*place);
    }

    const MarchedSurface& marched_;
    const VerifiedOptions& options_;
    Clock::time_point start_ = Clock::now();  // for the progress only
    double total_height_;
    OffsetBounds bounds_;
    StripCover line_cover_;
    StripCover strip_cover_;
    CoverFront front_;
    VerifiedSurface surface_;
    std::vector<FrontPoint> previous_front_;  // front of the pass laid last
    double interval_ = 0;  // between the passes laid last, in v; 0 at first
    std::vector<LaidPass> laid_;
    std::vector<VerifiedPass> passes_;
    // An uncovered place in the strip above each pass, if there is one.
    std::vector<std::optional<SurfacePoint>> open_;
    std::vector<SurfacePoint> uncovered_;
    std::size_t points_ = 0;
};

}  // namespace

VerifiedStrips verified_strips(const MarchedSurface& marched, const ClearMoves& clear,
                               const VerifiedOptions& options)
{
    return StripPlanner{marched, clear, options}.plan();
}

}  // namespace endmill
