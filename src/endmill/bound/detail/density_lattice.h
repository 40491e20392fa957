// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/core/vec.h"

namespace endmill {

/// A place in a cell of the lattice: the cell's lowest node, and the shares of the cell.
struct LatticePlace {
    std::uint32_t node;  ///< number of the node at the low ends of the cell
    float x;             ///< share of the cell in x, 0 to 1
    float y;             ///< share in y
    float z;             ///< share in z
};

/// A cube of the lattice.
struct LatticeCell {
    std::uint32_t node;  ///< number of the node at the low ends
};

/// The cubes of a cubic lattice that a mesh meets, for densities that are trilinear in each
/// cube. The density does not depend on how the mesh is divided into triangles.
class DensityLattice {
public:
    /// \param boxes around parts of the mesh; cubes that meet one of them become cells.
    /// \param spacing of nodes in mm, positive.
    DensityLattice(std::span<const Eigen::AlignedBox3d> boxes, double spacing);

    std::size_t nodes() const { return keys_.size(); }                ///< number of nodes
    const std::vector<LatticeCell>& cells() const { return cells_; }  ///< all cells

    /// The integral of each node's trilinear hat function over the mesh, mm^2.
    const std::vector<double>& weights() const { return weights_; }

    /// Adds a piece of area about a point to the weights.
    /// \pre the point lies in a cell.
    void add_area(const Vec3& point, double area);

    /// The cell and the shares of a point; nothing if it lies in no cell.
    std::optional<LatticePlace> place(const Vec3& point) const;

    /// The eight nodes of a cell, from its lowest node; x changes first, then y.
    const std::array<std::uint32_t, 8>& corners(std::uint32_t node) const
    {
        return corners_[node];
    }

    /// The trilinear function with the given values at the nodes.
    double value(std::span<const double> at_nodes, const LatticePlace& place) const;

private:
    using Key = std::array<std::int64_t, 3>;

    Key key_of(const Vec3& point) const;
    std::optional<std::uint32_t> node_of(const Key& key) const;

    double spacing_;
    Vec3 low_ = Vec3::Zero();
    std::vector<Key> keys_;  // of the nodes, sorted
    // of each node: the corners of the cell above it; all 0 if that is no cell
    std::vector<std::array<std::uint32_t, 8>> corners_;
    std::vector<LatticeCell> cells_;
    std::vector<double> weights_;
};

}  // namespace endmill
