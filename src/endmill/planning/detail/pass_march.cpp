// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/pass_march.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/core/tolerance.h"
#include "endmill/planning/detail/cross_section.h"
#include "endmill/planning/path_interval.h"
#include "endmill/planning/step_length.h"
#include "endmill/surface/detail/iso_line.h"
#include "endmill/surface/tool_side.h"

// A pass is marched as in the paper, section 4:
// 1. The first contact is the start of the line v = constant.
// 2. The curvature at a contact gives the projected length of the step, eq. (1) and (2).
//    The next contact is the first point of the line at that distance along the tangent,
//    eq. (3). An end of the line, or a border of patches, may replace it.
// 3. At each contact, the curvature across the feed, exact or by the chord of eq. (6) to
//    (8), gives the projected path interval, eq. (4) and (5). The point of the surface at that distance in the check plane, eq.
//    (9) and (10), is the neighbour of the contact on the next pass. Its v is the
//    candidate of the contact.
// 4. The rule `governing` selects one of the candidates. Where the smallest candidate is
// wanted, a contact whose neighbour is certain to lie further away than the best so far
// is abandoned early.

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// Intervals of a patch between the places of Governing::DenseMin.
constexpr int dense_samples = 16;
// Greatest distance of the unit normals at a pole that have one limit. It is far
// above the rounding error of a normal, about 1e-16.
constexpr double same_normal = 1e-9;

// Computes one pass.
class PassMarch {
public:
    PassMarch(const MarchedSurface& marched, double v, const BallCutter& cutter,
              const IsoParametricOptions& options)
        : marched_{marched},
          line_{marched.surface, v},
          cutter_{cutter},
          options_{options}
    {
    }

    MarchedPass march(PassRole role) const
    {
        const bool is_followed = role == PassRole::Followed;
        if (line_.is_point())
            return march_pole(role);
        const double end = line_.range().high;
        MarchedPass pass;
        std::vector<PassCandidate> candidates;
        double most_v = infinity;  // candidates beyond it cannot govern
        const auto add_candidate = [&](const FeedFrame& frame) {
            const auto found = candidate(frame, most_v);
            if (!found)
                return;
            candidates.push_back(*found);
            if (least_governs())
                most_v = std::min(most_v, found->v);
        };
        std::optional<double> u = line_.range().low;
        while (u) {
            const FeedFrame frame = frame_at(*u);
            pass.contacts.push_back(contact(frame));
            require_room(pass.contacts.size());
            if (is_followed)
                add_candidate(frame);
            u = *u == end ? std::nullopt : next_parameter(frame);
        }
        if (is_followed) {
            if (options_.governing == Governing::DenseMin)
                for (const double sample : dense_parameters())
                    add_candidate(frame_at(sample));
            pass.next = governing(candidates);
        }
        return pass;
    }

private:
    // A pass on a collapsed edge: one contact, and candidates from all directions.
    MarchedPass march_pole(PassRole role) const
    {
        const FeedFrame first = frame_at(line_.range().low);
        std::vector<PassCandidate> candidates;
        for (const double u : dense_parameters()) {
            const FeedFrame frame = frame_at(u);
            if ((frame.forms.normal - first.forms.normal).norm() > same_normal)
                throw GeometryError{"the surface has no normal at its pole " +
                                    place(frame.at, frame.jet)};
            if (const auto found = candidate(frame, infinity))
                candidates.push_back(*found);
        }
        MarchedPass pass{{contact(first)}, std::nullopt};
        if (role == PassRole::Followed)
            pass.next = governing(candidates);
        return pass;
    }

    void require_room(std::size_t points) const
    {
        if (points > options_.most_points)
            throw LimitError{"a pass has more than " +
                             std::to_string(options_.most_points) + " points, the limit"};
    }

    FeedFrame frame_at(double u) const
    {
        const SurfacePoint at{u, line_.v()};
        const SurfaceJet jet = line_.jet(u);
        const auto inward = [&](Parameter along, double parameter) {
            return parameter < marched_.surface.range(along).high ? 1 : -1;
        };
        const auto normal =
            limit_normal(jet, {inward(Parameter::U, u), inward(Parameter::V, line_.v())});
        if (!normal)
            throw GeometryError{"the surface has no normal at " + place(at, jet)};
        return feed_frame(at, jet, Vec3{marched_.side * *normal});
    }

    static SurfaceContact contact(const FeedFrame& frame)
    {
        return {frame.at.u, frame.at.v, {frame.jet.point, frame.forms.normal}};
    }

    // The parameter of the next CL point; nothing if the pass ends before the border.
    std::optional<double> next_parameter(const FeedFrame& frame) const
    {
        const double u = frame.at.u;
        const double end = line_.range().high;
        const StepLength step =
            step_length(step_curvature(frame), options_.chord_tolerance);
        std::optional<double> next;
        if (step.status != LengthStatus::Unlimited)
            next = line_.first_reach(u, frame.feed, step.projected);
        if (!next && options_.end_point == EndPoint::Force)
            next = end;
        if (options_.patch_borders == PatchBorders::Stop)
            next = std::min(next.value_or(end), next_border(u));
        if (!next)
            return std::nullopt;
        if (*next >= end - end_width * marched_.surface.patch_width(Parameter::U, end))
            return end;
        if (*next <= u)
            throw GeometryError{"a step of the pass makes no progress at " +
                                place(frame.at, frame.jet)};
        return next;
    }

    double step_curvature(const FeedFrame& frame) const
    {
        const double curvature = options_.step_curvature == StepCurvature::Curve
                                     ? curve_curvature(frame.jet.du, frame.jet.duu)
                                     : frame.forms.e / frame.forms.E;
        if (!std::isfinite(curvature))
            throw GeometryError{"the pass has no tangent at " +
                                place(frame.at, frame.jet)};
        return curvature;
    }

    // The next border of patches after u. A point within end_width of a border is on it.
    double next_border(double u) const
    {
        const auto breaks = marched_.surface.breaks(Parameter::U);
        const int number = marched_.surface.patch_number(Parameter::U, u);
        const double border = breaks[number + 1];
        const double near = end_width * (border - breaks[number]);
        const bool is_there = u >= border - near && border < breaks.back();
        return is_there ? breaks[number + 2] : border;
    }

    bool least_governs() const
    {
        return options_.governing == Governing::Min ||
               options_.governing == Governing::DenseMin;
    }

    // The candidate of a contact; nothing if the contact does not limit the next pass, or
    // limits it only beyond most_v.
    std::optional<PassCandidate> candidate(const FeedFrame& frame, double most_v) const
    {
        if (frame.passes_meet)
            return std::nullopt;
        const double k =
            options_.cross_curvature == CrossCurvature::Exact
                ? cross_curvature(frame)
                : cross_curvature_by_chord(marched_.surface, frame, options_.cross_step);
        if (1 + k * cutter_.radius() <= 0)
            throw GeometryError{"the ball of radius " + to_text(cutter_.radius()) +
                                " mm does not fit the concavity of radius " +
                                to_text(-1 / k) + " mm at " + place(frame.at, frame.jet)};
        const PathInterval interval = path_interval(cutter_, k, options_.scallop_height);
        if (interval.status == LengthStatus::Unlimited)
            return std::nullopt;
        const SurfacePoint partner =
            check_plane_point(marched_.surface, frame, interval.projected, most_v).at;
        if (partner.v > most_v || !std::isfinite(partner.v))
            return std::nullopt;
        return PassCandidate{partner.v, frame.at, partner};
    }

    // Equidistant parameters on each patch, both ends included.
    std::vector<double> dense_parameters() const
    {
        const auto breaks = marched_.surface.breaks(Parameter::U);
        std::vector<double> parameters;
        for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
            for (int sample = 0; sample <= dense_samples; ++sample)
                parameters.push_back(
                    std::lerp(breaks[i], breaks[i + 1], sample / double(dense_samples)));
        return parameters;
    }

    // Selects a candidate by the rule of the options.
    NextPass governing(std::span<const PassCandidate> candidates) const
    {
        if (candidates.empty())
            return {};
        const auto by = [](const PassCandidate& candidate) -> NextPass {
            return {candidate.v, candidate};
        };
        switch (options_.governing) {
            case Governing::Min:
            case Governing::DenseMin:
                return by(*std::ranges::min_element(candidates, {}, &PassCandidate::v));
            case Governing::Max:
                return by(*std::ranges::max_element(candidates, {}, &PassCandidate::v));
            case Governing::First:
                return by(candidates.front());
            case Governing::Mean:
                break;
        }
        double sum = 0;
        for (const PassCandidate& candidate : candidates)
            sum += candidate.v;
        return {sum / static_cast<double>(candidates.size()), std::nullopt};
    }

    std::string place(const SurfacePoint& at, const SurfaceJet& jet) const
    {
        return place_text(in_surface_order(at, options_.direction), jet.point);
    }

    const MarchedSurface& marched_;
    IsoLine line_;
    const BallCutter& cutter_;
    const IsoParametricOptions& options_;
};

}  // namespace

MarchedPass march_pass(const MarchedSurface& marched, double v, PassRole role,
                       const BallCutter& cutter, const IsoParametricOptions& options)
{
    return PassMarch{marched, v, cutter, options}.march(role);
}

}  // namespace endmill
