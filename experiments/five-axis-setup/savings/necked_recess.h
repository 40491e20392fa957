// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// A cylinder of 60 mm diameter and 40 mm height with a recess of 40 mm diameter and 20 mm
/// height, which opens to the top through a neck of 10 mm diameter and 10 mm length; 24
/// sides. No tool reaches the downward side of the recess, where it meets the neck: a ray
/// from there that leaves the surface ends at the wall or the floor of the recess.
TriangleMesh necked_recess();

}  // namespace endmill
