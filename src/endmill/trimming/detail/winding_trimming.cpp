// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/winding_trimming.h"

#include <algorithm>
#include <utility>

#include "endmill/trimming/detail/trimmed_points.h"
#include "endmill/trimming/detail/winding_border.h"

namespace endmill {
namespace {

std::pair<double, double> place(const TrimmedPoint& point)
{
    return {point.at[0], point.at[1]};
}

TrimmedPoint point_at(const BorderPlace& border_place, const TrimmedPoints& made)
{
    switch (border_place.kind) {
        case TrimmedKind::Crossing:
            return made.crossing(border_place.on, border_place.across);
        case TrimmedKind::Link:
            return made.link(border_place.on, border_place.across);
        case TrimmedKind::Vertex:
        case TrimmedKind::End:
            break;
    }
    return made.vertex(border_place.on);
}

// Lets a closed curve begin and end at its smallest point.
void close(TrimmedCurve& curve)
{
    auto& points = curve.points;
    curve.is_closed = true;
    if (points.size() > 1 && points.front().at == points.back().at)
        points.pop_back();
    std::rotate(points.begin(), std::ranges::min_element(points, {}, place),
                points.end());
    if (points.size() > 1)
        points.push_back(points.front());
}

TrimmedCurve curve_along(const WindingBorder& border, const TrimmedPoints& made)
{
    TrimmedCurve curve;
    for (const BorderPlace& border_place : border.places)
        append(curve, point_at(border_place, made));
    if (border.is_closed)
        close(curve);
    return curve;
}

}  // namespace

Trimmed winding_trimming(std::span<const SectionCurve> curves,
                         const TrimmingOptions& /*options*/)
{
    const PlanePoints plane{curves};
    const TrimmedPoints made{plane};
    Trimmed trimmed;
    trimmed.rule = "winding number";
    for (const WindingBorder& border : winding_borders(plane, curves))
        trimmed.curves.push_back(curve_along(border, made));
    std::erase_if(trimmed.curves,
                  [](const TrimmedCurve& curve) { return curve.points.size() < 2; });
    std::ranges::stable_sort(trimmed.curves, {}, [](const TrimmedCurve& curve) {
        return place(*std::ranges::min_element(curve.points, {}, place));
    });
    return trimmed;
}

}  // namespace endmill
