// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/cut_ray.h"

#include <algorithm>
#include <cmath>

#include "endmill/cutter/detail/sweep_entry.h"

namespace endmill {

double slope_of_cosine(double cosine)
{
    const double c = std::abs(cosine);
    return c > 0 ? std::sqrt(std::max(0.0, (1 - c) * (1 + c))) / c
                 : std::numeric_limits<double>::infinity();
}

std::optional<MownRay> mown(const StraightSweep& sweep, const PartRay& ray, double before)
{
    const auto entry = sweep_entry(sweep, {ray.point, ray.normal}, before);
    if (!entry)
        return std::nullopt;
    double left = entry->t;
    if (left < 0 && !clears(sweep, ray.point)) {
        if (left < -touching || before <= 0)
            return std::nullopt;
        left = 0;
    }
    return MownRay{left, slope_of_cosine(entry->normal.dot(ray.normal)), -1};
}

}  // namespace endmill
