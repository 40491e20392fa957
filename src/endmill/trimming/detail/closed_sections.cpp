// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/closed_sections.h"

#include <algorithm>

#include "endmill/core/orientation.h"
#include "endmill/trimming/detail/envelope_trimming.h"

namespace endmill {
namespace {

bool is_behind(double s, const TrimmedPoint& point)
{
    return s < point.at.x();
}

// Whether `curve`, a curve of an upper envelope, passes through `point` or above it.
bool covers(const TrimmedCurve& curve, const SectionPoint& point)
{
    const auto& points = curve.points;
    const auto behind =
        std::upper_bound(points.begin(), points.end(), point.x(), is_behind);
    if (behind == points.begin())
        return false;
    // All points of the curve over the same s, which are the ends of vertical links.
    for (auto at = behind; at != points.begin() && (at - 1)->at.x() == point.x(); --at) {
        if ((at - 1)->at.y() >= point.y())
            return true;
    }
    return behind != points.end() &&
           orientation((behind - 1)->at, behind->at, point) <= 0;
}

bool has_point_above(const SectionCurve& curve, const Trimmed& open)
{
    return std::any_of(curve.points.begin(), curve.points.end(), [&](const auto& point) {
        return std::none_of(open.curves.begin(), open.curves.end(),
                            [&](const auto& other) { return covers(other, point); });
    });
}

// Appends the upper envelope of one closed curve. `number` is its number in the plane,
// which replaces the 0 that envelope_trimming uses for a single curve.
void append_envelope(const SectionCurve& curve, std::int32_t number, Trimmed& trimmed)
{
    Trimmed envelope = envelope_trimming({&curve, 1});
    trimmed.rule = envelope.rule;
    for (TrimmedCurve& part : envelope.curves) {
        for (TrimmedPoint& point : part.points)
            point.on.curve = point.across.curve = number;
        trimmed.curves.push_back(std::move(part));
    }
}

}  // namespace

Trimmed trim_closed(std::span<const SectionCurve> curves)
{
    std::vector<SectionCurve> open_curves;
    std::copy_if(curves.begin(), curves.end(), std::back_inserter(open_curves),
                 [](const SectionCurve& curve) { return !curve.is_closed; });
    const Trimmed open = open_curves.empty() ? Trimmed{} : envelope_trimming(open_curves);

    Trimmed result;
    for (std::size_t number = 0; number < curves.size(); ++number) {
        const SectionCurve& curve = curves[number];
        if (!curve.is_closed)
            continue;
        const auto index = static_cast<std::int32_t>(number);
        const auto last = static_cast<std::int32_t>(curve.points.size()) - 1;
        if (has_point_above(curve, open))
            append_envelope(curve, index, result);
        else
            result.rules.push_back({index, 0, last, "closed"});
    }
    return result;
}

}  // namespace endmill
