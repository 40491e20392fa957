// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "endmill/mesh/triangle_mesh.h"
#include "endmill/surface/part.h"
#include "endmill/surface/surface_jet.h"

namespace endmill {

/// A point of the part and the direction in which its deviation is measured.
struct PartRay {
    Vec3 point = Vec3::Zero();   ///< mm
    Vec3 normal = Vec3::Zero();  ///< unit, on the tool's side
    Vec3 du = Vec3::Zero();      ///< partials, mm per unit of the chart's parameters
    Vec3 dv = Vec3::Zero();      ///< ditto
};

/// Whether the surface has a normal there: else it is zero.
inline bool has_normal(const PartRay& ray)
{
    return !ray.normal.isZero(0);
}

/// A piece of a part: three or four corners in the parameters of a chart, which is a
/// patch of a surface (u, v global) or a triangle of a mesh (shares of its second and
/// third corner).
struct PartCell {
    std::uint32_t chart = 0;
    int corners = 4;
    std::array<Eigen::Vector2d, 4> at{};  ///< in order around; the last unused of three

    /// Mean of the corners.
    Eigen::Vector2d centre() const;

    /// Four cells of half the size that cover it.
    std::array<PartCell, 4> quarters() const;

    /// Area in mm^2, and the distance in mm of its furthest corner from the centre, both by
    /// the partials at its centre: right but for what these change within the cell.
    double area(const PartRay& centre_ray) const;
    double reach(const PartRay& centre_ray) const;
};

/// Patches or triangles of a part that face the tool, numbered through. Refers to the
/// part, which must outlive it.
class PartCharts {
public:
    /// Surfaces: every patch. \param sides from tool_side_signs, one a surface.
    PartCharts(std::span<const Surface> surfaces, std::span<const double> sides);

    /// A mesh: the triangles that do not face away from +z; undersides are out of reach of
    /// a three-axis cutter, and those without area are left out too.
    explicit PartCharts(const TriangleMesh& mesh);
    explicit PartCharts(TriangleMesh&&) = delete;  // it would not outlive the charts

    std::uint32_t count() const { return static_cast<std::uint32_t>(charts_.size()); }

    /// The whole chart as a cell.
    PartCell whole(std::uint32_t chart) const;

    /// Point and normal at a place of a chart.
    /// \return nothing where the surface has no normal.
    std::optional<PartRay> ray(std::uint32_t chart, const Eigen::Vector2d& at) const;

    /// The same at all (u[i], v[j]) of a chart of a surface, at [j * u.size() + i]: as one
    /// by one but for rounding, and sooner. The normal is zero where the surface has none.
    std::vector<PartRay> rays(std::uint32_t chart, std::span<const double> u,
                              std::span<const double> v) const;

    /// Only the points of these.
    std::vector<Vec3> points(std::uint32_t chart, std::span<const double> u,
                             std::span<const double> v) const;

    /// Largest convex and largest absolute normal curvature there, in 1/mm; 0 on a mesh.
    struct Bend {
        double convex;
        double any;
    };
    Bend bend(std::uint32_t chart, const Eigen::Vector2d& at) const;

    /// Whether a corner of the cell lies on a side of its chart. Beyond it the part may end,
    /// or go on with another normal.
    bool touches_side(const PartCell& cell) const;

    /// The same for sides at which the part ends: those of a surface that meet no other,
    /// and edges of one triangle only.
    bool touches_border(const PartCell& cell) const;

    /// Whether a whole side of the cell lies on such a side.
    bool runs_along_border(const PartCell& cell) const;

    /// Number of the surface, or of the triangle, that a chart is of.
    std::size_t source(std::uint32_t chart) const;

    const TriangleMesh* mesh() const { return mesh_; }               ///< none of surfaces
    std::span<const Surface> surfaces() const { return surfaces_; }  ///< none of a mesh
    std::span<const double> sides() const { return sides_; }         ///< of the surfaces

private:
    // Side k of a chart runs from corner k of the whole to the next; a bit for each.
    using Sides = std::uint8_t;

    struct Chart {
        std::uint32_t source;  // surface or triangle
        std::int32_t column;   // of the patch
        std::int32_t row;
        Eigen::Vector2d low = {0, 0};  // its least parameters
        Eigen::Vector2d width = {1, 1};
    };

    PartRay ray(const Chart& chart, const SurfaceTangents& tangents) const;
    void mark_borders_of_surfaces();
    void mark_borders_of_mesh();
    Sides touched(const PartCell& cell, int corners) const;

    const TriangleMesh* mesh_ = nullptr;
    std::span<const Surface> surfaces_;
    std::vector<double> sides_;
    std::vector<Chart> charts_;
    std::vector<Sides> borders_;  // of each chart, at which the part ends
};

/// The charts of a part of either kind, for a tool along +z.
PartCharts part_charts(const Part& part);

}  // namespace endmill
