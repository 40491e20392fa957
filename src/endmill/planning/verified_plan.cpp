// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/verified_plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/tolerance.h"
#include "endmill/planning/detail/verified_strips.h"
#include "endmill/surface/tool_side.h"

// The steps of plan_verified:
// 1. ClearMoves prepares the gouge tests against all surfaces of the part.
// 2. For each surface, verified_strips plans the passes and the places it could not
//    cover.
// 3. The pieces of the passes are put into the order of cutting. A zigzag starts at the
//    end of its first pass that makes the links shorter.
// 4. link_pieces joins the pieces. A link that would gouge is lifted.
// 5. join_paths joins the surfaces.

namespace endmill {
namespace {

// Widening of the ball of the gouge tests as a share of the outer tolerance, where no
// gouge is allowed. The tests then see a tolerance of half the band, and decide to a
// thousandth of it, which is less than the margin of the contacts (offset_margin).
constexpr double widening_share = 0.5;

void require_sound(const BallCutter& cutter, const VerifiedOptions& options)
{
    const auto [inner, outer] = options.tolerances;
    const double h = options.scallop_height;
    require(0 <= inner && inner < cutter.radius(),
            "plan_verified: need 0 <= inner tolerance < cutter radius");
    require(std::isfinite(outer) && 0 <= outer,
            "plan_verified: need 0 <= outer tolerance");
    require(inner > 0 || (outer > 0 && outer < cutter.radius()),
            "plan_verified: without an inner tolerance need 0 < outer tolerance < cutter "
            "radius");
    require(0 < h && h < 2 * cutter.radius(),
            "plan_verified: need 0 < scallop height < 2 cutter radii");
    require(std::abs(options.link.axis.norm() - 1) < unit_vector_rounding,
            "plan_verified: the axis must be a unit vector");
}

// Total length in mm of the links of a zigzag whose passes with number % 2 == `backwards`
// are cut backwards.
double link_travel(const std::vector<VerifiedPass>& passes, std::size_t backwards)
{
    double travel = 0;
    for (std::size_t k = 1; k < passes.size(); ++k) {
        const auto end = [&](const VerifiedPass& pass) -> const Vec3& {
            return (k - 1) % 2 == backwards ? pass.pieces.front().front().contact.point
                                            : pass.pieces.back().back().contact.point;
        };
        travel += (end(passes[k]) - end(passes[k - 1])).norm();
    }
    return travel;
}

// The pieces of all passes in the order of cutting, with the parameters of the part's
// surface.
std::vector<PassPiece> pieces_in_order(std::vector<VerifiedPass> passes,
                                       const VerifiedOptions& options)
{
    std::vector<PassPiece> ordered;
    const std::size_t backwards = link_travel(passes, 0) < link_travel(passes, 1) ? 0 : 1;
    for (std::size_t number = 0; number < passes.size(); ++number) {
        std::vector<Pass>& pieces = passes[number].pieces;
        if (options.link.order == PassOrder::ZigZag && number % 2 == backwards) {
            std::ranges::reverse(pieces);
            for (Pass& piece : pieces)
                std::ranges::reverse(piece);
        }
        for (Pass& piece : pieces)
            ordered.push_back({static_cast<int>(number), std::move(piece)});
    }
    if (options.direction == Parameter::V)
        for (PassPiece& piece : ordered)
            for (SurfaceContact& contact : piece.contacts)
                std::swap(contact.u, contact.v);
    return ordered;
}

// Joins the pieces; a link is straight if the move between its contacts is clear.
LinkedPath linked(const std::vector<PassPiece>& pieces, const ClearMoves& clear,
                  const VerifiedOptions& options)
{
    const auto is_clear = [&](const Vec3& from, const Vec3& to) {
        FinerPieces finer;
        return clear.is_clear({from, to}, finer);
    };
    return link_pieces(pieces, clear.cutter(), options.link, is_clear);
}

}  // namespace

VerifiedPlan plan_verified(std::span<const Surface> surfaces, const BallCutter& cutter,
                           const VerifiedOptions& options)
{
    require_sound(cutter, options);
    const std::vector<double> sides = tool_side_signs(surfaces, options.link.axis);
    require_reachable(surfaces, options.link.axis, sides);
    const auto [inner, outer] = options.tolerances;
    const ClearMoves clear{surfaces, sides,
                           cutter,   options.link.axis,
                           inner,    inner == 0 ? widening_share * outer : 0};
    VerifiedPlan plan;
    std::vector<ToolPath> paths;
    VerifiedOptions own = options;
    for (std::size_t number = 0; number < surfaces.size(); ++number) {
        const auto before = double(number) / double(surfaces.size());
        if (options.progress)
            own.progress = [&](double share) {
                options.progress(before + share / double(surfaces.size()));
            };
        const MarchedSurface marched =
            marched_surface(surfaces[number], sides[number], options.direction);
        VerifiedStrips strips = verified_strips(marched, clear, own);
        for (const SurfacePoint& at : strips.uncovered)
            plan.uncovered.push_back({static_cast<int>(number),
                                      in_surface_order(at, options.direction),
                                      marched.surface.tangents(at.u, at.v).point});
        LinkedPath path =
            linked(pieces_in_order(std::move(strips.passes), options), clear, options);
        own.most_points -= std::min(own.most_points, path.path.points.size());
        plan.lifted_links += path.lifted_links;
        paths.push_back(std::move(path.path));
    }
    plan.path =
        paths.size() == 1 ? std::move(paths.front()) : join_paths(paths, options.link);
    if (plan.path.points.empty())
        throw GeometryError{
            "the ball fits nowhere on the part without entering it by "
            "more than the inner tolerance"};
    return plan;
}

}  // namespace endmill
