// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/refined_planes.h"

#include <algorithm>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/trimming/detail/refined_sections.h"

namespace endmill {
namespace {

// Calls refine(plane, section, finer) for all planes, on all threads.
template <typename Refine>
void for_each_plane(const SectionSource& source, std::span<const Trimmed> trimmed,
                    const Refine& refine)
{
    const std::vector<double>& positions = source.planes.positions;
    require(trimmed.size() == source.sections.size() &&
                positions.size() == source.sections.size(),
            "refine_planes: need as many planes as sections");
    const SmoothDrop drop{source.surfaces, source.offset.cutter};
    parallel_for(trimmed.size(), [&](std::size_t begin, std::size_t end) {
        FinerPieces finer;
        for (std::size_t k = begin; k < end; ++k)
            refine(k,
                   SampledSection{source.sections[k],
                                  {source.planes.frame, positions[k]},
                                  source.offset,
                                  drop},
                   finer);
    });
}

}  // namespace

RefinedPlanes refine_planes(const SectionSource& source, std::span<const Trimmed> trimmed)
{
    std::vector<RefinedCurves> all(trimmed.size());
    for_each_plane(source, trimmed,
                   [&](std::size_t k, const SampledSection& sampled, FinerPieces& finer) {
                       all[k] = refined(sampled, trimmed[k].curves, finer);
                   });
    RefinedPlanes result;
    for (RefinedCurves& plane : all) {
        result.curves.push_back(std::move(plane.curves));
        result.unrefined += plane.unrefined;
        result.greatest_shift = std::max(result.greatest_shift, plane.greatest_shift);
    }
    return result;
}

double sampling_error(const SectionSource& source, std::span<const Trimmed> trimmed)
{
    std::vector<double> shifts(trimmed.size());
    for_each_plane(source, trimmed,
                   [&](std::size_t k, const SampledSection& sampled, FinerPieces& finer) {
                       shifts[k] = greatest_shift(sampled, trimmed[k].curves, 0, finer);
                   });
    return shifts.empty() ? 0 : *std::ranges::max_element(shifts);
}

}  // namespace endmill
