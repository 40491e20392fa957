// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/core/vec.h"
#include "endmill/cutter/tool.h"
#include "endmill/mesh/triangle_mesh.h"

/// \file
/// The visibility cones of the facets of a part: the directions along which a tool can
/// reach each facet, with and without the body of the tool. A direction points from the
/// part towards the spindle.
/// Source: [KangSuh, section 2]; docs/methods/five-axis-setup.md, section 1.
///
/// Implemented in `visibility.cpp` and `nearest_cells.cpp`.

namespace endmill {

/// The visibility cones of all facets as bits: one column for each direction (cell), with
/// one bit for each facet.
///
/// A set bit means *accessible*. The paper's binary spherical map, and the files named
/// after it, use 0 for accessible. Source: [KangSuh, eq. (3)].
class VisibilityMap {
public:
    /// A map without facets and cells.
    VisibilityMap() = default;

    /// Makes a map in which nothing is accessible.
    /// \param facets number of facets. \param cells number of directions.
    /// \throws LimitError if there is not enough memory.
    VisibilityMap(std::size_t facets, std::size_t cells);

    std::size_t facets() const { return facets_; }  ///< bits of a column
    std::size_t cells() const { return cells_; }    ///< number of columns

    /// Words of 64 bits of a column. The bits beyond the last facet are 0.
    std::size_t words() const { return words_; }

    /// The column of a cell: bit j % 64 of word j / 64 belongs to facet j. \pre cell <
    /// cells().
    std::span<const std::uint64_t> column(std::size_t cell) const
    {
        return {bits_.data() + cell * words_, words_};
    }

    /// The column of a cell, to be filled. \pre cell < cells(); bits beyond the last
    /// facet stay 0.
    std::span<std::uint64_t> column(std::size_t cell)
    {
        return {bits_.data() + cell * words_, words_};
    }

    /// Tests whether `facet` is accessible along the direction of `cell`.
    /// \pre facet < facets() and cell < cells().
    bool is_accessible(std::size_t facet, std::size_t cell) const
    {
        return (column(cell)[facet / 64] >> (facet % 64) & 1) != 0;
    }

private:
    std::size_t facets_ = 0;
    std::size_t cells_ = 0;
    std::size_t words_ = 0;
    std::vector<std::uint64_t> bits_;
};

/// The causes that make a facet inaccessible along a direction.
enum class VisibilityKind {
    Local,  ///< only the incidence on the facet itself, as in the cones of Woo et al.
    Global  ///< the incidence, and occlusion by other facets, as in the paper
};

/// Every `step`-th direction from `first` on: a share of the work of several processes.
/// Neighbouring directions of a grid cost about the same, so that such shares do too.
struct DirectionShare {
    std::size_t first = 0;  ///< number of a direction
    std::size_t step = 1;   ///< at least 1

    /// How many of `directions` directions belong to the share.
    std::size_t count(std::size_t directions) const
    {
        return first < directions ? (directions - first - 1) / step + 1 : 0;
    }

    /// The number of a direction. \param k its place in the share, from 0.
    std::size_t direction(std::size_t k) const { return first + k * step; }
};

/// Options of `part_visibility`.
struct VisibilityOptions {
    /// Upper limit (excluded) of the angle between the direction and the facet's normal.
    /// It is above 0 and at most 90 degrees.
    Angle incidence = Angle::degrees(90);
    VisibilityKind kind = VisibilityKind::Global;  ///< with or without occlusion
    DirectionShare share = {};  ///< the columns of other directions stay empty

    /// If set, it is called after each direction with the number of finished directions.
    /// Any thread may call, one at a time. An exception ends the work.
    std::function<void(std::size_t done)> progress = {};
};

/// The visibility cones of a part's facets.
struct PartVisibility {
    VisibilityMap map;  ///< one column for each direction

    /// Facets without area, ascending. They have no cone and block nothing.
    std::vector<std::size_t> dropped;
};

/// Computes the visibility cones of a part.
///
/// Facet j is accessible along the direction C if n_j . C > max(cos incidence, 1e-6) and,
/// in the kind `Global`, if the ray from its centroid along C meets no other facet.
/// Facets contain their edges, so that a ray through an edge is blocked. They block from
/// both sides.
///
/// Occlusion is exact for the doubles of points and directions; the centroid (a + b + c)
/// / 3 is not rounded. The incidence is compared in doubles: the error of n . C is at
/// most 1e-15 times the square of the facet's longest side divided by its area.
///
/// Directions are processed in parallel, one column each. The result does not depend on
/// the number of threads. Memory besides the map: about 120 bytes for each facet, and 100
/// more on each thread; about twice as much if the facets share no points.
/// Source: [KangSuh, section 2]; docs/methods/five-axis-setup.md, section 1 (our rule
/// of occlusion) and section 11 (the method).
/// \param part facets in mm. \param directions unit to 1e-9. \param options what counts.
/// \throws DomainError if a direction does not have unit length, or if the incidence or the
///         step of the share is outside its range.
/// \throws LimitError if the map does not fit into memory.
PartVisibility part_visibility(const TriangleMesh& part, std::span<const Vec3> directions,
                               const VisibilityOptions& options = {});

/// Facets that have an area and that no direction of the map reaches, ascending. If there
/// is one, no machine that is limited to these directions can make the part in one setup.
std::vector<std::size_t> empty_cones(const PartVisibility& visibility);

/// The facet that hides `facet` along a direction: the first one that the ray from its
/// centroid meets. Whether a facet is met is exact, as in `part_visibility`; which of
/// several is the first one is decided in doubles. Time: linear in the facets.
/// \param part facets in mm. \param facet number of a facet. \param direction not zero.
/// \return nothing if no other facet with an area is met.
/// \throws DomainError unless `facet` is one of the part and the direction is not zero.
std::optional<std::size_t> hiding_facet(const TriangleMesh& part, std::size_t facet,
                                        const Vec3& direction);

/// The share of the sphere that the cone of each facet covers, from 0 to 1.
/// \param map cones. \param solid_angles_sr solid angle of each cell.
/// \throws DomainError if there is not one solid angle for each cell.
std::vector<double> visible_fractions(const VisibilityMap& map,
                                      std::span<const double> solid_angles_sr);

/// Removes from a map the directions along which the body of a tool would meet the part.
/// The tip is at the centroid of the facet and the tool axis is the direction. No
/// cylinder of the body may meet a facet. Touching counts as a collision.
///
/// The facet at the tip is tested too. A cylinder that starts at the tip therefore
/// excludes every direction. The cutter itself is not tested. Cylinders have flat ends.
/// The decision is correct unless the distance of a cylinder from a facet is below 1e-14
/// times the largest coordinate. Directions are processed in parallel; the result does
/// not depend on the number of threads. Memory: up to 90 bytes for each facet.
/// Source: [KangSuh, section 6] names this as future work.
/// \param visibility of `part` along `directions`; it is changed.
/// \param part facets in mm. \param directions unit to 1e-9.
/// \param body cylinders from `tool_body`.
/// \param progress as VisibilityOptions::progress.
/// \throws DomainError if the map does not belong to this part and these directions, if a
///         direction does not have unit length, or unless each cylinder has a finite
///         diameter above 0 and finite 0 <= from < to.
void keep_reachable(PartVisibility& visibility, const TriangleMesh& part,
                    std::span<const Vec3> directions, std::span<const ToolCylinder> body,
                    const std::function<void(std::size_t done)>& progress = {});

/// The cells that represent the cones of a part at a tool axis. For each facet that is
/// not accessible along the tool axis this is the accessible cell nearest to the axis.
/// Each cell is listed once, the nearest first. Facets that no cell reaches are left out.
///
/// If several cells are equally near (dot products within 1e-12), the lowest one is
/// taken. The facets are the paper's Group II, the cells its MD_j. O(cells * facets /
/// 64).
/// Source: [KangSuh, eq. (3), (4)]; docs/methods/five-axis-setup.md, section 4.
/// \param map cones. \param centres unit, one for each cell of `map`.
/// \param pose the cell whose centre is the tool axis.
/// \throws DomainError if there is not one centre for each cell, or if `pose` is not a
///         cell.
std::vector<std::uint32_t> nearest_cells(const VisibilityMap& map,
                                         std::span<const Vec3> centres, std::size_t pose);

/// Receives the `nearest_cells` of a tool axis, the centre of the cell `pose`.
using NearestCellsVisit =
    std::function<void(std::size_t pose, std::vector<std::uint32_t> cells)>;

/// Finds the `nearest_cells` at every tool axis, which is faster than one at a time.
/// At most O(cells^2 * facets / 64); about a twentieth of it for a convex part if each 64
/// successive facets have similar cones. Memory: on each thread 5 bytes for each cell and each
/// of 64 to 256 tool axes.
/// \param map cones. \param centres unit, one for each cell of `map`.
/// \param visit is called once for each cell as the tool axis, in any order and by several
///        threads at once. An exception ends the work.
/// \throws DomainError if there is not one centre for each cell.
void for_each_nearest_cells(const VisibilityMap& map, std::span<const Vec3> centres,
                            const NearestCellsVisit& visit);

/// A function that does what `for_each_nearest_cells` does, for searches that use it. A
/// program of several processes divides the facets among them.
using NearestCellsFinder =
    std::function<void(const VisibilityMap& map, std::span<const Vec3> centres,
                       const NearestCellsVisit& visit)>;

/// Every `step`-th group of 64 successive facets from the group `first` on: a share of the
/// facets for one of `step` processes. Neighbouring groups often have similar cones, so that
/// such shares cost about the same.
/// \param map cones. \param first number of a group, from 0. \param step at least 1.
/// \return the cones of these facets, over the same cells.
/// \throws DomainError if `step` is 0. LimitError if there is not enough memory.
VisibilityMap facet_share(const VisibilityMap& map, std::size_t first, std::size_t step);

/// The `nearest_cells` at every tool axis as bits, without their order. Each tool axis has a
/// row of (cells + 63) / 64 words; bit i % 64 of word i / 64 of a row belongs to cell i. The
/// rows of a map are the rows of all its `facet_share`s, combined by a bitwise or.
/// \param map, centres as for `for_each_nearest_cells`.
/// \param progress as VisibilityOptions::progress, for tool axes.
/// \throws DomainError as `for_each_nearest_cells`.
std::vector<std::uint64_t> nearest_cell_rows(
    const VisibilityMap& map, std::span<const Vec3> centres,
    const std::function<void(std::size_t done)>& progress = {});

/// Visits every tool axis as `for_each_nearest_cells` does, with the cells of its row. It
/// sorts all cells at each tool axis, which takes O(cells^2 log cells).
/// \param rows of `nearest_cell_rows`. \param centres unit, one for each cell.
/// \throws DomainError if `rows` does not have a row for each cell.
void for_each_row_of_cells(std::span<const std::uint64_t> rows,
                           std::span<const Vec3> centres, const NearestCellsVisit& visit);

}  // namespace endmill
