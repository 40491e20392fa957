// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/core/vec.h"
#include "endmill/cutter/tool.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// Which facets of a part a tool reaches along which directions: a bit for each, a column of
/// bits for each direction. The paper's binary spherical map, but for its sign: here a set bit
/// is *accessible*, as in no file. Source: [KangSuh, eq. (3)].
class VisibilityMap {
public:
    VisibilityMap() = default;

    /// Nothing is accessible. \throws LimitError if that needs more memory than there is.
    VisibilityMap(std::size_t facets, std::size_t cells);

    std::size_t facets() const { return facets_; }  ///< bits of a column
    std::size_t cells() const { return cells_; }    ///< columns

    /// 64-bit words of a column; the bits beyond the last facet are 0.
    std::size_t words() const { return words_; }

    /// Bit j % 64 of word j / 64 tells of facet j. \pre cell < cells().
    std::span<const std::uint64_t> column(std::size_t cell) const
    {
        return {bits_.data() + cell * words_, words_};
    }

    /// The same, to be filled. \pre cell < cells(); the bits beyond the last facet stay 0.
    std::span<std::uint64_t> column(std::size_t cell)
    {
        return {bits_.data() + cell * words_, words_};
    }

    /// Whether the tool reaches `facet` along the direction of `cell`. \pre both exist.
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

/// What keeps a tool from a facet.
enum class VisibilityKind {
    Local,  ///< the incidence on the facet alone, as in the cones of Woo et al.
    Global  ///< and the other facets, the paper's
};

/// What counts as visible, and who wants to know how far the work is.
struct VisibilityOptions {
    /// Largest angle between a tool axis and the facet's normal, excluded itself; above 0,
    /// at most 90 degrees.
    Angle incidence = Angle::degrees(90);
    VisibilityKind kind = VisibilityKind::Global;  ///< what blocks
    /// Called after each direction with the number of those done, by one thread at a time,
    /// whichever. What it throws ends the work.
    std::function<void(std::size_t done)> progress = {};
};

/// The visibility cones of a part's facets.
struct PartVisibility {
    VisibilityMap map;  ///< a column for each direction
    std::vector<std::size_t>
        dropped;  ///< facets without area: no cone, and nothing blocked
};

/// Which facets are visible along which directions: facet j along C if n_j . C > max(cos
/// omega, 1e-6) and, in the global kind, the ray from its centroid along C meets no other
/// facet. Facets are closed, touching an edge blocks, and they block from both sides.
/// Source: [KangSuh, section 2]; the rule where the paper says no more is ours.
///
/// Occlusion is exact for the doubles of points and directions, with centroids (a + b + c)
/// / 3 that are not rounded. The incidence is compared in doubles: n . C is off by 1e-15 at
/// most, times the square of the facet's longest side by its area.
///
/// Directions are dealt with on all threads, one column each; the answer does not depend on
/// their number. Memory beside the map: some 100 bytes a facet, and on each thread 100 more.
/// \param directions unit to 1e-9: from the part towards the spindle.
/// \throws DomainError if a direction is not, or the incidence outside its range.
/// \throws LimitError if the map does not fit into the memory.
PartVisibility part_visibility(const TriangleMesh& part, std::span<const Vec3> directions,
                               const VisibilityOptions& options = {});

/// The facets that no direction reaches, but for the dropped ones: while there is one, no
/// machine can make the part in one setup.
std::vector<std::size_t> empty_cones(const PartVisibility& visibility);

/// The share of the sphere that each facet's cone has, 0 … 1: the solid angles of its cells
/// by those of all.
/// \param solid_angles_sr of the cells. \throws DomainError unless there is one a cell.
std::vector<double> visible_fractions(const VisibilityMap& map,
                                      std::span<const double> solid_angles_sr);

/// Leaves of a map only what a tool reaches that has a body: the tip at a facet's centroid,
/// the axis along the direction, none of the cylinders may meet a facet, touching included.
/// That of the centroid itself counts too: a cylinder that begins at the tip reaches nothing.
/// The future work of the paper. Source: [KangSuh, section 6].
///
/// Decided for the cylinders as they are, flat ends included, not by a cone about the
/// direction; right but for touches within 1e-14 of the largest coordinate. The cutter is not
/// looked at. On all threads; the answer does not depend on their number. up to 90 bytes a facet.
/// \param visibility of `part` along `directions`.
/// \param body such as `tool_body` gives.
/// \param progress as in VisibilityOptions.
/// \throws DomainError unless the map has a bit for each facet and direction, directions are
///         unit to 1e-9, and each cylinder has a positive finite diameter and finite 0 <= from
///         < to.
void keep_reachable(PartVisibility& visibility, const TriangleMesh& part,
                    std::span<const Vec3> directions, std::span<const ToolCylinder> body,
                    const std::function<void(std::size_t done)>& progress = {});

}  // namespace endmill
