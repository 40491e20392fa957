// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "endmill/bound/bound_problem.h"
#include "endmill/bound/detail/tool_bins.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// A piece of a facet that faces the tool, with the normals of the smooth part that the mesh
/// stands for.
struct FacetPiece {
    std::array<Vec3, 3> corners;  ///< mm
    std::array<Vec3, 3> normals;  ///< unit, at the corners
    std::uint32_t facet;          ///< number in the mesh

    Vec3 middle() const { return (corners[0] + corners[1] + corners[2]) / 3; }  ///< mm
    /// Unit, in the middle.
    Vec3 normal() const { return (normals[0] + normals[1] + normals[2]).normalized(); }
    double area() const;  ///< mm^2
};

/// The unit normal of a facet; zero if it has no area.
Vec3 facet_normal(const TriangleMesh& mesh, std::size_t facet);

/// The numbers of the facets at each point of a mesh.
std::vector<std::vector<std::uint32_t>> facets_at_points(const TriangleMesh& mesh);

/// Whether the mesh has a crease between two facets: their normals differ by more than 30
/// degrees.
bool is_crease(const Vec3& normal, const Vec3& other);

/// The facets of a mesh that face the tool, N.z > 0, divided by halving their longest edges. The
/// normal at a corner is the mean of those of the facets around, weighted by their angles there,
/// as far as there is no crease between them and the facet. Between corners it is linear.
/// \param mesh oriented consistently.
/// \param facets_at from facets_at_points.
/// \param longest_edge of a piece in mm. On meshes of many slivers pieces are longer, so that
///        there are at most about a million of them, or twice as many as facets.
std::vector<FacetPiece> facet_pieces(
    const TriangleMesh& mesh, const std::vector<std::vector<std::uint32_t>>& facets_at,
    double longest_edge);

/// A piece of the boundary of what one place of the ball covers.
struct MeshFlow {
    Vec3 point;  ///< of the mesh, mm
    /// The inflow per mm of travel of the centre along t is max(0, flow . t) for the
    /// density 1, in mm.
    Vec3 flow;
};

/// A triangle of a piece, and the same raised by h along its normals.
struct RaisedTriangle {
    std::array<Vec3, 3> corners;  ///< mm
    std::array<Vec3, 3> raised;   ///< mm
    std::array<Vec3, 3> normals;  ///< about of length 1
};

/// What the tool covers of a mesh from any place of its centre.
///
/// A point is covered if it lies in the tool after it was raised by h along its normal. The
/// boundary of the covered set crosses a piece along an arc, whose ends are exact to second order
/// in the size of the piece. It is divided into flows of at most 7.5 degrees. Slopes are those of the smooth part, not those of the facets: the
/// boundary would move faster and slower on facets that are tilted against the part, and the
/// greatest inflow would be too large.
class MeshCover {
public:
    /// \param pieces  from facet_pieces.
    /// \param problem must outlive this. Its length plays no role.
    MeshCover(const std::vector<FacetPiece>& pieces, const BoundProblem& problem);

    /// The boundary of the covered set, without that on the border of the mesh.
    /// \param centre of the ball, mm.
    std::vector<MeshFlow> boundary(const Vec3& centre) const;

    /// Calls visit(piece, share) with the covered share of each piece that has one. It is
    /// exact to second order in a quarter of the size of the piece.
    template <typename Visit>
    void visit_covered(const Vec3& centre, const Visit& visit) const;

private:
    // Halvings of a partly covered piece.
    static constexpr int area_divisions = 2;

    // A piece, raised by h along its normals, with the middle of the raised corners.
    struct Raised {
        Vec3 point;
        double size;
        std::array<Vec3, 3> corners;
        std::uint32_t piece;
    };

    static std::vector<Raised> raised(const std::vector<FacetPiece>& pieces,
                                      double height);
    static double covered_share(const ToolReach& tool, const std::array<Vec3, 3>& corners,
                                int divisions);
    void add_arc(const ToolReach& tool, const RaisedTriangle& triangle,
                 std::vector<MeshFlow>& flows) const;

    const std::vector<FacetPiece>& pieces_;
    const BoundProblem& problem_;
    ToolBins<Raised> bins_;
};

template <typename Visit>
void MeshCover::visit_covered(const Vec3& centre, const Visit& visit) const
{
    const ToolReach tool{problem_, centre};
    const double far = tool.reach() + bins_.greatest_size();
    bins_.visit_near(tool, far, [&](std::uint32_t number, const Vec3& away) {
        const Raised& raised = bins_.items()[number];
        // Phi changes by no more than the way
        const double excess = away.norm() - tool.reach();
        const double share = excess < -raised.size ? 1
                             : excess > raised.size
                                 ? 0
                                 : covered_share(tool, raised.corners, area_divisions);
        if (share > 0)
            visit(raised.piece, share);
        return true;
    });
}

}  // namespace endmill
