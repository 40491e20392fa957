// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

class DropTree;

/// The contact of a cutter that was lowered along -z onto a mesh.
struct DropContact {
    double tip_z;  ///< height of the tip, mm
    Vec3 point;    ///< the contact point, mm; one of them if there are several
    /// Number of the touched triangle; the lowest number if there are several.
    std::size_t triangle;
};

/// The drop cutter: lowers a cutter along -z onto a mesh. Over (x, y) the tip stops at
/// the height
///
///     max of q_z - h(rho) over all points q of the mesh with rho = |q_xy - (x, y)| <= R,
///
/// where h is the profile of the cutter. Facets of either orientation count, and so do
/// their sides and corners. No point of the mesh is therefore inside the cutter. The
/// reference point is r higher than the tip.
/// Source: docs/methods/interference.md, section 6 (R3).
///
/// Accuracy: 1e-9 mm for coordinates within 1e4 mm and radii within 1e3 mm. A result
/// depends on mesh, cutter and position only, not on hints, on the order of calls or on
/// the number of threads. A call takes a few microseconds. The object takes about 41
/// bytes per triangle, and 5 more unless the cutter is a ball. It is an immutable value
/// that refers to the mesh.
class DropCutter {
public:
    /// \param mesh the part; it must outlive this object.
    /// \param cutter the cutter.
    /// \throws DomainError if a coordinate exceeds 1e9 mm or the cutter's radius is not
    ///     within 1e-6 … 1e6 mm.
    DropCutter(const TriangleMesh& mesh, const Cutter& cutter);
    // the mesh would not outlive this object
    DropCutter(TriangleMesh&&, const Cutter&) = delete;

    /// The cutter.
    const Cutter& cutter() const;
    /// The mesh.
    const TriangleMesh& mesh() const;

    /// The contact over one position.
    /// \param place x and y of the axis, mm.
    /// \param hint a triangle that the cutter probably touches, such as that of a
    ///     neighbouring position; it only saves time.
    /// \return nothing if no point of the mesh is below the cutter.
    /// \throws DomainError unless the position is finite and the hint is the number of a
    ///     triangle.
    std::optional<DropContact> contact(const Eigen::Vector2d& place,
                                       std::optional<std::size_t> hint = {}) const;

    /// The contacts over many positions, on all threads. Positions along a path are the
    /// fastest.
    std::vector<std::optional<DropContact>> contacts(
        std::span<const Eigen::Vector2d> places) const;

    /// The heights of the tip over many positions, on all threads; minus infinity where
    /// no point of the mesh is below the cutter.
    std::vector<double> tip_heights(std::span<const Eigen::Vector2d> places) const;

    /// Whether the mesh rises into the cutter by at most `tolerance`, measured along the
    /// axis, during a straight move of the tip. The test bounds the rise and does not
    /// sample it. True is certain; false may also be returned if the rise is just below
    /// the tolerance.
    /// \param from start of the tip in mm, within 2 R of the mesh's box in plan.
    /// \param to end of the tip in mm, within 2 R of the mesh's box in plan.
    /// \param tolerance in mm, > 0.
    /// \throws DomainError unless these conditions hold.
    bool is_clear(const Vec3& from, const Vec3& to, double tolerance) const;

    /// The search tree over the mesh, for other units of this module.
    const DropTree& tree() const { return *tree_; }

private:
    std::shared_ptr<const DropTree> tree_;
};

}  // namespace endmill
