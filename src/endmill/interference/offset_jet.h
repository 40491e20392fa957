// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to interference
#pragma once

#include <optional>

#include "endmill/cutter/cutter.h"
#include "endmill/surface/parameter.h"
#include "endmill/surface/surface_jet.h"

namespace endmill {

/// The reference point of `cutter` that touches a surface from above at `jet`, with its
/// first partials in mm per unit of u and v: p + r N + (R - r) H, see control_offset.
/// \param side turns du x dv to the tool's side, see tool_side_sign.
/// \return nothing where the surface `is_singular`; and for a cutter with a flat bottom
///         where N is level to 1e-6 of its length: H turns without bound there.
/// Source: [JangKimJeong, eq. (3)], differentiated.
std::optional<SurfaceTangents> offset_jet(const SurfaceJet& jet, double side,
                                          const Cutter& cutter);

/// The same where the cutter touches the line u = const or v = const of the surface with a
/// normal turned about it by `angle`, in rad: N cos + (T x N) sin, T the unit tangent of
/// the line. Partials are those along the line, in `du`, and by the angle, in `dv`.
/// \param along the parameter that varies on the line.
/// \return nothing also where the line has no tangent.
std::optional<SurfaceTangents> turned_offset_jet(const SurfaceJet& jet, double side,
                                                 Parameter along, double angle,
                                                 const Cutter& cutter);

}  // namespace endmill
