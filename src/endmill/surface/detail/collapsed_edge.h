// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/surface/bezier_patch.h"
#include "endmill/surface/surface_jet.h"

namespace endmill {

/// Whether an edge of a patch is a single point: all its control points agree up to
/// `same_point_share` of the patch's size. Such an edge is a pole, where the surface has
/// a normal at best as a limit.
/// \param patch of any degree.
/// \param parameter constant on the edge.
/// \param edge its value there, 0 or 1.
bool is_collapsed(const BezierPatch& patch, Parameter parameter, int edge);

}  // namespace endmill
