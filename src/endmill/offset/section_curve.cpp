// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/section_curve.h"

#include <algorithm>
#include <utility>

namespace endmill {
namespace {

bool is_before(const SectionPoint& a, const SectionPoint& b)
{
    return std::pair{a.x(), a.y()} < std::pair{b.x(), b.y()};
}

void turn(SectionCurve& curve)
{
    auto& points = curve.points;
    if (!curve.is_closed) {
        if (points.front().x() > points.back().x())
            std::ranges::reverse(points);
        return;
    }
    points.pop_back();
    std::rotate(points.begin(), std::ranges::min_element(points, is_before),
                points.end());
    points.push_back(points.front());
}

}  // namespace

std::vector<SectionCurve> arranged(std::vector<SectionCurve> curves)
{
    std::ranges::for_each(curves, turn);
    std::vector<std::pair<SectionPoint, SectionCurve>> keyed;
    for (SectionCurve& curve : curves) {
        const SectionPoint least = *std::ranges::min_element(curve.points, is_before);
        keyed.emplace_back(least, std::move(curve));
    }
    std::ranges::stable_sort(
        keyed, [](const auto& a, const auto& b) { return is_before(a.first, b.first); });
    std::ranges::transform(keyed, curves.begin(),
                           [](auto& pair) { return std::move(pair.second); });
    return curves;
}

}  // namespace endmill
