// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/part_facets.h"

#include <algorithm>
#include <array>

#include <Eigen/Geometry>

#include <CGAL/Exact_rational.h>

#include "endmill/core/orientation.h"
#include "endmill/core/parallel.h"

namespace endmill {
namespace {

// The direction of the exact cross product, for slivers whose sides are parallel up to
// rounding.
Vec3 exact_normal(const std::array<Vec3, 3>& corners)
{
    using Rational = CGAL::Exact_rational;
    const auto side = [&](int to, int axis) -> Rational {
        return Rational{corners[to][axis]} - Rational{corners[0][axis]};
    };
    std::array<Rational, 3> cross;
    Rational largest = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const int next = (axis + 1) % 3;
        const int last = (axis + 2) % 3;
        cross[axis] = side(1, next) * side(2, last) - side(1, last) * side(2, next);
        largest = std::max(largest, Rational{CGAL::abs(cross[axis])});
    }
    if (largest == 0)
        return Vec3::Zero();
    return Vec3{CGAL::to_double(Rational{cross[0] / largest}),
                CGAL::to_double(Rational{cross[1] / largest}),
                CGAL::to_double(Rational{cross[2] / largest})}
        .normalized();
}

// The sides are normalised first, so that the cross product of tiny or huge facets stays
// in the range of a double.
Vec3 normal_of(const std::array<Vec3, 3>& corners)
{
    const auto& [a, b, c] = corners;
    const Vec3 normal =
        (b - a).stableNormalized().cross((c - a).stableNormalized()).stableNormalized();
    return normal.isZero(0) ? exact_normal(corners) : normal;
}

}  // namespace

PartFacets part_facets(const TriangleMesh& part)
{
    PartFacets facets;
    facets.normals.assign(part.triangles().size(), Vec3::Zero());
    facets.centroids.resize(part.triangles().size());
    parallel_for(facets.normals.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t facet = begin; facet < end; ++facet) {
            const auto corners = part.corners(facet);
            facets.centroids[facet] = corners[0] / 3 + corners[1] / 3 + corners[2] / 3;
            if (!are_collinear(corners[0], corners[1], corners[2]))
                facets.normals[facet] = normal_of(corners);
        }
    });
    for (std::size_t facet = 0; facet < facets.normals.size(); ++facet)
        if (!facets.has_area(facet))
            facets.dropped.push_back(facet);
    return facets;
}

}  // namespace endmill
