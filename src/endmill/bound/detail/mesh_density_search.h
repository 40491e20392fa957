// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "endmill/bound/detail/density_lattice.h"
#include "endmill/bound/detail/density_updates.h"
#include "endmill/bound/detail/inflow.h"
#include "endmill/bound/detail/mesh_cover.h"
#include "endmill/mesh/triangle_tree.h"

namespace endmill {

/// A place where the ball touches a mesh.
struct MeshPlace {
    Vec3 point;           ///< contact, mm
    Vec3 normal;          ///< unit, from the contact to the centre
    std::uint32_t facet;  ///< number of a facet with the point
};

/// As DensitySearch, for the tips of paths over a mesh.
///
/// Places are those where a ball on the middle of a piece of a facet does not enter the mesh by
/// more than gamma and h / 20; random places lie on facets, edges and corners, where the ball pivots. Pieces
/// that the ball comes nowhere within half the scallop height of have no weight.
/// Source: docs/methods/path-length-bound.md, section 11.
class MeshDensitySearch {
public:
    /// \param mesh    oriented consistently; it must outlive this.
    /// \param problem must outlive this; its length is Tip.
    /// \param options spacing, tests and progress.
    MeshDensitySearch(const TriangleMesh& mesh, const BoundProblem& problem,
                      DensitySearchOptions options);

    /// The density. Its nodes are those of a lattice.
    FoundDensity run();

    /// The spacing of the nodes in mm. On meshes of many slivers it is larger than that of the
    /// options, so that memory does not grow faster than the mesh.
    double spacing() const { return spacing_; }

    /// The pieces of the facets that face the tool.
    const std::vector<FacetPiece>& pieces() const { return pieces_; }

    /// The density that was found, in the middle of a piece, 1/mm.
    double density_at(const FacetPiece& piece) const;

    /// The greatest inflow of the density that was found, at each of `count` random places; 0
    /// where the ball cannot touch.
    std::vector<double> inflows_at_random(std::size_t count, std::uint64_t seed) const;

private:
    using Flows = std::vector<FlowAt<LatticePlace>>;

    Vec3 centre(const MeshPlace& place) const;
    bool fits(const MeshPlace& place) const;
    Flows flows_at(const MeshPlace& place) const;
    std::vector<MeshPlace> spread_places(double step) const;
    std::vector<MeshPlace> random_places(std::span<const std::size_t> pieces,
                                         std::size_t count,
                                         std::mt19937_64& engine) const;
    MeshPlace random_place(std::size_t piece, std::mt19937_64& engine) const;
    void weigh(const std::vector<MeshPlace>& places);
    std::vector<std::size_t> test(const std::vector<MeshPlace>& places);
    void test_at_random(std::uint64_t seed);
    double disc_at(const MeshPlace& place) const;
    void report(double share) const;

    const TriangleMesh& mesh_;
    const BoundProblem& problem_;
    DensitySearchOptions options_;
    TriangleTree tree_;
    std::vector<std::vector<std::uint32_t>> facets_at_;  // of each point
    std::vector<FacetPiece> pieces_;
    double spacing_;                // of the nodes, mm
    std::vector<std::size_t> all_;  // numbers of all pieces
    MeshCover cover_;
    DensityLattice lattice_;
    std::vector<Flows> places_;
    std::vector<double> density_;
};

}  // namespace endmill
