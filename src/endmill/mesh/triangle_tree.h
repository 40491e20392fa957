// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// The place of a mesh that is nearest to another.
struct NearestPoint {
    Vec3 point;            ///< mm
    double distance;       ///< mm, to it
    std::size_t triangle;  ///< on which it lies
};

/// The points origin + t direction with t >= 0.
struct Ray {
    Vec3 origin;     ///< mm
    Vec3 direction;  ///< mm per unit of t; 1e-100 to 1e100 long
};

/// Where a ray meets a mesh.
struct RayHit {
    double t;
    Vec3 point;            ///< mm, origin + t direction
    std::size_t triangle;  ///< that is hit
};

/// The point of a triangle that is nearest to `place`. Accurate to 1e-14 of the largest
/// coordinate, however thin the triangle is. Triangles that share an edge and are nearest in
/// it find the same point.
/// \param place   in mm.
/// \param corners in mm.
Vec3 nearest_on_triangle(const Vec3& place, const std::array<Vec3, 3>& corners);

/// Answers where a mesh is nearest and what a ray meets first, in about log(triangles)
/// steps. Keeps a tree of boxes in 12 bytes a triangle (28 while it is made), and refers
/// to the mesh, which must outlive it. Answers depend on mesh and question only, not on
/// the order of questions; of equal answers the triangle of the lowest number is given.
///
/// Lengths are accurate to 1e-14 of the largest coordinate of mesh and question, however
/// thin a triangle is; those without area count. What a ray meets is accurate to as much
/// across the ray.
class TriangleTree {
public:
    /// \throws DomainError if a coordinate of a point is above 1e30 mm.
    explicit TriangleTree(const TriangleMesh& mesh);
    explicit TriangleTree(TriangleMesh&&) = delete;  // it would not outlive the tree

    /// \param place in mm. \param hint a triangle that may be near, such as that of a
    ///        neighbouring question: it makes the answer come sooner, never another.
    ///        A triangle that shares the nearest edge or point with others is equal to
    ///        them.
    /// \param within in mm: only what is nearer is asked for, which takes less time.
    /// \return nothing if the mesh has no triangle, or none so near.
    /// \throws DomainError if a coordinate of the place is not within 1e30 mm, or the
    ///         hint is not the number of a triangle.
    std::optional<NearestPoint> nearest(
        const Vec3& place, std::optional<std::size_t> hint = {},
        double within = std::numeric_limits<double>::infinity()) const;

    /// The hit of least t, on either side of a triangle. Watertight: a ray that meets the
    /// inside of a triangle, an edge that two share, or a point with triangles all
    /// around, hits one of them, for on which side it passes a line of two points is
    /// decided alike for all triangles. Which of them it hits, whether a ray that grazes a
    /// rim does, or one that lies in a triangle, is up to rounding.
    /// Source: S. Woop, C. Benthin, I. Wald, Watertight Ray/Triangle Intersection, 2013.
    /// \return nothing if the ray meets no triangle.
    /// \throws DomainError if the ray's origin is not within 1e30 mm, or its direction is
    ///         not between 1e-100 and 1e100 long.
    std::optional<RayHit> first_hit(const Ray& ray) const;

    /// Whether the ray meets a triangle at a t of at most `greatest_t`. Throws like
    /// first_hit.
    bool any_hit(const Ray& ray,
                 double greatest_t = std::numeric_limits<double>::infinity()) const;

private:
    // The boxes of four children, rounded outwards; of those missing, nothing's.
    struct Boxes {
        std::array<Eigen::Array4f, 3> low;  // along each axis, in mm
        std::array<Eigen::Array4f, 3> high;
    };
    struct NearestQuery;
    struct RayQuery;

    void arrange();
    void enclose();
    RayQuery query(const Ray& ray, double greatest_t) const;
    template <typename Query>
    void ask(Query& query) const;
    template <typename Query>
    void ask_triangles(Query& query, std::size_t leaf) const;

    const TriangleMesh* mesh_;
    double largest_coordinate_ = 0;  // mm
    // Triangles, four to a leaf, so that leaves, fours of leaves and so on are near each
    // other; the last may be short.
    std::vector<std::int32_t> order_;
    // From the boxes of leaves upwards; the last level is one Boxes, or none.
    std::vector<std::vector<Boxes>> levels_;
};

}  // namespace endmill
