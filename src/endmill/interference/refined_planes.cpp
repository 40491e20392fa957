// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/interference/refined_planes.h"

#include <algorithm>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/interference/refined_sections.h"
#include "endmill/interference/surface_gap.h"

namespace endmill {
namespace {

constexpr double pieces_per_radius = 2;

}  // namespace

RefinedPlanes refine_planes(const SectionSource& source, std::span<const Trimmed> trimmed)
{
    const auto& [surfaces, offset, grid_lines, planes, sections] = source;
    require(
        trimmed.size() == sections.size() && planes.positions.size() == sections.size(),
        "refine_planes: need as many planes as sections");
    const SmoothOffset smooth{offset, surfaces, grid_lines};
    const Cutter& cutter = offset.cutter;
    const PieceTree tree{surfaces, cutter.radius() / pieces_per_radius};
    std::vector<RefinedCurves> refined_curves(trimmed.size());
    parallel_for(trimmed.size(), [&](std::size_t begin, std::size_t end) {
        FinerPieces finer;
        const IsAdmissible is_admissible = [&](const Vec3& reference) {
            return !surface_gap(tree, CutterCore{cutter, reference}, refined_gouge / 10,
                                -refined_gouge, finer);
        };
        for (std::size_t k = begin; k < end; ++k)
            refined_curves[k] = refined(trimmed[k].curves, sections[k], planes.frame,
                                        planes.positions[k], smooth, is_admissible);
    });
    RefinedPlanes result;
    for (RefinedCurves& plane : refined_curves) {
        result.curves.push_back(std::move(plane.curves));
        result.unrefined += plane.unrefined;
        result.greatest_shift = std::max(result.greatest_shift, plane.greatest_shift);
    }
    return result;
}

}  // namespace endmill
