// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/bound/detail/contact_frame.h"

namespace endmill {

/// A place in a cell of the grid: the cell's lowest node, and the shares of the cell.
struct GridPlace {
    std::uint32_t node;  ///< number of the node at the low ends of the cell
    float u;             ///< share of the cell in u, 0 to 1
    float v;             ///< share of the cell in v, 0 to 1
};

/// A cell of the grid: a rectangle of the parameters inside one patch.
struct DensityCell {
    std::size_t surface;  ///< number of the surface
    int i;                ///< patch in u
    int j;                ///< patch in v
    Interval u;           ///< parameters
    Interval v;           ///< parameters
    std::uint32_t node;   ///< number of the node at the low ends
    double area;          ///< mm^2
    double length_u;      ///< mm, of the longer chord along u
    double length_v;      ///< mm, along v
};

/// A grid of nodes over the surfaces of a part, for densities that are bilinear in each
/// cell. Lines of nodes lie on the borders of all patches; between them they are at equal
/// steps of the parameters, on average `spacing` apart along the surface.
class DensityGrid {
public:
    /// \param part its surfaces must outlive this.
    /// \param spacing of nodes in mm, positive.
    DensityGrid(const BoundedPart& part, double spacing);

    std::size_t nodes() const { return weights_.size(); }             ///< number of nodes
    const std::vector<DensityCell>& cells() const { return cells_; }  ///< all cells

    /// The integral of each node's bilinear hat function, mm^2.
    const std::vector<double>& weights() const { return weights_; }

    /// The cell and the shares of a point of a surface.
    GridPlace place(std::size_t surface, const SurfacePoint& at) const;

    /// The four nodes of a cell, from its lowest node: at (0,0), (1,0), (0,1) and (1,1).
    std::array<std::uint32_t, 4> corners(std::uint32_t node) const
    {
        const std::uint32_t up = node + rows_[node];
        return {node, node + 1, up, up + 1};
    }

    /// The bilinear function with the given values at the nodes.
    template <typename Value>
    double value(std::span<const Value> at_nodes, const GridPlace& place) const
    {
        const auto [a, b, c, d] = corners(place.node);
        const double low = at_nodes[a] + place.u * (at_nodes[b] - at_nodes[a]);
        const double high = at_nodes[c] + place.u * (at_nodes[d] - at_nodes[c]);
        return low + place.v * (high - low);
    }

private:
    // The lines of nodes of one surface along one parameter.
    struct Lines {
        std::vector<int> first;      // number of the first line of each patch
        std::vector<double> places;  // parameters
    };

    Lines lines(const Surface& surface, Parameter along, double spacing) const;
    void measure(DensityCell& cell) const;
    void add_cells(std::size_t surface, std::uint32_t first_node);

    BoundedPart part_;
    std::vector<std::array<Lines, 2>> lines_;  // of each surface, along u and v
    std::vector<std::uint32_t> first_nodes_;   // of each surface
    std::vector<std::uint32_t> rows_;  // of each node: nodes in a row of its surface
    std::vector<DensityCell> cells_;
    std::vector<double> weights_;
};

}  // namespace endmill
