// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// The part to be made: one or several surfaces, which are planned separately, or a mesh.
using Part = std::variant<std::vector<Surface>, TriangleMesh>;

}  // namespace endmill
