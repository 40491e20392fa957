// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/setup/detail/axis_fit.h"

namespace endmill {

/// A good fit about each of `axes`, of those that have one within 1.2 times the best of them
/// and `below`; best first, ties by the order of the axes.
std::vector<AxisFit> fits_about(const ConeFitting& fitting, std::span<const Vec3> axes,
                                double below);

/// Great circles along which a short arc meets all cones: their normals, shortest arc first.
/// Circles through two cell centres, one of them of the smallest cone, are tried, with cells up
/// to 0.2 degrees off; the best are improved by descent. Thin optima lie on such circles, and
/// a search that only descends from elsewhere misses them.
std::vector<Vec3> short_arcs(const ConeFitting& fitting);

/// A good set within the limits, or nothing if none was found: of those about the `starts`,
/// about axes spread over the sphere, and along short arcs.
std::optional<AxisFit> first_fit(const ConeFitting& fitting,
                                 std::span<const Vec3> starts);

}  // namespace endmill
