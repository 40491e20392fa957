// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/iso_parametric.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/tolerance.h"
#include "endmill/planning/detail/cross_section.h"
#include "endmill/planning/detail/pass_march.h"
#include "endmill/planning/path_interval.h"
#include "endmill/planning/step_length.h"
#include "endmill/surface/detail/iso_line.h"
#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

// In widths of a patch: a pass that advances less makes no progress.
constexpr double least_advance = 1e-4;

// Where the pass after the one at v lies; nothing if that was the last.
std::optional<double> next_pass(const Surface& surface, double v, double candidate,
                                LastPath last_path)
{
    const double end = surface.range(Parameter::V).high;
    const double near = end_width * surface.patch_width(Parameter::V, end);
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
    require(std::abs(options.link.axis.norm() - 1) < unit_vector_rounding,
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
          cutter_{cutter},
          options_{options}
    {
        if (options.march == March::Alternate)
            backward_ = MarchedSurface{reversed_in_u(forward_.surface), -forward_.side};
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
            const std::optional<PassCandidate> next = pass.next;
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
            return march_pass(forward_, v, is_last, cutter_, options_);
        MarchedPass pass = march_pass(*backward_, v, is_last, cutter_, options_);
        turn_round(pass, backward_->surface.range(Parameter::U));
        return pass;
    }

    std::optional<double> following(double v, double candidate) const
    {
        const double width = forward_.surface.patch_width(Parameter::V, v);
        if (!(candidate - v >= least_advance * width)) {
            const SurfacePoint at{forward_.surface.range(Parameter::U).low, v};
            throw GeometryError{"the next pass makes no progress after the one through " +
                                place_text(in_surface_order(at, options_.direction),
                                           forward_.surface.tangents(at.u, at.v).point)};
        }
        return next_pass(forward_.surface, v, candidate, options_.last_path);
    }

    std::optional<GoverningPoint> governing_point(
        const std::optional<PassCandidate>& next) const
    {
        if (!next || !std::isfinite(next->v) || options_.governing == Governing::Mean)
            return std::nullopt;
        return GoverningPoint{next->at, next->partner};
    }

    MarchedSurface forward_;
    std::optional<MarchedSurface> backward_;
    const BallCutter& cutter_;
    const IsoParametricOptions& options_;
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

// Exchanging the parameters turns du x dv round.
MarchedSurface surface_to_march(const Surface& surface, double side, Parameter direction)
{
    if (direction == Parameter::U)
        return {surface, side};
    return {transposed(surface), -side};
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
    const double side = tool_side_sign(surface, options.link.axis);
    require_reachable(surface, options.link.axis, side);
    MarchedSurface marched = surface_to_march(surface, side, options.direction);
    MarchedPasses result = SurfacePlanner{std::move(marched), cutter, options}.plan();
    if (options.direction == Parameter::V)
        exchange_parameters(result);
    return {link_passes(result.passes, cutter, options.link),
            std::move(result.governing)};
}

IsoParametricPlan plan_iso_parametric(std::span<const Surface> surfaces,
                                      const BallCutter& cutter,
                                      const IsoParametricOptions& options)
{
    if (surfaces.size() == 1)
        return plan_iso_parametric(surfaces.front(), cutter, options);
    std::vector<ToolPath> paths;
    std::vector<std::optional<GoverningPoint>> governing;
    IsoParametricOptions own = options;
    for (const Surface& surface : surfaces) {
        const auto share_before = double(paths.size()) / double(surfaces.size());
        if (options.progress)
            own.progress = [&](double share) {
                options.progress(share_before + share / double(surfaces.size()));
            };
        IsoParametricPlan plan = plan_iso_parametric(surface, cutter, own);
        own.most_points -= std::min(own.most_points, plan.path.points.size());
        governing.insert(governing.end(), plan.governing.begin(), plan.governing.end());
        paths.push_back(std::move(plan.path));
    }
    return {join_paths(paths, options.link), std::move(governing)};
}

double estimated_points(const Surface& surface, const BallCutter& cutter,
                        const IsoParametricOptions& options)
{
    require_sound(cutter, options);
    const MarchedSurface marched = surface_to_march(
        surface, tool_side_sign(surface, options.link.axis), options.direction);
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
