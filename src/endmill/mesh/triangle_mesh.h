// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/core/vec.h"

namespace endmill {

/// A triangle by the numbers of its corners, counter-clockwise seen from outside.
using Triangle = std::array<std::int32_t, 3>;

/// An edge by the numbers of its ends, the lower one first.
using MeshEdge = std::array<std::int32_t, 2>;

/// Triangles over shared points. An immutable value of 12 bytes a triangle and 24 a
/// point. The topology is not checked: `mesh_report` examines it, `mesh_repair.h`
/// corrects it.
class TriangleMesh {
public:
    /// A mesh without triangles.
    TriangleMesh() = default;

    /// \param points    in mm.
    /// \param triangles numbers of points, from 0.
    /// \throws DomainError if a point is not finite, a number is out of range, or there
    ///         are more than 2^31 - 1 points or triangles.
    TriangleMesh(std::vector<Vec3> points, std::vector<Triangle> triangles);

    std::span<const Vec3> points() const { return points_; }  ///< in mm, as given
    std::span<const Triangle> triangles() const { return triangles_; }  ///< as given

    /// The three corners of triangle `number`, in mm.
    std::array<Vec3, 3> corners(std::size_t number) const
    {
        const auto& [a, b, c] = triangles_[number];
        return {points_[a], points_[b], points_[c]};
    }

    /// Fetches the corners of triangle `number` into the cache, if there is such a triangle.
    /// A pass over triangles in no order of place calls it some triangles in advance.
    void prefetch_corners(std::size_t number) const
    {
        if (number < triangles_.size())
            for (const std::int32_t corner : triangles_[number])
                __builtin_prefetch(&points_[corner]);
    }

private:
    std::vector<Vec3> points_;
    std::vector<Triangle> triangles_;
};

}  // namespace endmill
