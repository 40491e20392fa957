// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/cutter/cutter.h"
#include "endmill/planning/detail/verified_pass.h"
#include "endmill/strategy/detail/part_samples.h"
#include "endmill/surface/part.h"

namespace endmill {

/// What tests of moves keep between calls to save time. It never changes an answer. Each
/// thread has its own.
struct MoveTestState {
    FinerPieces finer;  ///< pieces of surfaces
};

/// The part for which a strategy plans: it gives samples on which passes are laid, and
/// tests the moves of the ball. An immutable value that refers to the part; all threads may
/// use it.
class CoveredPart {
public:
    /// \param part      the part; it must outlive this object.
    /// \param cutter    the ball, held along +z.
    /// \param tolerance greatest depth in mm by which a clear move enters the part; above 0
    ///        and below the radius.
    /// \throws GeometryError with the place where N . z <= 0 or where there is no normal.
    CoveredPart(const Part& part, const BallCutter& cutter, double tolerance);

    /// Samples of the part.
    /// \param spacing      greatest distance of neighbours along the part, mm.
    /// \param most_samples a denser net throws LimitError.
    PartSamples samples(double spacing, std::size_t most_samples) const;

    /// Whether a straight move is proved to enter the part nowhere by more than the
    /// tolerance.
    /// \param from, to centres of the ball, mm.
    /// \param state    of this thread.
    bool is_clear(const Vec3& from, const Vec3& to, MoveTestState& state) const;

    const BallCutter& cutter() const { return clear_.cutter(); }  ///< the ball

private:
    const std::vector<Surface>* surfaces_;
    std::vector<double> sides_;
    ClearMoves clear_;
};

}  // namespace endmill
