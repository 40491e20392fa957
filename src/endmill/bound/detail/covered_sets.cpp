// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/covered_sets.h"

#include <algorithm>
#include <cmath>

#include "endmill/surface/extent.h"

namespace endmill {
namespace {

// Rays of a contact. On a disc the largest inflow is then too large by 0.03 %.
constexpr int rays = 72;
// Spacing of the sampled cells, as a share of the width of the disc on a plane.
constexpr double cells_share = 0.2;
// Most cells, about, so that memory stays below 100 MB.
constexpr double most_cells = 5e5;

double cell_spacing(const BoundedPart& part, const BoundProblem& problem)
{
    return std::max(cells_share * 2 * plane_half_width(problem),
                    std::sqrt(area(part.surfaces) / most_cells));
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
    const CoverRays by_rays{part_, problem_, *frame, rays};
    const bool wants_pieces = want == Want::BoundaryAndPieces;
    if (by_rays.is_complete() && cells_.has_only(*frame, by_rays))
        return Set{*frame, by_rays.boundary(),
                   wants_pieces ? by_rays.covered() : std::vector<CoveredPiece>{}};
    return Set{*frame, cells_.boundary(*frame),
               wants_pieces ? cells_.covered(*frame) : std::vector<CoveredPiece>{}};
}

}  // namespace endmill
