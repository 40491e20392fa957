// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/simulation/part_distance.h"

#include "endmill/surface/sampling.h"

namespace endmill {

PartDistance::PartDistance(const PartCharts& charts, double chord_tolerance)
{
    if (charts.mesh()) {
        tree_.emplace(*charts.mesh());
        return;
    }
    SampledSurface sampling = sampled(charts.surfaces(), charts.sides(), chord_tolerance);
    sampled_ = std::move(sampling.mesh);
    chord_error_ = sampling.max_chord_error_mm;
    tree_.emplace(sampled_);
}

double PartDistance::operator()(const Vec3& place) const
{
    return tree_->nearest(place)->distance + chord_error_;
}

}  // namespace endmill
