// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <span>
#include <vector>

#include "endmill/strategy/detail/covered_part.h"
#include "endmill/strategy/detail/front_march.h"

namespace endmill {

/// How far a straight move may stray from the rolling ball of its pass.
struct MoveLimits {
    /// Height in mm below which the ball of a pass covers the surface beside it.
    double covered_height;
    /// By how much in mm a move may miss what the ball of its pass covers; > 0.
    double cover_slack;
};

/// A piece of a stretch of a pass.
struct StretchPiece {
    std::vector<PassContact> contacts;
    bool has_first;  ///< whether it begins where the stretch begins
    bool has_last;   ///< whether it ends where the stretch ends
};

/// Divides one pass into straight moves, and again after it has been changed. The pass is
/// divided at its required contacts into stretches. A change is a further required contact,
/// so that only the stretches beside it are divided again.
class PassDivision {
public:
    /// \param samples of the part on which the pass was laid; they must outlive this object,
    ///        and the part too.
    PassDivision(const PartSamples& samples, const CoveredPart& part,
                 const MoveLimits& limits)
        : samples_{&samples},
          part_{&part},
          limits_{limits}
    {
    }

    /// The pieces of the pass; see divided_into_moves.
    /// \param pass the pass of the earlier calls with further contacts, all of them required,
    ///        or with more required contacts.
    /// \param state of this thread.
    std::vector<LaidPass> pieces_of(const LaidPass& pass, MoveTestState& state);

private:
    // The number of contacts of a stretch, and points and normals of its first and its last
    // place. They distinguish the stretches of a pass.
    using StretchKey = std::array<double, 13>;

    const std::vector<StretchPiece>& pieces_of(std::span<const PassContact> stretch,
                                               MoveTestState& state);

    const PartSamples* samples_;
    const CoveredPart* part_;
    MoveLimits limits_;
    std::map<StretchKey, std::vector<StretchPiece>> known_;
};

/// Divides `pass` into as few straight moves as the limits allow. Each move is clear of
/// the part, and reaches the points that the rolling ball reaches at `covered_height`:
/// the one above each contact and those on both sides of it. Moves begin and end at required
/// contacts.
/// \return the pieces of the pass; the pass is interrupted where no move is clear.
/// \param samples of the part on which the pass was laid.
std::vector<LaidPass> divided_into_moves(const LaidPass& pass, const PartSamples& samples,
                                         const CoveredPart& part,
                                         const MoveLimits& limits);

}  // namespace endmill
