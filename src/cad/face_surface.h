// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include <Geom_BSplineSurface.hxx>
#include <TopoDS_Face.hxx>

namespace endmill::cad {

/// The kind of the surface of a face: plane, cylinder, cone, sphere, torus, bezier, nurbs,
/// revolution, extrusion, offset or other.
std::string_view surface_kind(const TopoDS_Face& face);

/// Whether the outline of a face is more than the four sides of a rectangle of its parameters.
bool is_trimmed(const TopoDS_Face& face);

/// The surface of a face over its rectangle of parameters, as a spline that is not periodic.
/// Its points are those of the face; the parameters differ where the surface has circles.
/// \pre the face is not trimmed.
/// \return null if the kind has no exact spline, or if OpenCASCADE does not find it.
Handle(Geom_BSplineSurface) whole_surface(const TopoDS_Face& face);

/// Largest balls that the curvature of a face admits, mm; nothing where it sets no limit.
struct FaceBalls {
    std::optional<double>
        outside;                   ///< on the side that the orientation of the face tells
    std::optional<double> inside;  ///< on the other side
};

/// The largest balls for a face, by its curvature at the points of its triangulation and at the
/// middles of its triangles. Between them a NURBS face may be more curved.
/// \return nothing if the face has no triangulation or no curvature at any of these points.
std::optional<FaceBalls> balls_at_mesh(const TopoDS_Face& face);

}  // namespace endmill::cad
