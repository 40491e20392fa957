// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/core/vec.h"
#include "endmill/machine/configuration.h"
#include "endmill/machine/feasible_directions.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/visibility/sphere_grid.h"
#include "endmill/visibility/visibility.h"

/// \file
/// Figures of a five-axis setup: the part in its pose (`setup_svg`), the cone of a facet
/// (`cone_svg`), the sphere of directions (`sphere_svg`), and part and directions in one
/// VTK file (`setup_vtp`).
///
/// Sketches of milling machines: which axes they have, in which order, and what each
/// carries.
///
/// Implemented in `shown_setup.cpp` (what the figures share), `setup_svg.cpp`,
/// `cone_svg.cpp`, `sphere_svg.cpp`, `setup_vtp.cpp` and `machine_figure.cpp` (the
/// sketches).

namespace endmill {

/// The pose of a part on a machine, and the ranges of the rotary axes.
struct ShownSetup {
    /// A rotation; its rows are the machine's X, Y and Z in coordinates of the part.
    Eigen::Matrix3d part_to_machine = Eigen::Matrix3d::Identity();
    RotaryFrame frame;    ///< axes in coordinates of the part, all at zero
    RotaryLimits needed;  ///< ranges that the part needs; each contains 0
    std::optional<RotaryLimits> limits{};  ///< ranges of the machine; nothing: not drawn
};

/// Accessibility of each facet of a part.
struct FacetAccess {
    std::vector<double> visible_fraction;  ///< solid angle of the cone over 4 pi, 0 … 1
    std::vector<std::uint8_t> reached_at_zero;  ///< 1: with all rotary axes at zero
};

/// For each facet of the map 1 if the tool reaches it with all rotary axes at zero, else
/// 0. The cell of the grid that is nearest to the tool axis replaces it.
/// \param map       of the cells of `grid`.
/// \param tool_axis unit vector in coordinates of the part.
std::vector<std::uint8_t> reached_at_zero(const SphereGrid& grid,
                                          const VisibilityMap& map,
                                          const Vec3& tool_axis);

/// The object to which a cell of setup.vtp or a line of a figure belongs. The numbers are
/// written to files.
enum class SetupObject : std::int32_t {
    Facet = 0,         ///< facet of the part
    ToolAxis = 1,      ///< tool axis at zero
    FirstAxis = 2,     ///< rotary axis R1
    SecondAxis = 3,    ///< rotary axis R2
    NeededMotion = 4,  ///< border of the directions within the needed ranges
    MachineMotion = 5  ///< border of the directions within the machine's limits
};

/// A line on the sphere of directions.
struct SetupLine {
    SetupObject object;         ///< to which the line belongs
    DirectionCurve directions;  ///< unit vectors in coordinates of the machine
};

/// A sphere around a part.
struct PartSphere {
    Vec3 centre;    ///< centre of the part's bounding box, in mm
    double radius;  ///< 1.1 times the largest distance from the centre, in mm
};

/// The axes of a setup in coordinates of the machine.
/// \throws DomainError unless `part_to_machine` is a rotation within 1e-9.
RotaryFrame machine_directions(const ShownSetup& setup);

/// The borders of the needed directions and, if the limits are known, of the machine's.
/// Source: [KangSuh, figures 5 and 12].
/// \param step as in `FeasibleDirections::border`.
/// \throws DomainError as `FeasibleDirections::border` and `machine_directions`.
std::vector<SetupLine> motion_borders(const ShownSetup& setup, double step);

/// The points of `mesh` in coordinates of the machine; the origin of the part is fixed.
std::vector<Vec3> posed_points(const TriangleMesh& mesh, const ShownSetup& setup);

/// The sphere around points. Its radius is positive: it is 1 mm if all points coincide.
/// \throws DomainError if there is no point.
PartSphere sphere_around(const std::vector<Vec3>& points);

/// The name of an axis in a legend: "tool axis", or "R1 = C" after the nearest machine
/// axis.
std::string axis_label(SetupObject object, const RotaryFrame& machine_directions);

/// Title, size and view of the figure of a setup.
struct SetupFigure {
    std::string title = "Setup";           ///< above the figure; cut after 100 characters
    std::vector<std::string> captions{};   ///< lines below the title; cut after 150
    double width_px = 900;                 ///< of the whole picture, at least 300
    Angle azimuth = Angle::degrees(-60);   ///< direction to the viewer, from X towards Y
    Angle elevation = Angle::degrees(25);  ///< of the viewer above the XY plane
    std::size_t most_facets = 20'000;      ///< largest number of drawn facets; at least 1
    /// Names of the part's own x, y and z, which `setup_svg` draws from the centre of the
    /// part; an axis without a name is not drawn. If z has a name, an arc with the angle
    /// between z and the tool axis is drawn too.
    std::array<std::string, 3> part_axis_names{};
};

/// A part in its pose on a machine, as an SVG file. Facets that the tool reaches with all
/// axes at zero are blue, facets that need a rotation are yellow, and facets seen from
/// behind are grey. A light from the viewer shades them. The rotary axes and the tool
/// axis are lines through the centre of the part; the machine's X, Y and Z are below.
/// Facets are drawn in the order of the depth of their centres. Facets that intersect may
/// therefore be drawn in the wrong order. A part with more than `most_facets` is drawn
/// coarser, and a caption states it.
/// Source: [KangSuh, figure 11].
/// \param reached_at_zero one for each facet, 1 or 0.
/// \throws DomainError if the mesh has no facet, `reached_at_zero` has another size, and
///         as `machine_directions` and `AxonometricFigure`.
std::string setup_svg(const TriangleMesh& mesh,
                      std::span<const std::uint8_t> reached_at_zero,
                      const ShownSetup& setup, const SetupFigure& figure);

/// The visibility cone of one facet, drawn on the part, as an SVG file: the part in grey
/// with the facet in blue, the cells of the cone on a sphere about the centroid of the
/// facet, and lines from the centroid to the rim of the cone. Cells and lines are drawn
/// over the part. Axes are those of the part.
/// Source: [KangSuh, figure 1 (a)].
/// \param facet number of the facet. \param map of `mesh` and the cells of `grid`.
/// \param figure title, captions and view; `part_axis_names` is not used.
/// \throws DomainError unless the map has the facets of the mesh and the cells of the
///         grid, and `facet` is one of them; and as `AxonometricFigure`.
std::string cone_svg(const TriangleMesh& mesh, std::size_t facet, const SphereGrid& grid,
                     const VisibilityMap& map, const SetupFigure& figure);

/// Largest number of cells of a sphere that are filled. Grids with more cells are drawn
/// as borders only.
inline constexpr std::size_t most_filled_cells = 100'000;

/// Title, size, view and content of the figure of a sphere of directions.
struct SphereFigure {
    std::string title = "Directions";      ///< above the figure; cut after 100 characters
    std::vector<std::string> captions{};   ///< lines below the title; cut after 150
    double width_px = 900;                 ///< of the whole picture, at least 300
    Angle azimuth = Angle::degrees(-60);   ///< direction to the viewer, from X towards Y
    Angle elevation = Angle::degrees(30);  ///< of the viewer above the XY plane
    std::optional<ShownSetup> setup{};     ///< its axes and borders are drawn
    /// Unit vectors of the part that are drawn as discs: for each cone the cell nearest
    /// to the tool axis (MD in [KangSuh]).
    std::vector<Vec3> marked{};
};

/// The sphere of directions as an SVG file: the front half of its cells, shaded by the
/// number of facets that a tool reaches along them. With a setup, directions are in
/// machine coordinates with all axes at zero. Its axes and the borders of its motion are
/// then drawn, dashed behind the sphere.
/// Source: [KangSuh, figure 12].
/// \throws DomainError unless the map has the cells of the grid and at least one facet,
///         and as `motion_borders` and `AxonometricFigure`.
std::string sphere_svg(const SphereGrid& grid, const VisibilityMap& map,
                       const SphereFigure& figure);

/// A part in its pose on a machine, as a VTK XML PolyData file (.vtp) for ParaView and
/// VTK. Lengths are in mm, in coordinates of the machine with all rotary axes at zero.
///
/// The cell data `object` are the numbers of SetupObject: 0 the facets, in order; 1 the
/// tool axis, 2 R1 and 3 R2 as lines through the centre of the part; 4 the border of the
/// needed directions and 5 that of the machine's, on a sphere around the part (a
/// direction is the point where a tool axis through the centre leaves the sphere). A
/// border of a single direction is a vertex. Facets have `visible_fraction` (0 … 1) and
/// `reached_at_zero` (1 or 0); both are 0 for other cells.
/// \throws DomainError if the mesh has no facet, `access` has another size, and as
///         `motion_borders`.
std::string setup_vtp(const TriangleMesh& mesh, const FacetAccess& access,
                      const ShownSetup& setup);

/// The linear axes X, Y, Z and the rotary axes A, B, C with their positive directions, as
/// an SVG file.
/// Source: after [KangSuh, figure 3].
std::string machine_axes_svg(const std::string& title);

/// A sketch of a machine with up to two rotary axes, all axes at zero, as an SVG file.
/// The axes that carry the part are stacked below it and those that carry the tool above
/// it, in the order of the configuration word; a bed joins both. The shape is schematic.
/// Source: after [KangSuh, figure 4].
/// \param captions lines below the title.
std::string machine_svg(const MachineConfiguration& machine, const std::string& title,
                        const std::vector<std::string>& captions);

}  // namespace endmill
