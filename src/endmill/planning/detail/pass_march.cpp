// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/pass_march.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/planning/detail/cross_section.h"
#include "endmill/planning/path_interval.h"
#include "endmill/planning/step_length.h"
#include "endmill/surface/detail/iso_line.h"
#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int dense_samples = 16;  // a patch
// Distance of unit normals at a pole beyond which they have no common limit.
constexpr double same_normal = 1e-9;

// The work on one pass.
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

    MarchedPass march(bool is_last) const
    {
        if (line_.is_point())
            return march_pole(is_last);
        const double end = line_.range().high;
        MarchedPass pass;
        std::vector<PassCandidate> candidates;
        double most_v = infinity;  // of a candidate that can govern
        const auto add_candidate = [&](const FeedFrame& frame) {
            candidates.push_back(candidate(frame, most_v));
            if (least_governs())
                most_v = std::min(most_v, candidates.back().v);
        };
        std::optional<double> u = line_.range().low;
        while (u) {
            const FeedFrame frame = frame_at(*u);
            pass.contacts.push_back(contact(frame));
            require_room(pass.contacts.size());
            if (!is_last)
                add_candidate(frame);
            u = *u == end ? std::nullopt : next_parameter(frame);
        }
        if (!is_last) {
            if (options_.governing == Governing::DenseMin)
                for (const double sample : dense_parameters())
                    add_candidate(frame_at(sample));
            pass.next = governing(std::move(candidates));
        }
        return pass;
    }

private:
    MarchedPass march_pole(bool is_last) const
    {
        const FeedFrame first = frame_at(line_.range().low);
        std::vector<PassCandidate> candidates;
        for (const double u : dense_parameters()) {
            const FeedFrame frame = frame_at(u);
            if ((frame.forms.normal - first.forms.normal).norm() > same_normal)
                throw GeometryError{"the surface has no normal at its pole " +
                                    place(frame.at, frame.jet)};
            candidates.push_back(candidate(frame, infinity));
        }
        MarchedPass pass{{contact(first)}, std::nullopt};
        if (!is_last)
            pass.next = governing(std::move(candidates));
        return pass;
    }

    void require_room(std::size_t points) const
    {
        if (points > options_.most_points)
            throw LimitError{"a pass has more than " +
                             std::to_string(options_.most_points) +
                             " points, the most that fit"};
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

    // Where the next CL point of the pass stands; nothing where the pass ends before its
    // border.
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
        if (options_.stop_at_borders)
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

    // The next pass as this place allows it; no limit if that lies beyond most_v.
    PassCandidate candidate(const FeedFrame& frame, double most_v) const
    {
        if (frame.passes_meet)
            return {};
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
            return {};
        const SurfacePoint partner =
            check_plane_point(marched_.surface, frame, interval.projected, most_v).at;
        if (partner.v > most_v)
            return {};
        return {partner.v, frame.at, partner};
    }

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

    // By the rule asked for, among the places that limit the next pass.
    PassCandidate governing(std::vector<PassCandidate> candidates) const
    {
        std::erase_if(candidates,
                      [](const PassCandidate& c) { return !std::isfinite(c.v); });
        if (candidates.empty())
            return {};
        switch (options_.governing) {
            case Governing::Min:
            case Governing::DenseMin:
                return *std::ranges::min_element(candidates, {}, &PassCandidate::v);
            case Governing::Max:
                return *std::ranges::max_element(candidates, {}, &PassCandidate::v);
            case Governing::First:
                return candidates.front();
            case Governing::Mean:
                break;
        }
        double sum = 0;
        for (const PassCandidate& candidate : candidates)
            sum += candidate.v;
        return {sum / static_cast<double>(candidates.size()), {}, {}};
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

MarchedPass march_pass(const MarchedSurface& marched, double v, bool is_last,
                       const BallCutter& cutter, const IsoParametricOptions& options)
{
    return PassMarch{marched, v, cutter, options}.march(is_last);
}

SurfacePoint in_surface_order(const SurfacePoint& at, Parameter direction)
{
    return direction == Parameter::U ? at : SurfacePoint{at.v, at.u};
}

}  // namespace endmill
