// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/surface/surface.h"

/// \file
/// The planners march along u only. A surface that is planned along v is transposed
/// first, and the parameters of the results are exchanged afterwards.

namespace endmill {

/// A surface on which all passes run along u, and the sign of its normals.
struct MarchedSurface {
    Surface surface;  ///< the part, transposed if it is planned along v
    double side;      ///< turns du x dv to the tool's side; from tool_side_sign
};

/// The surface to march on for passes along `direction` of `surface`.
/// \param surface   the part.
/// \param side      from tool_side_sign, for `surface` itself.
/// \param direction the parameter that varies along a pass.
MarchedSurface marched_surface(const Surface& surface, double side, Parameter direction);

/// Parameters of a marched surface, in the order of the original surface.
SurfacePoint in_surface_order(const SurfacePoint& at, Parameter direction);

}  // namespace endmill
