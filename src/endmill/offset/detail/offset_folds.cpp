// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/detail/offset_folds.h"

#include <Eigen/Geometry>

#include "endmill/surface/curvature.h"

namespace endmill {

std::size_t folded_triangles(const TriangleMesh& mesh)
{
    std::size_t count = 0;
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k) {
        const auto [a, b, c] = mesh.corners(k);
        count += (b - a).cross(c - a).z() < 0 ? 1 : 0;
    }
    return count;
}

std::size_t too_concave_contacts(const OffsetMesh& offset,
                                 std::span<const Surface> surfaces)
{
    const double limit = -1 / offset.cutter.radius();
    std::size_t count = 0;
    for (const OffsetContact& contact : offset.contacts) {
        const Surface& surface = surfaces[static_cast<std::size_t>(contact.surface)];
        const auto forms =
            fundamental_forms(surface.jet(contact.at.u, contact.at.v), contact.normal);
        const PrincipalCurvatures curvatures = principal_curvatures(forms);
        count += curvatures.least < limit && curvatures.greatest > limit ? 1 : 0;
    }
    return count;
}

}  // namespace endmill
