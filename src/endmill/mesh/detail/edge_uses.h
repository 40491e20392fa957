// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// The use of an edge by a triangle, in 8 bytes.
class EdgeUse {
public:
    /// A use that no triangle has: of an edge from point 0 to itself.
    EdgeUse() = default;

    /// The use of the edge between `from` and `to` by a triangle that runs in this
    /// direction. \pre the numbers of the points are not negative and differ; `triangle`
    /// is below 2^31.
    EdgeUse(std::int32_t from, std::int32_t to, std::size_t triangle)
        : bits_{std::uint64_t(from < to ? to : from) << 33U |
                std::uint64_t(from > to) << 32U | triangle}
    {
    }

    /// The end of the edge with the higher number.
    std::int32_t high() const { return static_cast<std::int32_t>(bits_ >> 33U); }
    /// Whether the triangle runs along the edge from the lower number to the higher one.
    bool is_forward() const { return (bits_ >> 32U & 1U) == 0; }
    /// The number of the triangle.
    std::int32_t triangle() const { return static_cast<std::int32_t>(bits_); }

    /// A number by which uses are sorted: by the higher end of the edge, then forward
    /// uses first, then by triangle.
    std::uint64_t rank() const { return bits_; }

private:
    std::uint64_t bits_ = 0;  // higher end, backward, triangle: 31, 1 and 32 bits
};

/// Whether two corners of a triangle are the same point.
inline bool repeats_a_corner(const Triangle& triangle)
{
    const auto& [a, b, c] = triangle;
    return a == b || b == c || c == a;
}

/// Whether these are all uses of an edge by two triangles in opposite directions, as
/// inside a manifold, consistently oriented mesh.
inline bool are_neighbours(std::span<const EdgeUse> uses)
{
    return uses.size() == 2 && uses[0].is_forward() != uses[1].is_forward();
}

/// All edges of a mesh, each with the triangles that use it, sorted by their ends. It
/// takes 24 bytes a triangle and 8 a point. Triangles that repeat a corner have no edges
/// here.
class EdgeUses {
public:
    /// The edges of all triangles of `mesh`, which is not needed afterwards.
    explicit EdgeUses(const TriangleMesh& mesh)
        : EdgeUses{mesh.points().size(), mesh.triangles()}
    {
    }

    /// The edges of triangles over points with numbers below `points`.
    EdgeUses(std::size_t points, std::span<const Triangle> triangles);

    /// Calls `visit(MeshEdge, std::span<const EdgeUse>)` for each edge, in lexicographic
    /// order.
    template <typename Visit>
    void for_each(const Visit& visit) const
    {
        for (std::size_t low = 0; low + 1 < begin_.size(); ++low) {
            std::size_t first = begin_[low];
            for (std::size_t k = first; k < begin_[low + 1]; first = k) {
                const std::int32_t high = uses_[first].high();
                while (k < begin_[low + 1] && uses_[k].high() == high)
                    ++k;
                visit(MeshEdge{static_cast<std::int32_t>(low), high},
                      std::span{uses_}.subspan(first, k - first));
            }
        }
    }

    /// Calls `visit(std::span<const EdgeUse>)` for each point, in rising order, with the
    /// uses of all edges of which it is the lower end, sorted by `rank`.
    template <typename Visit>
    void for_each_lower_end(const Visit& visit) const
    {
        for (std::size_t low = 0; low + 1 < begin_.size(); ++low)
            visit(std::span{uses_}.subspan(begin_[low], begin_[low + 1] - begin_[low]));
    }

private:
    std::vector<std::size_t> begin_;  // first use of the edges at each lower end
    std::vector<EdgeUse> uses_;
};

/// The triangles that have the same three corners, in any order, as an earlier one; in
/// rising order. Triangles that repeat a corner are not included.
/// \param edges of the mesh.
std::vector<std::int32_t> duplicate_triangles(const EdgeUses& edges);

}  // namespace endmill
