// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <span>

#include "endmill/cutter/cutter.h"
#include "endmill/path/tool_path.h"
#include "endmill/surface/surface.h"

/// \file
/// Measures the deviation of the straight moves of an iso-parametric path from the lines
/// of the surface that they replace. The chord error compares contacts with the line, as
/// the paper does; the motion error compares the swept ball with the line.

namespace endmill {

/// Greatest distance between the line of a pass and the chords between its contacts.
struct ChordError {
    double greatest_mm;  ///< greatest distance from a point of the line to its chord
    double pitch_mm;     ///< greatest distance between neighbouring samples
    SurfacePoint at;     ///< parameters of the place of `greatest_mm`
    int patch = 0;       ///< number of its surface in a part of several, from 0
};

/// Measures the chord error of the cuts of `path`.
///
/// Each cut is sampled at 64 to 4096 places, on average at most 0.25 mm apart. Golden
/// section search refines the worst sample. A cut is skipped if the bound on the line's
/// second derivative proves that its error is below one that was already found. The true
/// maximum can exceed the result only by the curvature of the line between two samples,
/// except next to the worst sample.
/// \param surface the surface of the path.
/// \param path    from plan_iso_parametric; the contacts of a pass share one parameter.
/// \param along   the parameter that varies along a pass.
/// \pre every point of a cut has a contact.
ChordError chord_error(const Surface& surface, const ToolPath& path, Parameter along);

/// The same for a path over several surfaces.
/// \param surfaces the part.
/// \param path     a path whose patch numbers are indices of `surfaces`.
/// \param along    the parameter that varies along a pass.
ChordError chord_error(std::span<const Surface> surfaces, const ToolPath& path,
                       Parameter along);

/// Greatest deviation of the line of a pass from the surface that the ball sweeps, to one
/// side of this surface.
struct LineDeviation {
    double greatest_mm = 0;  ///< 0 if the line nowhere lies on this side
    SurfacePoint at{};       ///< parameters of the place of `greatest_mm`
    int patch = 0;           ///< number of its surface in a part of several, from 0
};

/// Deviation of the straight moves of a ball from the lines of their passes.
struct MotionError {
    LineDeviation gouge;      ///< the line lies inside the swept volume
    LineDeviation remaining;  ///< the line lies outside: stock remains
    double bound_mm;  ///< the true deviations exceed `greatest_mm` by at most this

    /// The greater of the two deviations, in mm.
    double greatest_mm() const;
};

/// Measures the motion error of the cuts of `path`. The deviation at a point of the line
/// is its distance from the boundary of the capsule that the ball sweeps on the straight
/// move beside it.
///
/// The result bounds the deviation at all points of the line; it is not a sample.
/// Intervals of the line are halved until a bound on the second derivative excludes a
/// greater deviation. The accuracy is 1e-6 of the radius.
/// \param surfaces the part.
/// \param path     the contacts of a pass share one parameter; the patch numbers are
///                 indices of `surfaces`.
/// \param cutter   the ball.
/// \param along    the parameter that varies along a pass.
/// \pre every point of a cut has a contact.
/// Source: [KimChoi, section 4.1] bounds the chord between contacts only. On a convex
/// line of radius rho the gouge is deeper than the chord error by the factor 1 + R / rho.
MotionError motion_error(std::span<const Surface> surfaces, const ToolPath& path,
                         const BallCutter& cutter, Parameter along);

/// The greatest errors of a path, or limits of them, in mm.
struct PathErrors {
    double chord;    ///< distance of the lines of the passes from their chords
    double gouge;    ///< depth of a gouge anywhere on the part
    double scallop;  ///< thickness of remaining stock anywhere on the part
};

/// Combines the errors along the passes with those that were measured on the whole part.
/// The gouge is the deeper one of both, because rays can miss a gouge on a pass.
/// \param chord       from chord_error.
/// \param motion      from motion_error.
/// \param gouge_mm    depth of the deepest measured gouge.
/// \param scallop_mm  greatest measured thickness of remaining stock.
PathErrors path_errors(const ChordError& chord, const MotionError& motion,
                       double gouge_mm, double scallop_mm);

/// A limit of PathErrors.
enum class PathLimit {
    Chord,    ///< of the chord error
    Gouge,    ///< of the depth of a gouge
    Scallop,  ///< of the remaining material
};

/// The limits that a path misses. An error equal to its limit keeps it. Room for rounding
/// belongs to the limits.
/// \param errors of the path.
/// \param limits of the errors.
std::set<PathLimit> missed_limits(const PathErrors& errors, const PathErrors& limits);

}  // namespace endmill
