// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/surface/bezier_patch.h"
#include "endmill/surface/surface_jet.h"

namespace endmill {

/// Whether the edge of `patch` on which `parameter` is `edge` (0 or 1) is one point: all
/// its control points agree to 1e-12 of the patch's size. Such an edge is a pole; the
/// normal there is at best a limit.
bool is_collapsed(const BezierPatch& patch, Parameter parameter, int edge);

}  // namespace endmill
