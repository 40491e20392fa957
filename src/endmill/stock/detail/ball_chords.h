// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <Eigen/Core>

#include "endmill/core/vec.h"
#include "endmill/machine/tool_motion.h"

/// \file
/// What a moving ball-end mill removes on parallel rays, for eight rays at once. The numbers
/// are those of `RayOnMotion` and `CuttingBody` for an endless ball, without their branches.

namespace endmill {

/// A number for each of eight rays.
using Eight = std::array<double, 8>;
/// Coordinates for each of eight rays.
using EightPlaces = std::array<Eight, 3>;

/// A ball in motion, and one of the parallel rays, as seen from the tool.
struct BallOnRays {
    /// \param start mm, of a ray. \param direction unit, of all rays.
    /// \param ball_radius mm.
    BallOnRays(const Vec3& start, const Vec3& direction, const ToolMotion& motion,
               double ball_radius);

    double radius;               ///< mm
    double turn;                 ///< rad, of the motion
    Vec3 from;                   ///< start at u = 0
    Vec3 to;                     ///< start at u = 1
    Vec3 along_from;             ///< direction at u = 0
    Vec3 along_to;               ///< direction at u = 1
    Eigen::Matrix3d frame_from;  ///< turns vectors of the part to u = 0
    Eigen::Matrix3d frame_to;    ///< the same to u = 1
};

/// Starts of eight parallel rays, as seen from the tool at both ends of the motion.
struct EightRays {
    alignas(64) EightPlaces from;  ///< mm, at u = 0
    alignas(64) EightPlaces to;    ///< mm, at u = 1
};

/// Stretches of eight rays, mm. One with from > to is empty.
struct EightStretches {
    alignas(64) Eight from;
    alignas(64) Eight to;
};

/// Returns the rays that are moved by these vectors, in mm.
EightRays moved_rays(const BallOnRays& ball, const EightPlaces& movements);

/// Returns for each ray a stretch outside which every place is farther than `within` mm from
/// the ball at the middle of both ends of the motion, as `CuttingBody::near_stretch`.
EightStretches near_stretches(const BallOnRays& ball, const EightRays& rays,
                              double within);

/// What is removed on eight rays.
struct EightChords {
    EightStretches may;   ///< outside nothing is removed
    EightStretches sure;  ///< removed for certain, if `is_whole`
    /// 1 where a pose proves that all of `sure` is removed; 0 where it is in doubt.
    alignas(64) Eight is_whole;
};

/// Returns what is removed on stretches of rays.
/// \param error mm, upper bound of the error of straight motions on the stretches.
/// \param accuracy mm, of the distance at which a search ends.
EightChords ball_chords(const BallOnRays& ball, const EightRays& rays,
                        const EightStretches& search, double error, double accuracy);

}  // namespace endmill
