// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/core/vec.h"
#include "endmill/machine/feasible_directions.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/visibility/sphere_grid.h"
#include "endmill/visibility/visibility.h"

namespace endmill {

/// A part as it is set up on a machine, for pictures.
struct ShownSetup {
    /// A rotation: its rows are the machine's X, Y and Z in coordinates of the part.
    Eigen::Matrix3d part_to_machine = Eigen::Matrix3d::Identity();
    RotaryFrame frame;    ///< the axes in coordinates of the part, at zero
    RotaryLimits needed;  ///< turns that the part asks for; each range holds 0
    std::optional<RotaryLimits> limits{};  ///< the machine's; none: not shown
};

/// What is known of each facet of a part.
struct FacetAccess {
    std::vector<double> visible_fraction;       ///< share of the sphere, 0 … 1
    std::vector<std::uint8_t> reached_at_zero;  ///< 1: without a turn of the rotary axes
};

/// What a cell of setup.vtp belongs to, and a line of the pictures. The numbers stand in files.
enum class SetupObject : std::int32_t {
    Facet = 0,  ///< of the part
    ToolAxis = 1,
    FirstAxis = 2,     ///< R1
    SecondAxis = 3,    ///< R2
    NeededMotion = 4,  ///< border of the directions within the needed turns
    MachineMotion = 5  ///< border of those within the machine's limits
};

/// A line of a picture, by directions from the middle of a sphere.
struct SetupLine {
    SetupObject object;
    DirectionCurve directions;  ///< unit, in the machine's directions
};

/// A sphere around a part.
struct PartSphere {
    Vec3 centre;    ///< mm: the middle of the part's box
    double radius;  ///< mm: a tenth more than the farthest point is away; above 0
};

/// The axes of a setup in the machine's directions.
/// \throws DomainError unless `part_to_machine` is a rotation, to 1e-9.
RotaryFrame machine_directions(const ShownSetup& setup);

/// The borders of the needed and, where they are known, of the machine's directions.
/// Source: [KangSuh, figures 5 and 12].
/// \param step as `FeasibleDirections::border`. \throws DomainError as that and
///        `machine_directions`.
std::vector<SetupLine> motion_borders(const ShownSetup& setup, double step);

/// The points of `mesh` in the machine's directions, the part's origin staying where it is.
std::vector<Vec3> posed_points(const TriangleMesh& mesh, const ShownSetup& setup);

/// The sphere around points. A single place has a radius of 1 mm.
/// \throws DomainError without a point.
PartSphere sphere_around(const std::vector<Vec3>& points);

/// What a picture calls an axis: "tool axis", or "R1 = C" after the machine's axis that it is
/// nearest to.
std::string axis_label(SetupObject object, const RotaryFrame& machine_directions);

/// What surrounds the picture of a setup.
struct SetupFigure {
    std::string title = "Setup";           ///< above it; at most 100 characters show
    std::vector<std::string> captions{};   ///< lines below the title; 150 characters show
    double width_px = 900;                 ///< of the whole picture, at least 300
    Angle azimuth = Angle::degrees(-60);   ///< where the viewer stands, from X towards Y
    Angle elevation = Angle::degrees(25);  ///< of the viewer over the XY plane
    std::size_t most_facets = 20'000;      ///< drawn; at least 1
};

/// A part as it is set up on a machine, as an SVG file: shaded by the light from behind the
/// viewer, in blue where the tool reaches it without a turn of the rotary axes, in yellow where
/// it must turn, grey where one looks at the back of a facet; the rotary axes and the tool axis
/// as lines through its middle, and below it the machine's X, Y and Z. What lies further back
/// is drawn first, by the middles of facets, so that facets that pass through each other may
/// show in the wrong order. Of more than `most_facets` a coarser mesh is drawn, and a line
/// below the title says so.
/// Source: [KangSuh, figure 11].
/// \param reached_at_zero one a facet, 1 or 0.
/// \throws DomainError if the mesh has no facet, `reached_at_zero` is not of its facets, or as
///         `machine_directions` and `AxonometricFigure`.
std::string setup_svg(const TriangleMesh& mesh,
                      std::span<const std::uint8_t> reached_at_zero,
                      const ShownSetup& setup, const SetupFigure& figure);

/// Cells of a sphere that are filled one by one; of a finer one only the outlines show.
inline constexpr std::size_t most_filled_cells = 100'000;

/// What is drawn on a sphere of directions, and what surrounds it.
struct SphereFigure {
    std::string title = "Directions";      ///< above it; at most 100 characters show
    std::vector<std::string> captions{};   ///< lines below the title; 150 characters show
    double width_px = 900;                 ///< of the whole picture, at least 300
    Angle azimuth = Angle::degrees(-60);   ///< where the viewer stands, from X towards Y
    Angle elevation = Angle::degrees(30);  ///< of the viewer over the XY plane
    std::optional<ShownSetup> setup{};  ///< axes and borders; none: the part's directions
    std::vector<Vec3> marked{};  ///< unit, the part's: discs, such as the paper's MD
};

/// The sphere of directions as an SVG file: the front half of its cells, shaded by how many
/// facets a tool reaches along them; with a setup in the machine's directions at zero,
/// with its axes and the borders of its motion, dashed where they are behind.
/// Source: [KangSuh, figure 12].
/// \throws DomainError unless the map has the grid's cells and at least one facet, or as
///         `motion_borders` and `AxonometricFigure`.
std::string sphere_svg(const SphereGrid& grid, const VisibilityMap& map,
                       const SphereFigure& figure);

/// A part as it is set up on a machine, as a VTK XML PolyData file (.vtp), for ParaView and
/// VTK: lengths in mm, in the machine's directions with all rotary axes at zero.
///
/// Cells, by `object`: 0 the part's facets, in their order; 1 the tool axis, 2 R1 and 3 R2 as
/// lines through the middle of the part; 4 the border of the directions that the part asks for
/// and 5 that of the machine's, on a sphere around the part, a direction standing where a tool
/// along it leaves the sphere. A border that is one direction is a vertex. Facets have
/// `visible_fraction` (share of the sphere, 0 … 1) and `reached_at_zero` (1 or 0), other cells
/// 0 of both.
/// \throws DomainError if the mesh has no facet, `access` is not of its facets, or as
///         `motion_borders`.
std::string setup_vtp(const TriangleMesh& mesh, const FacetAccess& access,
                      const ShownSetup& setup);

}  // namespace endmill
