// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// The teapot's patches in (lines - 1)^2 squares each, two triangles a square, those without
/// area left out; mm. \param lines at least 2. \param has_bottom whether its four patches are
/// there, as they are in the dataset.
TriangleMesh teapot_of_squares(int lines, bool has_bottom);

}  // namespace endmill
