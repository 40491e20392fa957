// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/trimmed_planes.h"

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/trimming/detail/clipped_sections.h"
#include "endmill/trimming/detail/section_runs.h"

namespace endmill {
namespace {

constexpr std::string_view range_rule = "outside the range";

// The vertices of curves, by curve and number.
using HeldVertices = std::vector<std::vector<bool>>;

HeldVertices held_vertices(const std::vector<TrimmedCurve>& left,
                           std::span<const SectionCurve> curves)
{
    HeldVertices held;
    for (const SectionCurve& curve : curves)
        held.emplace_back(curve.points.size(), false);
    for (const TrimmedCurve& curve : left)
        for (const TrimmedPoint& point : curve.points)
            if (point.kind == TrimmedKind::Vertex)
                held[point.on.curve][point.on.point] = true;
    for (std::size_t c = 0; c < curves.size(); ++c)
        if (curves[c].is_closed)  // its ends are one point
            held[c].front() = held[c].back() = held[c].front() || held[c].back();
    return held;
}

// A rule for each stretch of a curve whose vertices went.
void name_what_went(const HeldVertices& before, const HeldVertices& after,
                    std::vector<AppliedRule>& rules)
{
    for (std::size_t c = 0; c < before.size(); ++c) {
        const auto went = [&](std::size_t k) { return before[c][k] && !after[c][k]; };
        for (std::size_t first = 0; first < before[c].size(); ++first) {
            if (!went(first))
                continue;
            std::size_t last = first;
            while (last + 1 < before[c].size() && went(last + 1))
                ++last;
            rules.push_back({static_cast<std::int32_t>(c),
                             static_cast<std::int32_t>(first),
                             static_cast<std::int32_t>(last), range_rule});
            first = last;
        }
    }
}

// Of folds that a method left those that are still there.
int folds_left(const std::vector<TrimmedCurve>& left,
               std::span<const SectionCurve> curves)
{
    int count = 0;
    for (const TrimmedCurve& curve : left) {
        const SectionCurve& section = curves[curve.points.front().on.curve];
        count += backward_runs(curve.points, dead_band(section.points));
    }
    return count;
}

void cut_off(const std::optional<Interval>& range, std::span<const SectionCurve> curves,
             Trimmed& trimmed)
{
    const HeldVertices before = held_vertices(trimmed.curves, curves);
    trimmed.curves =
        range ? clipped(trimmed.curves, *range) : std::vector<TrimmedCurve>{};
    name_what_went(before, held_vertices(trimmed.curves, curves), trimmed.rules);
    if (trimmed.unresolved > 0)
        trimmed.unresolved = folds_left(trimmed.curves, curves);
}

}  // namespace

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
                cut_off(ranges[k], planes[k].curves, plane);
        }
    });
    return trimmed;
}

}  // namespace endmill
