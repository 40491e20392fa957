// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "endmill/gouge/detail/piece_tree.h"
#include "endmill/gouge/gouge_test.h"
#include "endmill/planning/detail/border_depth.h"
#include "endmill/planning/detail/contact_line.h"
#include "endmill/planning/detail/strip_cover.h"
#include "endmill/planning/planner_options.h"

namespace endmill {

/// Share of the inner tolerance to which moves may cut along the normals of the border.
/// The bounds of the verification are of first order there: a path planned to the full
/// tolerance would remain undecided.
/// Source: paper/notes/border-depth.md, section 4.
inline constexpr double border_share = 0.99;

/// Distance that contacts keep from both limits of a one-sided tolerance, as a share of
/// the other tolerance. A ball that lies exactly on a limit would leave the tests
/// undecided, which need about a thousandth.
inline constexpr double offset_margin = 0.02;

/// The heights in mm along the normal at which a planner may put contacts, the highest
/// one first. With two tolerances above 0 contacts lie on the surface. With a tolerance
/// of 0 they lie close to either limit of the allowed band: on a convex line at the outer
/// limit, so that the chord descends to the inner one, and on a concave line at the inner
/// limit. A step then uses the whole band as its sagitta.
/// Source: docs/methods/economic-cl-data.md, section 14.
std::vector<double> contact_offsets(const MotionTolerances& tolerances);

/// Tests whether straight moves of a ball keep an inner tolerance on a part: no point of
/// the part lies deeper than the tolerance in the volume that the ball and its shank
/// clear, and along the normals of the part's border they cut at most `border_share` of
/// it. The verdict of the module `verification` judges a cut in the same way. An
/// immutable value that all threads may use.
class ClearMoves {
public:
    /// \param surfaces  the part.
    /// \param sides     from tool_side_signs, one for each surface.
    /// \param cutter    the ball, radius R.
    /// \param axis      unit, from the tip to the spindle.
    /// \param tolerance in mm, 0 <= tolerance < R.
    /// \param widening  in mm, 0 <= widening; above 0 if the tolerance is 0. The tests
    ///                  use a ball that is larger by this, and a tolerance that is larger
    ///                  by as much, which bounds the same distance from the centres. The
    ///                  accuracy of the tests is a share of the tolerance that they see.
    /// \throws DomainError unless there is a surface and the tolerance is in its range.
    ClearMoves(std::span<const Surface> surfaces, std::span<const double> sides,
               const BallCutter& cutter, const Vec3& axis, double tolerance,
               double widening = 0)
        : cutter_{cutter},
          gouge_{surfaces, BallCutter{cutter.radius() + widening}, axis},
          border_{surfaces, sides, BallCutter{cutter.radius() + widening}, axis,
                  border_share * (tolerance + widening)},
          tolerance_{tolerance},
          tested_tolerance_{tolerance + widening}
    {
    }

    /// Whether `move` is proved to keep the tolerance. It is not proved where the answer
    /// depends on the depth to less than 2e-3 of the tolerance.
    /// \param move  the move.
    /// \param finer keeps pieces for the next call; see gouge/detail/piece_tree.h.
    bool is_clear(const BallMove& move, FinerPieces& finer) const
    {
        return gouge_.test(move, tested_tolerance_, finer).gouges == Answer::No &&
               border_.is_kept(move);
    }

    const BallCutter& cutter() const { return cutter_; }  ///< the ball
    double tolerance() const { return tolerance_; }       ///< mm

private:
    BallCutter cutter_;
    GougeTest gouge_;
    BorderDepth border_;
    double tolerance_;
    double tested_tolerance_;
};

/// A surface to plan on, and the tests of its moves. The references must outlive it.
struct VerifiedSurface {
    const MarchedSurface& marched;  ///< the surface
    const ClearMoves& clear;        ///< of the whole part, at `tolerances.inner`
    const StripCover& line_cover;   ///< at the height `tolerances.outer`
    MotionTolerances tolerances;    ///< limits of each move
    Parameter direction;            ///< for the parameters in an error message
    PatchBorders patch_borders;     ///< steps at borders of patches
    std::size_t most_points;        ///< a longer pass throws LimitError
    /// Heights of the contacts in mm, see contact_offsets; at least one.
    std::vector<double> offsets = {0};

    const BallCutter& cutter() const { return clear.cutter(); }  ///< the ball
};

/// A point beside a pass that the ball must reach from one of the moves of the pass.
struct CoverDemand {
    double foot_u;  ///< parameter on the pass of the move that must reach it
    Vec3 point;     ///< mm; must lie within R of the centres of that move
};

/// A pass, divided into the pieces that the ball can cut.
struct VerifiedPass {
    double v;                  ///< parameter of the pass
    std::vector<Pass> pieces;  ///< u rising; empty if the ball fits nowhere
};

/// Computes the pass along u at `v` with the longest steps, to a thousandth of each,
/// whose straight motions keep the tolerances and reach all demands. Each contact has the
/// offset that allows the longest step to it. The pass is interrupted where the ball does
/// not fit or a step would be shorter than 1e-4 of a patch, and continues where the ball
/// fits again.
/// \param surface the surface and its tests.
/// \param v       parameter of the pass.
/// \param demands in order of rising `foot_u`.
/// \param advance if not empty, is called now and then with the share of the pass that
///        was added since its last call; the shares add up to 1.
/// \throws GeometryError where the surface has no normal.
/// \throws LimitError if a pass has more than `most_points` points.
VerifiedPass verified_pass(const VerifiedSurface& surface, double v,
                           std::span<const CoverDemand> demands,
                           const std::function<void(double)>& advance = {});

/// The straight moves of all pieces of a pass.
SweptPass swept(const VerifiedPass& pass, const BallCutter& cutter);

/// Divides a step of a pass by a contact in the middle of its parameters.
/// \param pass    is changed only if the step is divided.
/// \param step    number of the step in `swept(pass)`.
/// \param surface the surface and its tests.
/// \return whether both halves keep the tolerances and the step is divided.
bool halve_step(VerifiedPass& pass, std::size_t step, const VerifiedSurface& surface);

}  // namespace endmill
