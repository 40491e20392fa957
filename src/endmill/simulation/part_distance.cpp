// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/simulation/part_distance.h"

#include "endmill/surface/sampling.h"

namespace endmill {

PartDistance::PartDistance(const PartCharts& charts, double chord_tolerance)
    : charts_{charts},
      chord_tolerance_{chord_tolerance}
{
}

void PartDistance::build() const
{
    if (charts_.mesh()) {
        tree_.emplace(*charts_.mesh());
        return;
    }
    SampledSurface sampling =
        sampled(charts_.surfaces(), charts_.sides(), chord_tolerance_);
    sampled_ = std::move(sampling.mesh);
    chord_error_ = sampling.max_chord_error_mm;
    tree_.emplace(sampled_);
}

double PartDistance::operator()(const Vec3& place, std::optional<std::size_t>& hint) const
{
    std::call_once(is_built_, [this] { build(); });
    const auto nearest = tree_->nearest(place, hint);
    hint = nearest->triangle;
    return nearest->distance + chord_error_;
}

}  // namespace endmill
