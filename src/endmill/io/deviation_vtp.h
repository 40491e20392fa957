// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "endmill/simulation/deviation.h"

namespace endmill {

/// Points of a deviation's file, unless the caller says otherwise: 22 MB.
inline constexpr std::size_t usual_deviation_points = 500'000;

/// The deviation of a part as a VTK XML PolyData file (.vtp), lengths in mm, for ParaView
/// and VTK.
///
/// Points are the middles of the part's cells, in their order, each a vertex of its own;
/// point data are `left_mm`, along the normal, negative where too much is gone, and
/// `normal`. All are Float32, as the deviation is. Cells without area are left out: they
/// have no normal. If there are more than `most_points`, of every so many cells in a row
/// there stand only the one with the most and the one with the least left, so that
/// neither the deepest gouge nor the highest rest is lost.
///
/// \param charts those that were measured. \param most_points at least 2.
/// \throws DomainError if `most_points` is less, the deviation is not one of `charts`, or
///         a number is not finite.
std::string deviation_vtp(const PartCharts& charts, const Deviation& deviation,
                          std::size_t most_points = usual_deviation_points);

}  // namespace endmill
