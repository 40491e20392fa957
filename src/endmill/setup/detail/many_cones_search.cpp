// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/many_cones_search.h"

#include <limits>
#include <utility>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/setup/detail/axis_search.h"

namespace endmill {
namespace {

/// The result without any cone: every pose fits, here the part stands upright.
WholeConeSearchResult nothing_to_reach(RotaryFamily family)
{
    WholeConeSearchResult result;
    result.machinable = Answer::Yes;
    const bool is_ca = family == RotaryFamily::CA;
    const SetupPose upright{Vec3::UnitZ(), is_ca ? Vec3::UnitZ() : Vec3::UnitX(),
                            is_ca ? Vec3::UnitX() : Vec3::UnitY()};
    result.pose = FittedPose{.pose = upright, .phi = {0, 0}, .theta = {0, 0}, .area = 0};
    return result;
}

}  // namespace

WholeConeSearchResult many_cones_search(const SphereGrid& grid, const VisibilityMap& map,
                                        const WholeConeSearchOptions& options,
                                        std::size_t few)
{
    require(map.cells() == grid.centres.size(),
            "many_cones_search: map and grid differ in cells");
    require(options.floor_rad > 0, "many_cones_search: need floor_rad > 0");
    require(options.gap > 0, "many_cones_search: need gap > 0");
    require(few >= 4, "many_cones_search: need 4 <= few");
    const MinimalCones cones{grid, map};
    if (cones.size() == 0)
        return nothing_to_reach(options.family);
    std::vector<std::size_t> first(cones.size() <= few ? cones.size() : few / 4);
    for (std::size_t k = 0; k < first.size(); ++k)
        first[k] = k * cones.size() / first.size();
    return axis_search(grid, cones, std::move(first), options);
}

WholeConeSearchResult whole_cone_search(const SphereGrid& grid, const VisibilityMap& map,
                                        const WholeConeSearchOptions& options)
{
    return many_cones_search(grid, map, options, std::numeric_limits<std::size_t>::max());
}

}  // namespace endmill
