// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "endmill/bound/detail/density_grid.h"
#include "endmill/bound/detail/raised_enclosure.h"
#include "endmill/bound/detail/tool_reach.h"

namespace endmill {

/// Enclosures on a small box of parameters of a surface, or of its extension beyond the
/// border.
struct SurfaceLeaf {
    IntervalVector point;                    ///< raised point, mm
    std::array<IntervalVector, 2> tangents;  ///< of the raised surface
    std::array<IntervalVector, 3> seconds;   ///< of the raised surface
    std::array<IntervalVector, 2> surface;   ///< first derivatives of the surface
    std::array<IntervalVector, 2> normal;    ///< first derivatives of the normal
    Interval density;                        ///< g times the area element
    std::array<Interval, 2> density_slope;   ///< its derivatives
    std::uint32_t node = 0;                  ///< lowest node of the cell of the density
    bool is_inside = false;                  ///< whether the box belongs to the surface
};

/// A range of leaves in rows and columns, both ends included.
struct LeafRange {
    int low_u;   ///< first column
    int high_u;  ///< last column
    int low_v;   ///< first row
    int high_v;  ///< last row
};

/// The surfaces of a part in small boxes with enclosures of the raised surface and of a
/// density. Each cell of the density is divided evenly. Beyond the border of each surface its
/// polynomials are extrapolated, so that a covered set can be followed to its end.
class EnclosureGrid {
public:
    /// \param part its surfaces must outlive this.
    /// \param problem must outlive this.
    /// \param grid of the density.
    /// \param density g at the nodes, 1/mm.
    /// \param leaf size of a box in mm, about.
    /// \param beyond how far the surfaces are extended, mm.
    /// \throws GeometryError where a box may contain a place without a normal.
    EnclosureGrid(const BoundedPart& part, const BoundProblem& problem,
                  const DensityGrid& grid, std::span<const double> density, double leaf,
                  double beyond);

    /// The leaf in a column and a row of a surface.
    const SurfaceLeaf& leaf(std::size_t surface, int column, int row) const
    {
        const Sheet& sheet = sheets_[surface];
        return sheet
            .leaves[static_cast<std::size_t>(row) * (sheet.u.size() - 1) + column];
    }

    /// The box of parameters of a leaf.
    ParameterBox box(std::size_t surface, int column, int row) const
    {
        const Sheet& sheet = sheets_[surface];
        return {{sheet.u[column], sheet.u[column + 1]}, {sheet.v[row], sheet.v[row + 1]}};
    }

    /// The leaves that contain a box of parameters.
    /// \return nothing if the box exceeds the extended surface.
    std::optional<LeafRange> range(std::size_t surface, const ParameterBox& box) const;

    /// The leaves that a tool may reach whose centre is within `radius` of that of `tool`.
    struct Near {
        std::optional<LeafRange> own;        ///< of one surface, extension included
        std::vector<std::uint32_t> columns;  ///< of all these leaves
        std::vector<std::uint32_t> rows;     ///< of all these leaves
        std::vector<std::uint32_t> cells_of_others;  ///< nodes of cells of other surfaces
    };

    /// The leaves near a tool at a contact on a surface.
    Near near(std::size_t surface, const ToolReach& tool, double radius) const;

    /// Whether the second derivatives of the surface jump inside a box of parameters.
    bool has_jump(std::size_t surface, const ParameterBox& box) const;

    /// A lower bound of the integral of another density over the part, mm.
    /// \param density g at the nodes, 1/mm.
    double least_integral(std::span<const double> density) const;

private:
    // Leaves of one surface, row by row, with balls about blocks of them.
    struct Sheet {
        std::vector<double> u;  // borders of columns
        std::vector<double> v;  // borders of rows
        std::vector<SurfaceLeaf> leaves;
        std::vector<Vec3> middles;  // of raised leaves
        std::vector<double> radii;  // of balls about these that contain the leaves
        std::vector<Vec3> block_middles;
        std::vector<double> block_radii;
        int blocks_u = 0;
        int blocks_v = 0;
        std::vector<double> jumps_u;  // borders of patches where second derivatives jump
        std::vector<double> jumps_v;
    };

    void add_sheet(std::size_t surface, double leaf, double beyond);
    void fill(Sheet& sheet, std::size_t surface, std::span<const double> density);
    static void add_blocks(Sheet& sheet);

    const BoundedPart& part_;
    const BoundProblem& problem_;
    const DensityGrid& grid_;
    std::vector<Sheet> sheets_;
};

}  // namespace endmill
