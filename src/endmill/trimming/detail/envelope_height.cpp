// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/envelope_height.h"

#include <algorithm>
#include <cmath>

#include "endmill/trimming/detail/envelope_trimming.h"

namespace endmill {

EnvelopeHeight::EnvelopeHeight(std::span<const SectionCurve> curves)
{
    for (const TrimmedCurve& curve : envelope_trimming(curves).curves)
        for (std::size_t k = 0; k < curve.points.size(); ++k)
            points_.push_back({curve.points[k].at, k > 0});
}

std::optional<double> EnvelopeHeight::at(double s) const
{
    const auto is_before = [](const Point& point, double at) {
        return point.at.x() < at;
    };
    auto next = std::lower_bound(points_.begin(), points_.end(), s, is_before);
    std::optional<double> height;
    if (next != points_.begin() && next != points_.end() && next->is_joined) {
        const SectionPoint& before = (next - 1)->at;
        const double share = (s - before.x()) / (next->at.x() - before.x());
        height = std::lerp(before.y(), next->at.y(), share);
    }
    for (; next != points_.end() && next->at.x() == s; ++next)
        height = std::max(height.value_or(next->at.y()), next->at.y());
    return height;
}

}  // namespace endmill
