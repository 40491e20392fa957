// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/interference/refined_planes.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/interference/refined_sections.h"
#include "endmill/interference/surface_gap.h"

namespace endmill {
namespace {

constexpr double pieces_per_radius = 2;

// Gives each thread its own test of whether the cutter may stand somewhere.
using MakeAdmissible = std::function<IsAdmissible()>;

std::vector<RefinedCurves> refine_all(const SectionSource& source,
                                      std::span<const Trimmed> trimmed,
                                      const MakeAdmissible& make_admissible)
{
    const std::vector<double>& positions = source.planes.positions;
    require(trimmed.size() == source.sections.size() &&
                positions.size() == source.sections.size(),
            "refine_planes: need as many planes as sections");
    const SmoothOffset smooth{source.offset, source.surfaces, source.grid_lines};
    std::vector<RefinedCurves> all(trimmed.size());
    parallel_for(trimmed.size(), [&](std::size_t begin, std::size_t end) {
        const IsAdmissible is_admissible = make_admissible();
        for (std::size_t k = begin; k < end; ++k)
            all[k] = refined(trimmed[k].curves, {source.sections[k], positions[k]},
                             source.planes.frame, smooth, is_admissible);
    });
    return all;
}

// Whether the cutter enters the part by no more than `refined_gouge`.
class GougeCheck {
public:
    explicit GougeCheck(const SectionSource& source)
        : cutter_{source.offset.cutter},
          tree_{source.surfaces, cutter_.radius() / pieces_per_radius}
    {
    }

    bool holds(const Vec3& reference, FinerPieces& finer) const
    {
        return !has_gap_below(tree_, CutterCore{cutter_, reference}, refined_gouge / 10,
                              -refined_gouge, finer);
    }

private:
    const Cutter& cutter_;
    PieceTree tree_;
};

}  // namespace

RefinedPlanes refine_planes(const SectionSource& source, std::span<const Trimmed> trimmed)
{
    const GougeCheck check{source};
    const auto make_admissible = [&]() -> IsAdmissible {
        return [&, finer = FinerPieces{}](const Vec3& reference, double) mutable {
            return check.holds(reference, finer);
        };
    };
    RefinedPlanes result;
    for (RefinedCurves& plane : refine_all(source, trimmed, make_admissible)) {
        result.curves.push_back(std::move(plane.curves));
        result.unrefined += plane.unrefined;
        result.greatest_shift = std::max(result.greatest_shift, plane.greatest_shift);
    }
    return result;
}

// Only a shift that would be the greatest needs its place looked at, which takes time.
double sampling_error(const SectionSource& source, std::span<const Trimmed> trimmed)
{
    const GougeCheck check{source};
    const auto make_admissible = [&]() -> IsAdmissible {
        return [&, finer = FinerPieces{}, greatest = 0.0](const Vec3& reference,
                                                          double shift) mutable {
            if (shift <= greatest)
                return true;
            if (!check.holds(reference, finer))
                return false;
            greatest = shift;
            return true;
        };
    };
    double greatest = 0;
    for (const RefinedCurves& plane : refine_all(source, trimmed, make_admissible))
        greatest = std::max(greatest, plane.greatest_shift);
    return greatest;
}

}  // namespace endmill
