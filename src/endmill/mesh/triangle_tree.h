// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

struct FourEnclosures;

/// The point of a mesh that is nearest to a given place.
struct NearestPoint {
    Vec3 point;            ///< mm
    double distance;       ///< mm, from the place
    std::size_t triangle;  ///< number of the triangle that contains it
};

/// The points origin + t direction with t >= 0.
struct Ray {
    Vec3 origin;     ///< mm
    Vec3 direction;  ///< mm per unit of t; its length must be between 1e-100 and 1e100
};

/// The point in which a ray meets a mesh.
struct RayHit {
    /// Parameter of the point on the ray, at least 0.
    double t;
    Vec3 point;            ///< mm, origin + t direction
    std::size_t triangle;  ///< number of the triangle that is hit
};

/// The point of a triangle that is nearest to `place`. Accurate to 1e-14 of the largest
/// coordinate, also for very thin triangles. Two triangles give the same point if it lies
/// on their common edge.
/// \param place   in mm.
/// \param corners in mm.
Vec3 nearest_on_triangle(const Vec3& place, const std::array<Vec3, 3>& corners);

/// Finds the nearest point of a mesh and the first hit of a ray in about log(n) steps,
/// for n triangles.
///
/// The tree is a hierarchy of bounding boxes, and of slabs for the nearest point. It keeps
/// 32 bytes a triangle and refers to the mesh, which must outlive it. It is a tuned
/// kernel: its leaves and nodes have four children, which are tested together in vector
/// registers. It shares no code with the trees of other modules, which have other shapes
/// and other items.
///
/// A result depends only on the mesh and the query, not on earlier queries. If several
/// triangles are equally good, the one with the lowest number is returned. Lengths are
/// accurate to 1e-14 of the largest coordinate of mesh and query, also for very thin
/// triangles. The position of a hit across the ray has the same accuracy. Triangles
/// without area count for the nearest point.
class TriangleTree {
public:
    /// Builds the tree. \throws DomainError if a coordinate of a point is above 1e30 mm.
    explicit TriangleTree(const TriangleMesh& mesh);
    // deleted: the mesh would not outlive the tree
    explicit TriangleTree(TriangleMesh&&) = delete;
    // in the source, where the nodes are complete
    ~TriangleTree();
    TriangleTree(const TriangleTree& other);                 ///< a tree of the same mesh
    TriangleTree(TriangleTree&& other) noexcept;             ///< the same
    TriangleTree& operator=(const TriangleTree& other);      ///< the same
    TriangleTree& operator=(TriangleTree&& other) noexcept;  ///< the same

    /// The point of the mesh that is nearest to `place`.
    /// \param place in mm.
    /// \param hint   number of a triangle that may be near, such as the result of a
    ///        neighbouring query. It speeds up the search and never changes the result.
    /// \param within in mm: only points nearer than this are searched for, which saves
    ///         time.
    /// \return nothing if the mesh has no triangle, or none nearer than `within`.
    /// \throws DomainError if a coordinate of `place` is beyond 1e30 mm, or `hint` is not
    ///         the number of a triangle.
    std::optional<NearestPoint> nearest(
        const Vec3& place, std::optional<std::size_t> hint = {},
        double within = std::numeric_limits<double>::infinity()) const;

    /// The hit of least t, from either side of a triangle.
    ///
    /// The test is watertight: the side on which a ray passes an edge is the same for all
    /// triangles at the edge. A ray that meets the interior of a triangle, an edge shared
    /// by two triangles, or a point surrounded by triangles, therefore hits at least one
    /// of them. Rounding decides which one it hits. It also decides whether a ray that
    /// touches the boundary of the mesh, or lies in the plane of a triangle, hits it.
    /// Source: [WoopBenthinWald, pp. 65-82].
    /// \return nothing if the ray meets no triangle.
    /// \throws DomainError if the ray's origin is beyond 1e30 mm, or the length of its
    ///         direction is not between 1e-100 and 1e100.
    std::optional<RayHit> first_hit(const Ray& ray) const;

    /// Whether the ray meets a triangle at a t of at most `greatest_t`. Throws as
    /// `first_hit` does.
    bool any_hit(const Ray& ray,
                 double greatest_t = std::numeric_limits<double>::infinity()) const;

private:
    // Four triangles that are near each other, stored together so that a search reads
    // them from one cache line.
    struct alignas(64) Leaf {
        std::array<Triangle, 4> corners;
        std::array<std::int32_t, 4> numbers;  // of the triangles
    };
    struct NearestQuery;
    struct RayQuery;

    void arrange();
    void enclose();
    void enclose_leaf(std::size_t leaf);
    void enclose_node(const FourEnclosures& node, FourEnclosures& parent,
                      Eigen::Index part) const;
    void set_slab(FourEnclosures& node, Eigen::Index part, const Eigen::Vector3f& normal,
                  double low, double high) const;
    void add_level(std::size_t count);
    RayQuery query(const Ray& ray, double greatest_t) const;
    template <typename Query>
    void ask(Query& query) const;
    void prefetch(std::int32_t level, std::size_t node) const;
    void prefetch_below(std::int32_t level, std::size_t node) const;

    const TriangleMesh* mesh_;
    double largest_coordinate_ = 0;  // mm
    // Neighbouring leaves are near each other. The last triangle is repeated until the
    // last leaf is complete.
    std::vector<Leaf> leaves_;
    // The nodes of each level, from those above the leaves upwards; each encloses its
    // children. The last level is one node, or none.
    std::vector<std::vector<FourEnclosures>> levels_;
};

}  // namespace endmill
