// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "endmill/cutter/cutter.h"
#include "endmill/drop_cutter/drop_cutter.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// Which places of a mesh a cutter reaches along some fixed axes. An immutable value; all
/// threads may use it.
class AxisReach {
public:
    /// \param part   the mesh.
    /// \param cutter the cutter; its shank has no upper end.
    /// \param axes   unit, from the part to the spindle.
    /// \throws DomainError as DropCutter.
    AxisReach(const TriangleMesh& part, const Cutter& cutter, std::span<const Vec3> axes);

    std::size_t axes() const { return stands_.size(); }  ///< number of axes

    /// Whether the cutter, held along an axis, comes within `distance` mm of a place without
    /// entering the mesh, as `is_accessible` for +z. It reaches no place that faces away.
    /// \param axis  number of the axis. \param place on the mesh; unit normal.
    bool reaches(std::size_t axis, const CutterContact& place, double distance) const;

    /// Whether it does so along any of the axes.
    bool reaches(const CutterContact& place, double distance) const;

private:
    // The mesh as it stands with an axis upright.
    struct Stand {
        Eigen::Matrix3d rotation;
        std::shared_ptr<const TriangleMesh> mesh;
        std::shared_ptr<const DropCutter> drop_cutter;
    };
    std::vector<Stand> stands_;
};

}  // namespace endmill
