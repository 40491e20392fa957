// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/detail/contact_cones.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "endmill/core/error.h"
#include "endmill/visibility/sphere_grid.h"

namespace endmill {
namespace {

// 1200 cells, the number of [KangSuh]; the largest has a radius of 5 degrees.
constexpr const char* grid_name = "hex:10";

}  // namespace

ContactCones::ContactCones(const TriangleMesh& mesh, double offset)
    : tree_{mesh},
      offset_{offset}
{
    require(offset > 0, "ContactCones: need a positive offset");
    const SphereGrid grid = sphere_grid(grid_name);
    centres_ = grid.centres;
    double least = 1;
    for (std::size_t cell = 0; cell < grid.cells.size(); ++cell)
        for (const auto corner : grid.cells[cell])
            least = std::min(least, grid.centres[cell].dot(
                                        grid.corners[static_cast<std::size_t>(corner)]));
    cell_radius_ = std::acos(least);
}

ContactCones::Hidden ContactCones::hidden(const CutterContact& contact,
                                          double most_lean) const
{
    const double lowest = std::cos(std::min(std::numbers::pi, most_lean + cell_radius_));
    const Vec3 start = contact.point + offset_ * contact.normal;
    Hidden found;
    for (const Vec3& centre : centres_) {
        const double up = centre.dot(contact.normal);
        if (up > lowest && (up <= 0 || tree_.any_hit({start, centre})))
            found.push_back(centre);
    }
    return found;
}

bool ContactCones::is_seen(const Hidden& hidden, const Vec3& axis) const
{
    const double near = std::cos(cell_radius_);
    return std::ranges::none_of(
        hidden, [&](const Vec3& centre) { return centre.dot(axis) > near; });
}

}  // namespace endmill
