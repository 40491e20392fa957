// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/setup/detail/axis_fit.h"

/// \file
/// Good ranges of tool directions with which the search over whole cones begins.

namespace endmill {

/// Fits a range about each of some axes, to 2 % of the objective.
/// \param fitting problem. \param axes unit.
/// \param below objective, rad^2 or rad, from which on fits are of no interest.
/// \return fits of at most 1.2 times the best of them and `below`; best first, equal ones
///         in the order of the axes.
std::vector<AxisFit> fits_about(const ConeFitting& fitting, std::span<const Vec3> axes,
                                double below);

/// Finds great circles along which a short arc meets all cones. Thin optima lie along
/// such circles, and a descent from other axes misses them.
///
/// Circles through a cell centre of the smallest cone and one of a cone disjoint from it
/// are tried; every range that meets all cones contains two such cells. Cells up to 0.2
/// degrees off a circle count. The best circles are improved by descent.
/// \return unit normals of the circles, shortest arc first.
std::vector<Vec3> short_arcs(const ConeFitting& fitting);

/// Finds a good range within the limits: about the `starts`, about axes spread over the
/// sphere, and along short arcs.
/// \return nothing if none was found.
std::optional<AxisFit> first_fit(const ConeFitting& fitting,
                                 std::span<const Vec3> starts);

}  // namespace endmill
