// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/interference/trimmed_planes.h"

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/interference/clipped_sections.h"

namespace endmill {

std::vector<Trimmed> trim_planes(std::span<const PlaneSection> planes,
                                 std::span<const std::optional<Interval>> ranges,
                                 const TrimmingMethod& method,
                                 const TrimmingOptions& options)
{
    require(ranges.empty() || ranges.size() == planes.size(),
            "trim_planes: need a range for each plane, or none");
    std::vector<Trimmed> trimmed(planes.size());
    parallel_for(planes.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            Trimmed& plane = trimmed[k];
            plane = method.trim(planes[k].curves, options);
            if (!ranges.empty())
                plane.curves = ranges[k] ? clipped(plane.curves, *ranges[k])
                                         : std::vector<TrimmedCurve>{};
        }
    });
    return trimmed;
}

}  // namespace endmill
