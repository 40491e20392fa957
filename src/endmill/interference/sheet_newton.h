// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to interference
#pragma once

#include <functional>
#include <optional>

#include <Eigen/Core>

#include "endmill/interference/drive_planes.h"
#include "endmill/interference/section_curve.h"
#include "endmill/surface/surface_jet.h"

namespace endmill {

/// A smooth piece of an offset: reference points by two parameters, with their partials in
/// mm a unit; nothing where it is not defined.
using SmoothSheet =
    std::function<std::optional<SurfaceTangents>(const Eigen::Vector2d& at)>;

/// A place on a sheet, how far from it a search may go in each parameter, and where the
/// sheet ends: a search may pass over an end, but not stop beyond it.
struct SheetStart {
    SmoothSheet sheet;
    Eigen::Vector2d at;
    Eigen::Vector2d reach;
    Eigen::Vector2d low = Eigen::Vector2d::Constant(-1e300);
    Eigen::Vector2d high = Eigen::Vector2d::Constant(1e300);
};

/// How far from what it is to solve a solution may be, in mm: rounding of coordinates of
/// metres, and far below what is asked of a refined point, 1e-4 mm.
inline constexpr double sheet_residual = 1e-9;

/// The height z in mm, reference point, at which a sheet stands over the point `s` of the
/// plane `across`, by Newton's method.
/// \return nothing if it does not converge to `sheet_residual` within the start's reach.
std::optional<double> height_on_sheet(const SheetStart& start, const DriveFrame& frame,
                                      double s, double across);

/// Where two sheets meet in the plane `across`: two contacts at once, four unknowns.
/// \return nothing if it does not converge as above, or they do not cross transversally.
std::optional<SectionPoint> crossing_of_sheets(const SheetStart& one,
                                               const SheetStart& other,
                                               const DriveFrame& frame, double across);

}  // namespace endmill
