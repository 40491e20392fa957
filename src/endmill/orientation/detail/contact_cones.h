// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/mesh/triangle_tree.h"

namespace endmill {

/// Visibility cones of contacts: the cells of the sphere of directions along which a ray from a
/// contact leaves the part, eroded by the radius of a cell.
///
/// The visibility map of module `visibility` has the cones of facets at their centroids. A contact
/// may be far from the centroid of a large facet, so it has a cone of its own here. An immutable
/// value that refers to the mesh; queries may run on several threads.
/// Source: docs/methods/five-axis-planning.md, section 5.
class ContactCones {
public:
    /// \param mesh   of the part; it must outlive the object.
    /// \param offset distance in mm of a ray's start from its contact along the normal, positive;
    ///        at least that of the contacts from the mesh.
    ContactCones(const TriangleMesh& mesh, double offset);
    // deleted: the mesh would not outlive the object
    ContactCones(TriangleMesh&&, double) = delete;

    /// Centres of cells outside the cone.
    using Hidden = std::vector<Vec3>;

    /// The cells outside the cone of a contact that matter to axes which lean by at most
    /// `most_lean` rad against the normal.
    /// \param contact point and unit normal.
    Hidden hidden(const CutterContact& contact, double most_lean) const;

    /// Whether an axis is in the eroded cone: no hidden cell has its centre within the radius of
    /// a cell from it.
    /// \param axis unit, with a lean of at most that of the hidden cells.
    bool is_seen(const Hidden& hidden, const Vec3& axis) const;

    /// The radius of the largest cell in rad.
    double cell_radius() const { return cell_radius_; }

private:
    TriangleTree tree_;
    double offset_;
    std::vector<Vec3> centres_;
    double cell_radius_ = 0;
};

}  // namespace endmill
