// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/covered_sets.h"

#include <algorithm>
#include <cmath>

#include "endmill/surface/extent.h"

namespace endmill {
namespace {

// Rays of a contact. On a disc the largest inflow is then too large by 0.03 %.
constexpr int least_rays = 72;
// Where D(x) is longer than its ellipse, the boundary turns faster at its end, by the
// square of the elongation. Rays are increased by this factor, up to 6.
constexpr double most_ray_factor = 6;
// Spacing of the sampled cells, as a share of the width of the disc on a plane.
constexpr double cells_share = 0.2;
// Most cells, about, so that memory stays below 100 MB.
constexpr double most_cells = 5e5;

double cell_spacing(const BoundedPart& part, const BoundProblem& problem)
{
    return std::max(cells_share * 2 * plane_half_width(problem),
                    std::sqrt(area(part.surfaces) / most_cells));
}

CoverRays rays_of(const BoundedPart& part, const BoundProblem& problem,
                  const ContactFrame& frame)
{
    CoverRays rays{part, problem, frame, least_rays};
    if (!rays.is_complete())
        return rays;
    const double elongation = rays.elongation();
    const double factor = std::min(most_ray_factor, std::round(elongation * elongation));
    if (factor <= 1)
        return rays;
    return {part, problem, frame, static_cast<int>(factor) * least_rays};
}

}  // namespace

CoveredSets::CoveredSets(const BoundedPart& part, const BoundProblem& problem)
    : part_{part},
      problem_{problem},
      cells_{part_, problem, cell_spacing(part, problem)}
{
}

std::optional<CoveredSets::Set> CoveredSets::set_at(const ContactPlace& place,
                                                    Want want) const
{
    const auto frame = contact_frame(part_, problem_, place);
    if (!frame)
        return std::nullopt;
    const CoverRays by_rays = rays_of(part_, problem_, *frame);
    const bool wants_pieces = want == Want::BoundaryAndPieces;
    if (by_rays.is_complete() && cells_.has_only(*frame, by_rays))
        return Set{*frame, by_rays.boundary(),
                   wants_pieces ? by_rays.covered() : std::vector<CoveredPiece>{}};
    return Set{*frame, cells_.boundary(*frame),
               wants_pieces ? cells_.covered(*frame) : std::vector<CoveredPiece>{}};
}

}  // namespace endmill
