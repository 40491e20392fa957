// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/adaptive_fit.h"

#include <algorithm>

namespace endmill {
namespace {

/// Most cones that join the set because a range misses them.
constexpr std::size_t cones_added = 4;

ConeFitting with_cones(ConeFitting fitting, const ConeSet& cones)
{
    fitting.cones = &cones;
    return fitting;
}

}  // namespace

AdaptiveFitter::AdaptiveFitter(const MinimalCones& cones, const ConeFitting& problem)
    : cones_{cones},
      is_in_set_(cones.size(), 0),
      columns_{cones.selected({})},
      fitting_{with_cones(problem, columns_)},
      fitter_{fitting_,
              [this](std::span<const std::uint32_t> reached) { return grow(reached); }}
{
}

void AdaptiveFitter::begin_with(std::span<const std::size_t> cones)
{
    if (std::ranges::equal(cones, set_))
        return;
    for (const std::size_t cone : set_)
        is_in_set_[cone] = 0;
    set_.assign(cones.begin(), cones.end());
    for (const std::size_t cone : set_)
        is_in_set_[cone] = 1;
    columns_ = cones_.selected(set_);
}

bool AdaptiveFitter::grow(std::span<const std::uint32_t> reached)
{
    if (set_.size() == cones_.size())
        return false;
    std::vector<std::size_t> missed = cones_.missed(reached);
    std::erase_if(missed, [this](std::size_t cone) { return is_in_set_[cone] != 0; });
    const std::size_t count = std::min(cones_added, missed.size());
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t cone = missed[k * missed.size() / count];
        set_.push_back(cone);
        is_in_set_[cone] = 1;
        cones_.add(columns_, cone);
    }
    return count > 0;
}

std::optional<AxisFit> AdaptiveFitter::best(const Vec3& axis, const FitRequest& request)
{
    return fitter_.best(axis, request);
}

}  // namespace endmill
