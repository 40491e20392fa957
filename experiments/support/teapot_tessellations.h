// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// The teapot's patches divided into (lines - 1)^2 squares of two triangles each, without
/// triangles of zero area; mm. \param lines at least 2.
/// \param has_bottom whether the four patches of the bottom are included, as in the
/// dataset.
TriangleMesh teapot_of_squares(int lines, bool has_bottom);

}  // namespace endmill
