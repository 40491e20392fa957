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

}  // namespace endmill::cad
