// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <iterator>
#include <random>
#include <vector>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include "endmill/mesh/triangle_mesh.h"
#include "endmill/visibility/visibility.h"

namespace endmill {

/// CGAL's tree over a part's facets with exact arithmetic, the reference for answers.
class ExactRays {
public:
    explicit ExactRays(const TriangleMesh& part)
    {
        for (std::size_t facet = 0; facet < part.triangles().size(); ++facet) {
            const auto [a, b, c] = part.corners(facet);
            facets_.emplace_back(exact(a), exact(b), exact(c));
        }
        tree_.insert(facets_.begin(), facets_.end());
        tree_.build();
    }

    /// Whether the ray from a facet's exact centroid meets another facet.
    bool is_blocked(std::size_t facet, const Vec3& direction) const
    {
        const auto& own = facets_[facet];
        const Kernel::Ray_3 ray{
            CGAL::centroid(own[0], own[1], own[2]),
            Kernel::Vector_3{direction.x(), direction.y(), direction.z()}};
        std::vector<Tree::Primitive_id> met;
        tree_.all_intersected_primitives(ray, std::back_inserter(met));
        for (const auto& each : met)
            if (static_cast<std::size_t>(each - facets_.begin()) != facet)
                return true;
        return false;
    }

private:
    using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
    using Facets = std::vector<Kernel::Triangle_3>;
    using Primitive = CGAL::AABB_triangle_primitive<Kernel, Facets::const_iterator>;
    using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

    static Kernel::Point_3 exact(const Vec3& point)
    {
        return {point.x(), point.y(), point.z()};
    }

    Facets facets_;
    Tree tree_;
};

/// Number of random pairs of a facet and a direction that it faces for which the
/// visibility map and the exact rays give different answers. The generator is MT19937
/// with seed 7.
/// \param pairs number of pairs to test.
inline int disagreements(const TriangleMesh& part, const std::vector<Vec3>& directions,
                         int pairs)
{
    const VisibilityMap facing =
        part_visibility(part, directions, {.kind = VisibilityKind::Local}).map;
    const VisibilityMap seen = part_visibility(part, directions).map;
    const ExactRays rays{part};
    std::mt19937 random{7};
    int wrong = 0;
    for (int found = 0; found < pairs;) {
        const std::size_t facet = random() % facing.facets();
        const std::size_t cell = random() % facing.cells();
        if (!facing.is_accessible(facet, cell))
            continue;
        ++found;
        wrong +=
            seen.is_accessible(facet, cell) == rays.is_blocked(facet, directions[cell]);
    }
    return wrong;
}

}  // namespace endmill
