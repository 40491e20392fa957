// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/cell_circles.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "endmill/machine/axis_limits.h"

namespace endmill {
namespace {

/// Sine of the angle between two cells below which they count as opposite. Cells of a grid
/// are at least 1e-3 rad apart.
constexpr double opposite = 1e-6;

/// rad, and a chord: covers the rounding of unit vectors and products, 1e-15.
constexpr double rounding = 1e-12;

/// The cells that may lie on a circle with its normal in the disc.
std::vector<Vec3> cells_along(std::span<const Vec3> centres, const Vec3& middle,
                              double radius)
{
    std::vector<Vec3> along;
    for (const Vec3& centre : centres)
        if (std::abs(centre.dot(middle)) <= radius + rounding)
            along.push_back(centre);
    return along;
}

}  // namespace

std::vector<Vec3> cell_circles(std::span<const Vec3> centres, const Vec3& middle,
                               double radius, std::size_t most)
{
    const std::vector<Vec3> along = cells_along(centres, middle, radius);
    std::vector<Vec3> normals;
    for (std::size_t a = 0; a < along.size(); ++a)
        for (std::size_t b = a + 1; b < along.size(); ++b) {
            const Vec3 product = along[a].cross(along[b]);
            if (product.norm() < opposite)
                continue;
            const Vec3 normal =
                (product.dot(middle) < 0 ? Vec3{-product} : product).normalized();
            const auto is_known = [&](const Vec3& known) {
                return (known - normal).norm() <= turn_tolerance;
            };
            if ((normal - middle).norm() > radius + rounding ||
                std::ranges::any_of(normals, is_known))
                continue;
            if (normals.size() == most)
                return {};
            normals.push_back(normal);
        }
    return normals;
}

}  // namespace endmill
