// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/iso_parametric.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/numbers.h"
#include "endmill/planning/cross_section.h"
#include "endmill/planning/path_interval.h"
#include "endmill/planning/step_length.h"
#include "endmill/surface/iso_line.h"
#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// In widths of a patch: a point so near the end is the end, and a pass that advances less
// makes no progress. Source: the project's reading of [KimChoi, section 4].
constexpr double end_width = 1e-6;
constexpr double least_advance = 1e-4;
constexpr int dense_samples = 16;  // a patch

std::string place_text(Parameter direction, double u, double v, const Vec3& point)
{
    if (direction == Parameter::V)
        std::swap(u, v);
    return "u = " + to_text(u) + ", v = " + to_text(v) + " (" + to_text(point.x()) +
           ", " + to_text(point.y()) + ", " + to_text(point.z()) + " mm)";
}

double patch_width(const Surface& surface, Parameter along, double parameter)
{
    const int number = surface.patch_number(along, parameter);
    return surface.breaks(along)[number + 1] - surface.breaks(along)[number];
}

// The surface whose u is turned round, so that marching forwards on it marches backwards
// on the original; `low + high - u` leads from one to the other.
Surface reversed_in_u(const Surface& surface)
{
    const auto breaks = surface.breaks(Parameter::U);
    std::vector<double> reversed;
    for (auto k = breaks.size(); k-- > 0;)
        reversed.push_back(breaks.front() + breaks.back() - breaks[k]);
    std::vector<BezierPatch> patches;
    for (int j = 0; j < surface.patches(Parameter::V); ++j)
        for (int i = surface.patches(Parameter::U); i-- > 0;) {
            std::array<Vec3, 16> net;
            for (int row = 0; row < 4; ++row)
                for (int column = 0; column < 4; ++column)
                    net[4 * row + column] =
                        surface.patch(i, j).control_point(3 - column, row);
            patches.emplace_back(net);
        }
    const auto breaks_v = surface.breaks(Parameter::V);
    ToolSide side = surface.tool_side();
    if (side != ToolSide::Up)
        side = side == ToolSide::DuCrossDv ? ToolSide::DvCrossDu : ToolSide::DuCrossDv;
    return Surface{std::move(reversed),
                   {breaks_v.begin(), breaks_v.end()},
                   std::move(patches),
                   side};
}

// A surface to march along u on, and the sign of its normals.
struct MarchedSurface {
    Surface surface;
    double side;
};

// The next pass as one place of this pass allows it.
struct Candidate {
    double v = infinity;  // infinite: the place does not limit it
    SurfacePoint at{};
    SurfacePoint partner{};
};

struct MarchedPass {
    Pass contacts;
    std::optional<Candidate> next;  // none on the last pass
};

// Plans passes along u. The planner for passes along v is the same on the transposed
// surface.
class PassPlanner {
public:
    PassPlanner(const BallCutter& cutter, const IsoParametricOptions& options)
        : cutter_{cutter},
          options_{options}
    {
    }

    MarchedPass march(const MarchedSurface& marched, double v, bool is_last) const
    {
        const IsoLine line{marched.surface, v};
        const double end = line.range().high;
        MarchedPass pass;
        std::vector<Candidate> candidates;
        double u = line.range().low;
        for (;;) {
            const FeedFrame frame = feed_frame({u, v}, line.jet(u), marched.side);
            pass.contacts.push_back({u, v, {frame.jet.point, frame.forms.normal}});
            if (!is_last)
                candidates.push_back(candidate(marched.surface, frame));
            if (u == end)
                break;
            const auto next = next_parameter(marched.surface, line, frame);
            if (!next)
                break;
            u = *next;
        }
        if (!is_last) {
            if (options_.governing == Governing::DenseMin)
                add_dense_candidates(marched, line, candidates);
            pass.next = governing(candidates);
        }
        return pass;
    }

private:
    // Where the next CL point of the pass stands; nothing where the pass ends before its
    // border.
    std::optional<double> next_parameter(const Surface& surface, const IsoLine& line,
                                         const FeedFrame& frame) const
    {
        const double u = frame.at.u;
        const double end = line.range().high;
        const StepLength step =
            step_length(step_curvature(frame), options_.chord_tolerance);
        std::optional<double> next;
        if (step.status != LengthStatus::Unlimited)
            next = line.first_reach(u, frame.feed, step.projected);
        if (!next && options_.end_point == EndPoint::Force)
            next = end;
        if (options_.stop_at_borders)
            next = std::min(next.value_or(end), next_border(surface, u));
        if (!next)
            return std::nullopt;
        if (*next >= end - end_width * patch_width(surface, Parameter::U, end))
            return end;
        if (*next <= u)
            throw GeometryError{"a step of the pass makes no progress at " +
                                place(frame)};
        return next;
    }

    double step_curvature(const FeedFrame& frame) const
    {
        if (options_.step_curvature == StepCurvature::Curve)
            return curve_curvature(frame.jet.du, frame.jet.duu);
        return frame.forms.e / frame.forms.E;
    }

    static double next_border(const Surface& surface, double u)
    {
        const auto breaks = surface.breaks(Parameter::U);
        const int number = surface.patch_number(Parameter::U, u);
        const double border = breaks[number + 1];
        const double near = end_width * (border - breaks[number]);
        const bool is_there = u >= border - near && border < breaks.back();
        return is_there ? breaks[number + 2] : border;
    }

    Candidate candidate(const Surface& surface, const FeedFrame& frame) const
    {
        const double k =
            options_.cross_curvature == CrossCurvature::Exact
                ? cross_curvature(frame)
                : cross_curvature_by_chord(surface, frame, options_.cross_step);
        if (1 + k * cutter_.radius() <= 0)
            throw GeometryError{"the ball of radius " + to_text(cutter_.radius()) +
                                " mm does not fit the concavity of radius " +
                                to_text(-1 / k) + " mm at " + place(frame)};
        const PathInterval interval = path_interval(cutter_, k, options_.scallop_height);
        if (interval.status == LengthStatus::Unlimited)
            return {};
        const SurfacePoint partner =
            check_plane_point(surface, frame, interval.projected).at;
        return {partner.v, frame.at, partner};
    }

    void add_dense_candidates(const MarchedSurface& marched, const IsoLine& line,
                              std::vector<Candidate>& candidates) const
    {
        const auto breaks = marched.surface.breaks(Parameter::U);
        for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
            for (int sample = 0; sample <= dense_samples; ++sample) {
                const double u =
                    std::lerp(breaks[i], breaks[i + 1], sample / double(dense_samples));
                const FeedFrame frame =
                    feed_frame({u, line.v()}, line.jet(u), marched.side);
                candidates.push_back(candidate(marched.surface, frame));
            }
    }

    Candidate governing(const std::vector<Candidate>& candidates) const
    {
        switch (options_.governing) {
            case Governing::Min:
            case Governing::DenseMin:
                return *std::ranges::min_element(candidates, {}, &Candidate::v);
            case Governing::Max:
                return *std::ranges::max_element(candidates, {}, &Candidate::v);
            case Governing::First:
                return candidates.front();
            case Governing::Mean:
                break;
        }
        double sum = 0;
        for (const Candidate& candidate : candidates)
            sum += candidate.v;
        return {sum / static_cast<double>(candidates.size()), {}, {}};
    }

    std::string place(const FeedFrame& frame) const
    {
        return place_text(options_.direction, frame.at.u, frame.at.v, frame.jet.point);
    }

    const BallCutter& cutter_;
    const IsoParametricOptions& options_;
};

// Where the pass after the one at v lies; nothing if that was the last.
std::optional<double> next_pass(const Surface& surface, double v, double candidate,
                                LastPath last_path)
{
    const double end = surface.range(Parameter::V).high;
    const double near = end_width * patch_width(surface, Parameter::V, end);
    if (candidate < end - near)
        return candidate;
    const bool lies_on_border = candidate <= end + near;
    const bool half_is_left = end - v >= (candidate - v) / 2;
    if (lies_on_border || last_path == LastPath::Border ||
        (last_path == LastPath::Half && half_is_left))
        return end;
    return std::nullopt;
}

void turn_round(MarchedPass& pass, Interval range)
{
    const auto turned = [&](double u) { return range.low + range.high - u; };
    std::ranges::reverse(pass.contacts);
    for (SurfaceContact& contact : pass.contacts)
        contact.u = turned(contact.u);
    if (pass.next) {
        pass.next->at.u = turned(pass.next->at.u);
        pass.next->partner.u = turned(pass.next->partner.u);
    }
}

MarchedSurface marched_surface(Surface surface, const Vec3& axis)
{
    const double side = tool_side_sign(surface, axis);
    return {std::move(surface), side};
}

void require_sound(const BallCutter& cutter, const IsoParametricOptions& options)
{
    const double delta = options.chord_tolerance;
    const double h = options.scallop_height;
    require(std::isfinite(delta) && delta > 0,
            "plan_iso_parametric: need 0 < chord tolerance");
    require(0 < h && h < 2 * cutter.radius(),
            "plan_iso_parametric: need 0 < scallop height < 2 cutter radii");
    require(std::isfinite(options.cross_step) && options.cross_step > 0,
            "plan_iso_parametric: need 0 < cross step");
    require(std::abs(options.link.axis.norm() - 1) < 1e-12,
            "plan_iso_parametric: the axis must be a unit vector");
}

struct MarchedPasses {
    std::vector<Pass> passes;
    std::vector<std::optional<GoverningPoint>> governing;
};

class SurfacePlanner {
public:
    SurfacePlanner(MarchedSurface forward, const BallCutter& cutter,
                   const IsoParametricOptions& options)
        : forward_{std::move(forward)},
          options_{options},
          planner_{cutter, options}
    {
        if (options.march == March::Alternate)
            backward_ =
                marched_surface(reversed_in_u(forward_.surface), options.link.axis);
    }

    MarchedPasses plan()
    {
        const auto [low, end] = forward_.surface.range(Parameter::V);
        MarchedPasses result;
        std::size_t points = 0;
        std::optional<double> v = low;
        while (v) {
            MarchedPass pass = march(*v, *v == end, result.passes.size() % 2 == 1);
            points += pass.contacts.size();
            if (points > options_.most_points)
                throw LimitError{"the path has more than " +
                                 std::to_string(options_.most_points) +
                                 " points, the most that fit"};
            result.governing.push_back(governing_point(pass.next));
            const std::optional<Candidate> next = pass.next;
            result.passes.push_back(std::move(pass.contacts));
            if (options_.progress)
                options_.progress((*v - low) / (end - low));
            v = next ? following(*v, next->v) : std::nullopt;
        }
        return result;
    }

private:
    MarchedPass march(double v, bool is_last, bool is_odd) const
    {
        if (!backward_ || !is_odd)
            return planner_.march(forward_, v, is_last);
        MarchedPass pass = planner_.march(*backward_, v, is_last);
        turn_round(pass, backward_->surface.range(Parameter::U));
        return pass;
    }

    std::optional<double> following(double v, double candidate) const
    {
        const double width = patch_width(forward_.surface, Parameter::V, v);
        if (!(candidate - v >= least_advance * width)) {
            const double u = forward_.surface.range(Parameter::U).low;
            throw GeometryError{"the next pass makes no progress after the one through " +
                                place_text(options_.direction, u, v,
                                           forward_.surface.tangents(u, v).point)};
        }
        return next_pass(forward_.surface, v, candidate, options_.last_path);
    }

    std::optional<GoverningPoint> governing_point(
        const std::optional<Candidate>& next) const
    {
        if (!next || next->v == infinity || options_.governing == Governing::Mean)
            return std::nullopt;
        return GoverningPoint{next->at, next->partner};
    }

    MarchedSurface forward_;
    std::optional<MarchedSurface> backward_;
    const IsoParametricOptions& options_;
    PassPlanner planner_;
};

void exchange_parameters(MarchedPasses& marched)
{
    for (Pass& pass : marched.passes)
        for (SurfaceContact& contact : pass)
            std::swap(contact.u, contact.v);
    for (auto& governing : marched.governing)
        if (governing) {
            std::swap(governing->at.u, governing->at.v);
            std::swap(governing->partner.u, governing->partner.v);
        }
}

Surface surface_to_march(const Surface& surface, Parameter direction)
{
    return direction == Parameter::U ? surface : transposed(surface);
}

// A piece of a parameter's range: an eighth of a patch.
struct ParameterCell {
    double middle;
    double width;
};

std::vector<ParameterCell> parameter_cells(const Surface& surface, Parameter along)
{
    constexpr int cells_per_patch = 8;
    const auto breaks = surface.breaks(along);
    std::vector<ParameterCell> cells;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        const double width = (breaks[i + 1] - breaks[i]) / cells_per_patch;
        for (int cell = 0; cell < cells_per_patch; ++cell)
            cells.push_back({breaks[i] + (cell + 0.5) * width, width});
    }
    return cells;
}

}  // namespace

IsoParametricPlan plan_iso_parametric(const Surface& surface, const BallCutter& cutter,
                                      const IsoParametricOptions& options)
{
    require_sound(cutter, options);
    require_reachable(surface, options.link.axis,
                      tool_side_sign(surface, options.link.axis));
    MarchedSurface marched =
        marched_surface(surface_to_march(surface, options.direction), options.link.axis);
    MarchedPasses result = SurfacePlanner{std::move(marched), cutter, options}.plan();
    if (options.direction == Parameter::V)
        exchange_parameters(result);
    return {link_passes(result.passes, cutter, options.link),
            std::move(result.governing)};
}

double estimated_points(const Surface& surface, const BallCutter& cutter,
                        const IsoParametricOptions& options)
{
    require_sound(cutter, options);
    const MarchedSurface marched =
        marched_surface(surface_to_march(surface, options.direction), options.link.axis);
    const std::vector<ParameterCell> cells =
        parameter_cells(marched.surface, Parameter::U);
    double total = 0;
    for (const ParameterCell& row : parameter_cells(marched.surface, Parameter::V)) {
        const IsoLine line{marched.surface, row.middle};
        double steps = 1;   // of a pass here
        double passes = 0;  // in this row, by its narrowest interval
        for (const ParameterCell& cell : cells) {
            const SurfaceJet jet = line.jet(cell.middle);
            if (is_singular({jet.point, jet.du, jet.dv}))
                continue;
            const FeedFrame frame =
                feed_frame({cell.middle, line.v()}, jet, marched.side);
            const double k = cross_curvature(frame);
            const double bend = curve_curvature(jet.du, jet.duu);
            steps += jet.du.norm() * cell.width /
                     step_length(bend, options.chord_tolerance).chord;
            if (1 + k * cutter.radius() <= 0)
                continue;
            const PathInterval interval =
                path_interval(cutter, k, options.scallop_height);
            passes = std::max(passes, row.width / (frame.cross.b * interval.projected));
        }
        total += steps * passes;
    }
    return total;
}

}  // namespace endmill
