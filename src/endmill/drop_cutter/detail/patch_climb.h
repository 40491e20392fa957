// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <Eigen/Core>

#include "endmill/cutter/cutter.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// One patch of a surface: column i in u, row j in v.
struct PatchNumber {
    int i;
    int j;
    friend bool operator==(const PatchNumber&, const PatchNumber&) = default;
};

/// Where a cutter rests on a patch that it is lowered onto.
struct PatchContact {
    PatchNumber patch;
    Eigen::Vector2d at;     ///< u and v, global
    Vec3 point;             ///< mm
    double height;          ///< z of the reference point, mm
    Eigen::Vector2d slope;  ///< of the height, as the cutter moves in x and in y
    /// How the cutter would rise on, in mm per mm, where the patch ends: in u and in v, to
    /// the side that the sign tells; 0 inside, and where it would not.
    Eigen::Vector2d beyond;
};

/// A place of a surface below the cutter that is found by going from `start` towards its
/// axis, along the surface's ends where the way leads out of it.
/// \param start u and v. \param axis x and y of the cutter in mm.
/// \return `start` if it is below; nothing where the way ends beside the cutter.
std::optional<Eigen::Vector2d> place_below(const Surface& surface,
                                           const Eigen::Vector2d& start,
                                           const Cutter& cutter,
                                           const Eigen::Vector2d& axis);

/// Goes uphill on a patch from a place to the nearest point that carries the cutter highest:
/// inside of the patch by its normal, on its edge, or in its corner; of a flat cutter at its
/// rim, or anywhere below it. By Newton's method with an active set, never downhill.
/// \param start u and v; the nearest place of the patch is taken.
/// \param axis  x and y of the cutter in mm.
/// \return the contact, its height right to 1e-12 mm, of a flat cutter to 1e-10 of R; nothing
///         where the start is not below the cutter.
std::optional<PatchContact> climb(const Surface& surface, PatchNumber patch,
                                  const Eigen::Vector2d& start, const Cutter& cutter,
                                  const Eigen::Vector2d& axis);

}  // namespace endmill
