// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include "endmill/core/answer.h"
#include "endmill/cutter/cutter.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// Declared in detail/piece_tree.h, for the planners of the library.
class FinerPieces;
class PieceTree;

/// A straight move of a ball, given by the centre of the ball in mm.
struct BallMove {
    Vec3 from;  ///< start
    Vec3 to;    ///< end
};

/// A point of the part inside the volume that a ball sweeps, or within the accuracy of
/// the test of it.
struct GougePlace {
    std::size_t surface;  ///< number of its surface
    /// Parameters on the surface.
    SurfacePoint at;
    Vec3 point;       ///< mm
    double depth_mm;  ///< R minus the point's distance from the swept axis, mm
};

/// The answer of a gouge test, and the point that decided it.
struct GougeAnswer {
    Answer gouges;                    ///< whether a point is deeper than the tolerance
    std::optional<GougePlace> place;  ///< empty if the answer is No
};

/// Measures how deep a ball and the shank of the same radius above it enter a part during
/// straight moves. The depth is R minus the distance of the part's nearest point from the
/// swept axis (detail/swept_axis.h). At tangential contact this equals the depth along
/// the part's normal. The convex hulls of control points give bounds. The answers are
/// therefore certain, except for rounding errors of about 1e-12 of the coordinates. An
/// immutable value that all threads may use.
class GougeTest {
public:
    /// \param surfaces the part.
    /// \param cutter the ball.
    /// \param axis from the tip to the spindle, unit.
    /// \throws DomainError unless there is a surface.
    GougeTest(std::span<const Surface> surfaces, const BallCutter& cutter,
              const Vec3& axis);

    /// Whether `move` enters the part by more than `tolerance` anywhere. The answer may
    /// be Undecided if |depth - tolerance| < 1e-3 tolerance. Takes about 5 us for a move
    /// of about the length R and a tolerance of about R / 10; longer moves and smaller
    /// tolerances take longer.
    /// \param move the move.
    /// \param tolerance in mm, 0 < tolerance < R.
    /// \throws DomainError unless the tolerance is in its range.
    GougeAnswer test(const BallMove& move, double tolerance) const;

    /// The same, faster for many moves in one neighbourhood.
    /// \param move the move.
    /// \param tolerance in mm, 0 < tolerance < R.
    /// \param finer keeps pieces for the next call; see detail/piece_tree.h.
    GougeAnswer test(const BallMove& move, double tolerance, FinerPieces& finer) const;

    /// The deepest point of `move`.
    /// \param move the move.
    /// \param resolution in mm, the accuracy of the depth.
    /// \return nothing if no point of the part is inside.
    /// \throws DomainError unless 0 < resolution.
    std::optional<GougePlace> deepest(const BallMove& move, double resolution) const;

    /// The ball.
    const BallCutter& cutter() const { return cutter_; }
    const Vec3& axis() const { return axis_; }  ///< unit, from the tip to the spindle

private:
    BallCutter cutter_;
    Vec3 axis_;
    std::shared_ptr<const PieceTree> tree_;
};

}  // namespace endmill
