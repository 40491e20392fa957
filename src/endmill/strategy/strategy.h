// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/deviation/deviation.h"
#include "endmill/planning/economy.h"
#include "endmill/strategy/strategy_options.h"
#include "endmill/surface/part.h"

/// \file
/// Plans a path by a strategy, judges it by simulated removal, and compares strategies.
///
/// All strategies keep the same limits, chord errors included: nowhere on the part more
/// stock remains than the scallop height, and no gouge is deeper than the inner tolerance.

namespace endmill {

/// A path by a strategy, and how it was judged.
struct StrategyPlan {
    Strategy strategy;      ///< that laid the passes
    CoveringPath covering;  ///< the path
    PathEconomy economy;    ///< of the path
    Deviation deviation;    ///< of the stock that the path leaves
    Verdict verdict;        ///< on it, and on the gouges of a protected part
    /// Gouges of the protected part; nothing without one.
    std::optional<Deviation> of_protected = {};

    /// Whether the path is judged clean, and no place is known to be uncovered.
    bool is_good() const
    {
        return verdict == Verdict::Clean && covering.uncovered.empty();
    }
};

/// The greatest number of samples of a part for which `memory_gib` suffices.
std::size_t most_part_samples(double memory_gib);

/// Plans a path by a strategy and judges it. Strategy::IsoU and IsoV plan by
/// plan_verified. The others lay passes on a sampled net of the part; passes branch, merge
/// and run around holes.
///
/// On a mesh the facets that face the tool are to be covered, up to places that the ball
/// cannot come within half the scallop height of; elsewhere it is only not to be gouged. The
/// judgement is that of verify_path with is_accessible as test of the cutter's position.
/// Contacts have x and y of their point in place of parameters u and v. A mesh must be
/// oriented consistently.
///
/// Places that a protected part keeps the ball from coming within half the scallop height of
/// need not be covered, and are not judged. No move enters the protected part.
///
/// A path that is judged to leave a little too much is laid again for a lower height.
/// Strategy::IsoU and IsoV do not avoid it: they plan only if their path is clear of it.
/// Source: docs/methods/iso-scallop.md.
/// \param strategy how passes are laid.
/// \param part     surfaces or a mesh.
/// \param cutter   the ball.
/// \param options  see there.
/// \throws DomainError if a tolerance, the height or the axis is out of range.
/// \throws GeometryError with the place if N . axis <= 0 or the surface has no normal, on a
///         mesh only if no facet faces the tool; if the ball fits nowhere; or if the strategy
///         does not suit the part; if a protected part bars all of it, or a path along
///         parameter lines or at the safe height enters it.
/// \throws LimitError if the part needs too many samples or points.
StrategyPlan plan_by_strategy(Strategy strategy, const Part& part,
                              const BallCutter& cutter, const StrategyOptions& options);

/// The same for any cutter. A cutter other than a ball is planned by Strategy::Planar only, by
/// dropping it on a mesh of the part. The contacts of such a path are not known: its lengths by
/// contacts are 0, and options.distance has no effect.
/// Source: docs/methods/planar-passes.md, section 3.
/// \throws GeometryError for another strategy with such a cutter.
StrategyPlan plan_by_strategy(Strategy strategy, const Part& part, const Cutter& cutter,
                              const StrategyOptions& options);

/// The path that a strategy plans for a ball, before it is judged: the same as
/// plan_by_strategy, without the simulated removal.
/// \param strategy, part, cutter, options as above.
/// \throws as plan_by_strategy.
CoveringPath covering_by_strategy(Strategy strategy, const Part& part,
                                  const BallCutter& cutter,
                                  const StrategyOptions& options);

/// The shortest path that is judged good, and the strategies that were compared.
struct BestPlan {
    StrategyPlan plan;                 ///< the path
    std::vector<TriedStrategy> tried;  ///< in the order of Strategy
};

/// Plans by the strategies that suit the part and returns the plan with the shortest cuts
/// among those judged good. Strategy::IsoU and IsoV are planned. The others are compared
/// by trials on few samples, and those that are estimated to be 8 per cent longer than the
/// shortest are not planned. The direction of Strategy::Planar is searched for only if its
/// length in few directions is within 15 per cent of the shortest.
///
/// A part is large if its area exceeds 4000 squares of a strip's width. Of the strategies other
/// than Strategy::IsoU and IsoV, only the one with the least estimate is then planned. IsoU and
/// IsoV are estimated by a plan for a greater height, and planned unless the estimate exceeds
/// the length of that path by more than 25 per cent. With more than 20 000 squares only IsoU
/// and IsoV are compared, unless the part is a mesh. These rules depend on the part alone, not
/// on the time that planning takes. On a large part a path along parameter lines could thus be
/// shorter than the one returned, if its estimate is more than 25 per cent too long.
///
/// Paths are judged in the order of their lengths, up to the first good one. If none is good,
/// one that does not gouge is returned, of these the one that leaves the least area uncut; if
/// all gouge, the one that gouges the least area.
/// \param part, cutter, options as above.
/// \throws as plan_by_strategy, if no strategy makes a path.
BestPlan plan_by_best_strategy(const Part& part, const BallCutter& cutter,
                               const StrategyOptions& options);

}  // namespace endmill
