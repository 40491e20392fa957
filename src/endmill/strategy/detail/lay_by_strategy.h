// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "endmill/strategy/detail/covered_part.h"
#include "endmill/strategy/detail/iso_scallop.h"
#include "endmill/strategy/detail/planar.h"
#include "endmill/strategy/strategy_options.h"

/// \file
/// Every strategy behind one call. A path is laid here; it is judged elsewhere.

namespace endmill {

/// Share of the work until a path is laid; the rest is its judgement.
inline constexpr double made_share = 0.9;

/// The options, with a progress that reports the share of a part of some work as a share of
/// the whole.
StrategyOptions with_progress(const StrategyOptions& options, double from, double to);

/// Whether the passes run along parameter lines; then the strategy needs no samples.
bool follows_parameters(Strategy strategy);

/// \throws GeometryError unless the tool axis is +z.
void require_upright(const StrategyOptions& options);

/// The part for strategies that plan on its samples.
/// \throws GeometryError unless the tool axis is +z, or as CoveredPart.
CoveredPart covered_part(const Part& part, const BallCutter& cutter,
                         const StrategyOptions& options);

/// What a strategy finds out by trials on few samples before it lays passes.
struct Trials {
    std::optional<PlanarDirections> directions = {};  ///< of Strategy::Planar
    std::optional<ScallopStarts> starts = {};         ///< of Strategy::IsoScallop
    std::optional<double> travel = {};                ///< of the cuts, mm; an estimate
};

/// The trials that Strategy::Planar and IsoScallop cannot do without.
/// \param covered of `part`.
Trials trials_of(Strategy strategy, const Part& part, const CoveredPart& covered,
                 const StrategyOptions& options);

/// The path of Strategy::Planar or IsoScallop after its trials, or of Strategy::Field
/// without any.
/// \throws as plan_by_strategy.
CoveringPath covering_after(const Trials& trials, const CoveredPart& covered,
                            const StrategyOptions& options);

/// The path of any strategy, with its trials.
/// \throws as plan_by_strategy.
CoveringPath covering_by(Strategy strategy, const Part& part, const BallCutter& cutter,
                         const StrategyOptions& options);

}  // namespace endmill
