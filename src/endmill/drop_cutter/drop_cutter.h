// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/drop_cutter/detail/triangle_drop.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

class DropTree;

/// Where a cutter comes to rest that is lowered along -z onto a mesh.
struct DropContact {
    double tip_z;          ///< mm
    Vec3 point;            ///< where it touches, mm; one of several if it does so in more
    std::size_t triangle;  ///< that it touches; of several the one of the lowest number
    TouchKind kind;        ///< which part of that triangle
};

/// Lowers a cutter onto a mesh. Its tip over (x, y) comes to rest at
///     max of q_z - h(rho) over all points q of the mesh with rho = |q_xy - (x, y)| <= R,
/// h the cutter's profile: over all facets, sides and corners, whichever way they face, so
/// that nothing of the mesh is ever within the cutter. Reference points are r higher.
/// Source: spec of interference, R3.
///
/// Right to 1e-9 mm for coordinates within 1e4 mm and radii within 1e3 mm. Answers depend
/// on mesh, cutter and place only, not on hints, on the order of questions or on threads.
/// Some microseconds each; takes about 41 bytes a triangle (5 more unless the cutter is a
/// ball). An immutable value that refers to the mesh, which must outlive it.
class DropCutter {
public:
    /// \throws DomainError if a coordinate of a point is above 1e9 mm, or the cutter's
    ///         radius is not within 1e-6 … 1e6 mm.
    DropCutter(const TriangleMesh& mesh, const Cutter& cutter);
    DropCutter(TriangleMesh&&, const Cutter&) = delete;  // it would not outlive this

    const Cutter& cutter() const;
    const TriangleMesh& mesh() const;

    /// \param place x and y of the axis, mm. \param hint a triangle that may be touched,
    ///        such as that of a neighbouring place: the answer comes sooner.
    /// \return nothing if there is nothing of the mesh beneath the cutter.
    /// \throws DomainError unless the place is finite and the hint a triangle.
    std::optional<DropContact> contact(const Eigen::Vector2d& place,
                                       std::optional<std::size_t> hint = {}) const;

    /// The same for many places, on all threads; soonest where they follow paths.
    std::vector<std::optional<DropContact>> contacts(
        std::span<const Eigen::Vector2d> places) const;

    /// Heights of the tip over many places, on all threads; minus infinity where nothing
    /// is beneath the cutter.
    std::vector<double> tip_heights(std::span<const Eigen::Vector2d> places) const;

    /// Whether on the straight move of the tip `from` … `to` the mesh nowhere rises into the
    /// cutter by more than `tolerance`, measured along the axis. Bounded, not sampled: a
    /// move that is said to be clear is; of one that barely is, the answer may be no.
    /// \param from, to in mm, over the mesh's box in plan grown by 2 R.
    /// \param tolerance in mm, > 0.
    /// \throws DomainError if they are not.
    bool is_clear(const Vec3& from, const Vec3& to, double tolerance) const;

    /// What it keeps of the mesh; for others in this module.
    const DropTree& tree() const { return *tree_; }

private:
    std::shared_ptr<const DropTree> tree_;
};

}  // namespace endmill
