// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/cutter/cutter.h"

namespace endmill {

/// The point of the cutter whose travel a bound limits.
enum class BoundedLength {
    Contact,  ///< the point that touches the surface
    Tip,      ///< the tip, which moves as the centre of the ball does
};

/// The shape of the tool that takes material.
enum class CoveringTool {
    BallAndFlank,  ///< the ball and the half-infinite cylinder above it, along +z
    Ball,          ///< the ball alone, for any orientation of the part
};

/// Which paths a lower bound of the length holds for.
struct BoundProblem {
    BallCutter cutter;  ///< R
    /// h in mm: material that may be left along the normal, all causes together.
    double scallop_height;
    /// gamma in mm: how far a centre of the ball may be from its place above the contact,
    /// by gouge, lift or error of motion.
    double stray = 0;
    /// The length that is bounded.
    BoundedLength length = BoundedLength::Contact;
    /// What takes material. A path that a simulation with an upright tool judges needs
    /// BallAndFlank: on steep walls the flank covers more than the ball.
    CoveringTool tool = CoveringTool::BallAndFlank;
    /// m: the most pieces of a path, each in contact throughout.
    int most_pieces = 1;
};

/// Checks a problem.
/// \throws DomainError unless 0 < h < R, 0 <= gamma <= R and m >= 1.
void require_valid(const BoundProblem& problem);

/// The radius in mm of the disc that the ball covers on a plane,
/// sqrt((R + gamma)^2 - (R - h)^2).
/// Source: docs/methods/path-length-bound.md, section 2.
double plane_half_width(const BoundProblem& problem);

}  // namespace endmill
