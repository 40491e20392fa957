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

std::optional<CutRay> cut_ray(const StraightSweep& sweep, const PartRay& ray,
                              double before)
{
    const auto entry = sweep_entry(sweep, {ray.point, ray.normal}, before);
    if (!entry)
        return std::nullopt;
    double thickness = entry->t;
    if (thickness < 0 && !clears(sweep, ray.point)) {
        if (thickness < -touching_depth || before <= 0)
            return std::nullopt;
        thickness = 0;
    }
    return CutRay{thickness, slope_of_cosine(entry->normal.dot(ray.normal)), -1};
}

}  // namespace endmill
