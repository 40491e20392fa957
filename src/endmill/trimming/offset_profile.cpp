// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/profile_families.h"

#include <cmath>

#include "endmill/core/error.h"

namespace endmill {

SectionCurve offset_curve(const OffsetProfile& profile, int points)
{
    require(points >= 2, "offset_curve: need two points");
    require(profile.from < profile.to, "offset_curve: need from < to");
    require(profile.radius > 0, "offset_curve: need 0 < radius");
    const double R = profile.radius;
    SectionCurve curve;
    curve.points.reserve(static_cast<std::size_t>(points));
    for (int i = 0; i < points; ++i) {
        const double x = profile.from + (profile.to - profile.from) * i / (points - 1);
        const double m = profile.slope(x);
        const double w = std::sqrt(1 + m * m);
        const SectionPoint point{x - R * m / w, profile.height(x) + R / w};
        if (curve.points.empty() || point != curve.points.back())
            curve.points.push_back(point);
    }
    return curve;
}

}  // namespace endmill
