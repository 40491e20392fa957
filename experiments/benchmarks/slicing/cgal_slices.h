// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iterator>
#include <vector>

#include <CGAL/AABB_halfedge_graph_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_slicer.h>
#include <CGAL/Surface_mesh.h>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// The slicer of CGAL with its tree, as a baseline.
class CgalSlicer {
public:
    explicit CgalSlicer(const TriangleMesh& mesh) : mesh_{copied(mesh)} { build_tree(); }

    /// Builds the tree over the edges of the mesh again.
    void build_tree()
    {
        tree_.rebuild(edges(mesh_).first, edges(mesh_).second, mesh_);
        tree_.build();
    }

    /// Number of points of all sections by the planes y = positions[k].
    std::size_t points(const std::vector<double>& positions) const
    {
        const CGAL::Polygon_mesh_slicer<Mesh, Kernel> slicer{mesh_, tree_};
        std::size_t count = 0;
        for (const double position : positions) {
            std::vector<std::vector<Kernel::Point_3>> lines;
            slicer(Kernel::Plane_3{0, 1, 0, -position}, std::back_inserter(lines));
            for (const auto& line : lines)
                count += line.size();
        }
        return count;
    }

private:
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
    using Primitive = CGAL::AABB_halfedge_graph_segment_primitive<Mesh>;
    using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

    static Mesh copied(const TriangleMesh& mesh)
    {
        Mesh copy;
        for (const Vec3& point : mesh.points())
            copy.add_vertex({point.x(), point.y(), point.z()});
        using Vertex = Mesh::Vertex_index;
        for (const auto& [a, b, c] : mesh.triangles())
            copy.add_face(Vertex(a), Vertex(b), Vertex(c));
        return copy;
    }

    Mesh mesh_;
    Tree tree_;
};

}  // namespace endmill
