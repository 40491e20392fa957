// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "endmill/mesh/triangle_mesh.h"
#include "endmill/surface/part.h"
#include "endmill/surface/surface_jet.h"

/// \file
/// The part as a set of charts. Each chart is divided into cells with one measuring ray
/// each. A chart is a patch of a surface or a triangle of a mesh.

namespace endmill {

/// A point of the part and the direction in which its deviation is measured.
struct PartRay {
    Vec3 point = Vec3::Zero();   ///< mm
    Vec3 normal = Vec3::Zero();  ///< unit, on the tool's side
    Vec3 du = Vec3::Zero();      ///< partial by u, mm per unit of the chart's parameter
    Vec3 dv = Vec3::Zero();      ///< partial by v, mm per unit of the chart's parameter
};

/// Whether the surface has a normal at the ray. Without one the normal is zero.
inline bool has_normal(const PartRay& ray)
{
    return !ray.normal.isZero(0);
}

/// A piece of the part with three or four corners in the parameters of a chart: global
/// (u, v) for a patch of a surface, the barycentric coordinates of the second and third
/// corner for a triangle.
struct PartCell {
    std::uint32_t chart = 0;  ///< number of the chart
    int corners = 4;          ///< 3 or 4
    /// Corners in order; the last is unused for three.
    std::array<Eigen::Vector2d, 4> at{};

    /// Mean of the corners, in parameters.
    Eigen::Vector2d centre() const;

    /// Four cells of half the size that cover the cell.
    std::array<PartCell, 4> quarters() const;

    /// Area in mm^2, from the partials at the centre. It is exact if these are constant
    /// on the cell.
    double area(const PartRay& centre_ray) const;
    /// Distance in mm of the furthest corner from the centre, from the partials at the
    /// centre.
    double reach(const PartRay& centre_ray) const;
};

/// The numbered patches or triangles of a part that face the tool. It refers to the part,
/// which must outlive it.
class PartCharts {
public:
    /// The charts of surfaces: every patch.
    /// \param sides sign of the normal on the tool's side for each surface, from
    ///        tool_side_signs.
    /// \throws DomainError unless there is one side per surface.
    PartCharts(std::span<const Surface> surfaces, std::span<const double> sides);

    /// The charts of a mesh: the triangles that do not face away from +z. A 3-axis cutter
    /// cannot reach undersides. Triangles without area are omitted too.
    explicit PartCharts(const TriangleMesh& mesh);

    /// The charts of a mesh for tools along any of these axes: the triangles that do not
    /// face away from all of them.
    /// \param tool_axes unit, from the tip to the spindle.
    PartCharts(const TriangleMesh& mesh, std::span<const Vec3> tool_axes);
    /// A temporary mesh would not outlive the charts.
    explicit PartCharts(TriangleMesh&&) = delete;
    /// A temporary mesh would not outlive the charts.
    PartCharts(TriangleMesh&&, std::span<const Vec3> tool_axes) = delete;

    /// Number of charts.
    std::uint32_t count() const { return static_cast<std::uint32_t>(charts_.size()); }

    /// The whole chart as a cell.
    PartCell whole(std::uint32_t chart) const;

    /// Returns point and normal at the parameters `at` of a chart.
    /// \return nothing if the surface has no normal there.
    std::optional<PartRay> ray(std::uint32_t chart, const Eigen::Vector2d& at) const;

    /// Returns the rays at all (u[i], v[j]) of a chart of a surface, in element j *
    /// u.size() + i. It is faster than `ray` for each and equal within rounding. Where
    /// the surface has no normal, the normal is zero.
    std::vector<PartRay> rays(std::uint32_t chart, std::span<const double> u,
                              std::span<const double> v) const;

    /// Returns only the points of these rays, mm.
    std::vector<Vec3> points(std::uint32_t chart, std::span<const double> u,
                             std::span<const double> v) const;

    /// Extreme normal curvatures at a place, in 1/mm.
    struct CurvatureBounds {
        double convex;    ///< greatest convex curvature, at least 0
        double absolute;  ///< greatest absolute curvature
    };
    /// Returns the normal curvatures at a place; 0 on a mesh and where there is no
    /// normal.
    CurvatureBounds curvature(std::uint32_t chart, const Eigen::Vector2d& at) const;

    /// Whether a corner of the cell lies on a side of its chart. Beyond the side the part
    /// may end or continue with another normal.
    bool touches_side(const PartCell& cell) const;

    /// Whether a corner of the cell lies on the border of the part: a side of a surface
    /// that meets no other side, or an edge of one triangle only.
    bool touches_border(const PartCell& cell) const;

    /// Whether a whole side of the cell lies on the border of the part.
    bool runs_along_border(const PartCell& cell) const;

    /// Returns the number of the surface, or of the triangle, to which a chart belongs.
    std::size_t source(std::uint32_t chart) const;

    const TriangleMesh* mesh() const { return mesh_; }  ///< null for surfaces
    std::span<const Surface> surfaces() const { return surfaces_; }  ///< empty for a mesh
    std::span<const double> sides() const { return sides_; }         ///< as given

private:
    // One bit per side of a chart. Side k runs from corner k of the whole chart to the
    // next.
    using Sides = std::uint8_t;

    struct Chart {
        std::uint32_t source;            // surface or triangle
        std::int32_t column;             // of the patch
        std::int32_t row;                // of the patch
        Eigen::Vector2d low = {0, 0};    // least parameters
        Eigen::Vector2d width = {1, 1};  // range of the parameters
    };

    PartRay ray(const Chart& chart, const SurfaceTangents& tangents) const;
    void mark_borders_of_surfaces();
    void mark_borders_of_mesh();
    Sides touched(const PartCell& cell, int corners) const;

    const TriangleMesh* mesh_ = nullptr;
    std::span<const Surface> surfaces_;
    std::vector<double> sides_;
    std::vector<Chart> charts_;
    std::vector<Sides> borders_;  // sides of each chart on the border of the part
};

/// Greatest number of cells of a tile.
inline constexpr int most_tile_cells = 64;

/// A piece of a chart that is cut into cells: a quadrilateral into columns by rows, a
/// triangle into the square of `columns`.
struct PartTile {
    PartCell whole;  ///< the piece
    int columns;     ///< cells along the side from corner 0 to corner 1, 1 to 8
    /// Cells along the side from corner 0 to the last; = columns on a triangle.
    int rows;
    std::size_t first;  ///< number of its first cell among the cells of all tiles
    int cells() const { return columns * rows; }  ///< at most most_tile_cells

    /// Returns the cell with this number, from 0.
    PartCell cell(int number) const;
};

/// Returns the charts of a part for a tool along +z.
PartCharts part_charts(const Part& part);

/// Returns the charts of a part for a tool whose axis turns. Triangles that face away from
/// all axes are left out, because no cutter touches them. The tool side of surfaces is that
/// for +z.
/// \param tool_axes unit, of all points of a path.
PartCharts part_charts(const Part& part, std::span<const Vec3> tool_axes);

}  // namespace endmill
