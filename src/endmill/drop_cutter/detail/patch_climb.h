// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <Eigen/Core>

#include "endmill/cutter/cutter.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// A patch of a surface: column i in u, row j in v.
struct PatchNumber {
    int i;  ///< column
    int j;  ///< row
    friend bool operator==(const PatchNumber&, const PatchNumber&) = default;
};

/// The contact of a cutter that was lowered onto a patch.
struct PatchContact {
    /// The patch.
    PatchNumber patch;
    Eigen::Vector2d at;     ///< u and v, global
    Vec3 point;             ///< mm
    double height;          ///< z of the reference point, mm
    Eigen::Vector2d slope;  ///< derivative of the height by x and y of the axis
    /// The derivative of the height beyond the edges of the patch, in mm per mm, for u
    /// and for v. Its sign gives the side. It is 0 inside the patch and where the height
    /// does not grow beyond the edge.
    Eigen::Vector2d beyond;
};

/// A position of a surface below the cutter. The search goes from `start` towards the
/// axis, and along the edges of the surface where the way leaves it.
/// \param surface the surface.
/// \param start u and v.
/// \param cutter the cutter.
/// \param axis x and y of the cutter in mm.
/// \return `start` if it is below the cutter; nothing if the way ends beside the cutter.
std::optional<Eigen::Vector2d> place_below(const Surface& surface,
                                           const Eigen::Vector2d& start,
                                           const Cutter& cutter,
                                           const Eigen::Vector2d& axis);

/// The highest contact of a cutter with a patch that is reached by climbing from a
/// position. The contact may be inside the patch, on an edge or in a corner; with a flat
/// cutter at its rim or anywhere below it. Uses Newton's method with an active set; the
/// height never falls.
/// \param surface the surface.
/// \param patch the patch of it.
/// \param start u and v; the nearest position of the patch is taken.
/// \param cutter the cutter.
/// \param axis x and y of the cutter in mm.
/// \return the contact; its height is accurate to 1e-12 mm, and for a flat cutter to
///     1e-10 R. Nothing if the start is not below the cutter.
std::optional<PatchContact> climb(const Surface& surface, PatchNumber patch,
                                  const Eigen::Vector2d& start, const Cutter& cutter,
                                  const Eigen::Vector2d& axis);

}  // namespace endmill
