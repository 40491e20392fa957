// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "endmill/strategy/detail/covering_path.h"
#include "endmill/strategy/detail/section_march.h"

namespace endmill {

/// The directions of the parameter lines through the middle of each surface, from 0 to below
/// 180 degrees; none for a mesh.
std::vector<Angle> parameter_directions(const Part& part);

/// Directions of passes in parallel upright planes, and what to expect of them.
struct PlanarDirections {
    std::vector<Angle> best;                  ///< the best one first, or the given one
    std::vector<ComparedDirection> compared;  ///< by rising angle; none if it was given
    /// Length of the passes by `options.distance`, mm, found on few samples; nothing if the
    /// direction was given.
    std::optional<double> travel;
};

/// Searches for the directions with the shortest passes by `options.distance`. The passes are
/// laid on a coarse net.
/// Source: docs/methods/planar-passes.md, section 2.
class DirectionSearch {
public:
    /// Tries directions in steps of 15 degrees and the further ones.
    /// \param part, cutter as below; the part must outlive this object.
    /// \param options as below, without a direction.
    /// \param further directions to compare beside those of the search.
    /// \throws LimitError if the search, or the passes of planar_passes, need too many samples.
    DirectionSearch(const CoveredPart& part, const BallCutter& cutter,
                    const StrategyOptions& options, std::span<const Angle> further);

    /// Length of the passes in the best of these directions, mm.
    double coarse_travel() const;

    /// Searches on in steps of 5 degrees, and then between them.
    /// \param progress if set, it is called with the finished share, 0 to 1.
    PlanarDirections directions(const std::function<void(double share)>& progress);

private:
    // What passes in a direction cost.
    struct Tried {
        double angle;  // rad, from 0 to below pi
        double travel;
        PassLengths lengths;
        std::size_t passes;
    };

    Tried tried(double angle) const;
    std::vector<Tried> tried(std::span<const double> angles,
                             const std::function<void(double share)>& progress) const;
    std::vector<std::size_t> best_valleys() const;
    std::vector<Tried> golden_section(const Tried& middle) const;
    std::vector<Tried> all() const;

    BallCutter cutter_;
    TravelKind distance_;
    double asked_height_;  // scallop height of the path, mm
    double height_;        // of the search, mm
    PartSamples samples_;
    std::vector<std::optional<Tried>> equal_;  // in equal steps; at first not all of them
    std::vector<Tried> further_;               // between them
};

/// The given direction; without one, the result of a DirectionSearch.
/// \param part, cutter, options as below.
/// \param further directions to compare beside those of the search.
PlanarDirections planar_directions(const CoveredPart& part, const BallCutter& cutter,
                                   const StrategyOptions& options,
                                   std::span<const Angle> further);

/// Passes in parallel upright planes.
struct PlanarPasses {
    LaidPasses laid;
    Angle direction;  ///< of the passes, from +x towards +y
};

/// Lays passes in parallel upright planes in the directions on the fine net. Returns the
/// shortest.
/// Source: docs/methods/planar-passes.md.
/// \param part       on whose samples passes are laid.
/// \param cutter     the ball.
/// \param options    height, direction, limits and progress.
/// \param directions to compare, at least one.
/// \throws LimitError if the part needs too many samples.
PlanarPasses planar_passes(const CoveredPart& part, const BallCutter& cutter,
                           const StrategyOptions& options,
                           std::span<const Angle> directions);

}  // namespace endmill
