// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/iso_parametric.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/tolerance.h"
#include "endmill/planning/detail/cross_section.h"
#include "endmill/planning/detail/marched_surface.h"
#include "endmill/planning/detail/pass_march.h"
#include "endmill/planning/path_interval.h"
#include "endmill/planning/step_length.h"
#include "endmill/surface/detail/iso_line.h"
#include "endmill/surface/tool_side.h"

// The planner works pass by pass:
// 1. The surface is transposed if the passes run along v, so that every pass runs along
//    u.
// 2. march_pass computes the contacts of the pass at v. Each contact has a candidate for
//    the parameter of the next pass; the rule `governing` selects one.
// 3. The next pass lies there, on the border, or nowhere, as `last_path` demands.
// 4. After the last pass, link_passes joins the contacts to a path. With March::Alternate
// every other pass is marched on the surface reversed in u, and its result is reversed
// back.

namespace endmill {
namespace {

// Widths of a patch. A pass that advances less than this makes no progress: the planner
// would need more than 10 000 passes for one patch.
constexpr double least_advance = 1e-4;

// The parameter of the pass after the one at v, or nothing if that was the last.
// `candidate` is the parameter that the governing contact allows.
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

// Turns a pass that was marched on the surface reversed in u into one on the original
// surface.
void turn_round(MarchedPass& pass, Interval range)
{
    const auto turned = [&](double u) { return range.low + range.high - u; };
    std::ranges::reverse(pass.contacts);
    for (SurfaceContact& contact : pass.contacts)
        contact.u = turned(contact.u);
    if (pass.next && pass.next->governing) {
        PassCandidate& governing = *pass.next->governing;
        governing.at.u = turned(governing.at.u);
        governing.partner.u = turned(governing.partner.u);
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

// Passes in few large blocks of memory. They are linked from first to last, and each
// block is freed when the path holds its contacts. A long path therefore needs memory for
// itself and for one block only.
class StoredPasses {
public:
    void add(const Pass& pass)
    {
        if (blocks_.empty() || !fits(blocks_.back().contacts, pass.size())) {
            const std::size_t usual =
                contacts_ < few_contacts ? few_contacts : contacts_per_block;
            blocks_.emplace_back().contacts.reserve(std::max(pass.size(), usual));
        }
        Block& block = blocks_.back();
        block.contacts.insert(block.contacts.end(), pass.begin(), pass.end());
        block.lengths.push_back(pass.size());
        ++passes_;
        contacts_ += pass.size();
    }

    std::size_t passes() const { return passes_; }

    // The path along all passes, which are removed.
    ToolPath linked(const BallCutter& cutter, const LinkOptions& options)
    {
        std::size_t block = 0;
        std::size_t pass = 0;   // in this block
        std::size_t first = 0;  // contact of this pass
        const auto next = [&]() -> std::span<const SurfaceContact> {
            if (pass == blocks_[block].lengths.size()) {
                blocks_[block] = {};
                ++block;
                pass = first = 0;
            }
            const std::size_t length = blocks_[block].lengths[pass++];
            first += length;
            return {blocks_[block].contacts.data() + first - length, length};
        };
        return link_passes_one_by_one({passes_, contacts_, next}, cutter, options);
    }

private:
    struct Block {
        std::vector<SurfaceContact> contacts;
        std::vector<std::size_t> lengths;  // of its passes
    };

    static bool fits(const std::vector<SurfaceContact>& contacts, std::size_t more)
    {
        return contacts.capacity() - contacts.size() >= more;
    }

    // A block of 32 MiB: the C library returns it to the system when it is freed.
    static constexpr std::size_t contacts_per_block =
        (std::size_t{32} << 20) / sizeof(SurfaceContact);
    static constexpr std::size_t few_contacts = 4096;  // smaller blocks cost less time

    std::vector<Block> blocks_;
    std::size_t passes_ = 0;
    std::size_t contacts_ = 0;
};

// All passes of a surface.
struct MarchedPasses {
    StoredPasses passes;
    std::vector<std::optional<GoverningPoint>> governing;
};

// Plans the passes of one surface, along u.
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
            const PassRole role = *v == end ? PassRole::Last : PassRole::Followed;
            MarchedPass pass = march(*v, role, result.passes.passes());
            points += pass.contacts.size();
            if (points > options_.most_points)
                throw LimitError{"the path has more than " +
                                 std::to_string(options_.most_points) +
                                 " points, the limit"};
            const std::optional<NextPass> next = pass.next;
            result.governing.push_back(governing_point(next));
            result.passes.add(with_surface_parameters(std::move(pass.contacts)));
            if (options_.progress)
                options_.progress((*v - low) / (end - low));
            v = next ? following(*v, next->v) : std::nullopt;
        }
        return result;
    }

private:
    MarchedPass march(double v, PassRole role, std::size_t number) const
    {
        if (!backward_ || number % 2 == 0)
            return march_pass(forward_, v, role, cutter_, options_);
        MarchedPass pass = march_pass(*backward_, v, role, cutter_, options_);
        turn_round(pass, backward_->surface.range(Parameter::U));
        return pass;
    }

    // The parameter of the pass after the one at v. The error names the start of that
    // pass.
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

    // With the parameters of the surface itself, as all results.
    std::optional<GoverningPoint> governing_point(
        const std::optional<NextPass>& next) const
    {
        if (!next || !next->governing)
            return std::nullopt;
        const PassCandidate& governing = *next->governing;
        return GoverningPoint{in_surface_order(governing.at, options_.direction),
                              in_surface_order(governing.partner, options_.direction)};
    }

    Pass with_surface_parameters(Pass pass) const
    {
        if (options_.direction == Parameter::V)
            for (SurfaceContact& contact : pass)
                std::swap(contact.u, contact.v);
        return pass;
    }

    MarchedSurface forward_;
    std::optional<MarchedSurface> backward_;  // reversed in u; for March::Alternate only
    const BallCutter& cutter_;
    const IsoParametricOptions& options_;
};

// An eighth of a patch in one parameter.
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
    MarchedSurface marched = marched_surface(surface, side, options.direction);
    MarchedPasses result = SurfacePlanner{std::move(marched), cutter, options}.plan();
    return {result.passes.linked(cutter, options.link), std::move(result.governing)};
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
    const MarchedSurface marched = marched_surface(
        surface, tool_side_sign(surface, options.link.axis), options.direction);
    const std::vector<ParameterCell> cells =
        parameter_cells(marched.surface, Parameter::U);
    double total = 0;
    for (const ParameterCell& row : parameter_cells(marched.surface, Parameter::V)) {
        const IsoLine line{marched.surface, row.middle};
        double steps = 1;   // number of points of a pass in this row
        double passes = 0;  // number of passes in this row, by its narrowest interval
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
