// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/cutter/cutter.h"
#include "endmill/deviation/deviation.h"
#include "endmill/path/tool_path.h"
#include "endmill/planning/economy.h"
#include "endmill/planning/linking.h"
#include "endmill/planning/verified_plan.h"
#include "endmill/surface/part.h"

/// \file
/// Plans a path by a strategy, judges it by simulated removal, and compares strategies.
///
/// All strategies keep the same limits, chord errors included: nowhere on the part more
/// stock remains than the scallop height, and no gouge is deeper than the inner tolerance.

namespace endmill {

/// How passes are laid.
enum class Strategy {
    IsoU,        ///< along parameter lines, u varying
    IsoV,        ///< along parameter lines, v varying
    Planar,      ///< in parallel upright planes
    IsoScallop,  ///< each as far from the passes before it as the scallop height allows
};

/// The word for a strategy in files and on the command line, such as "iso-scallop".
std::string_view strategy_name(Strategy strategy);

/// Options of a strategy.
struct StrategyOptions {
    /// Largest height of remaining material in mm, along the normal, all causes together.
    double scallop_height = 0.01;
    double inner_tolerance = 0.01;  ///< greatest gouge depth, anywhere on the part, mm
    LinkOptions link = {};          ///< tool axis and safe height
    /// The length that a strategy keeps short, and by which strategies are compared.
    TravelKind distance = TravelKind::Contact;
    /// Direction of the passes of Strategy::Planar, from +x towards +y. Without one, the
    /// best direction is searched for.
    std::optional<Angle> direction = {};
    std::size_t most_points = 40'000'000;   ///< a longer path throws LimitError
    std::size_t most_samples = 20'000'000;  ///< a part that needs more throws LimitError
    /// If set, it is called with the finished share, 0 to 1.
    std::function<void(double share)> progress = {};
};

/// A path that covers a part, and the places that it is known to leave.
struct CoveringPath {
    ToolPath path;           ///< all pieces and the links between them
    std::size_t passes = 0;  ///< passes as laid, before they are divided
    /// How far a centre of the ball may be from its place above the contact, mm: by a gouge
    /// or by a lift.
    double stray_mm = 0;
    std::size_t pieces = 0;        ///< parts of passes that are cut in contact throughout
    std::size_t lifted_links = 0;  ///< links that are lifted because they are not clear
    /// Area in mm^2 of the parts of the sampled surface in which a place was found that
    /// keeps more than the scallop height.
    double uncovered_mm2 = 0;
    std::vector<UncoveredPlace> uncovered = {};  ///< these places, the worst of each part
    /// Area in mm^2 of the parts of a mesh that face the tool, but that the ball cannot come
    /// near to. They need not be covered.
    double unreached_mm2 = 0;
};

/// A path by a strategy, and how it was judged.
struct StrategyPlan {
    Strategy strategy;      ///< that laid the passes
    CoveringPath covering;  ///< the path
    PathEconomy economy;    ///< of the path
    Deviation deviation;    ///< of the stock that the path leaves
    Verdict verdict;        ///< on it

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
/// Source: docs/methods/iso-scallop.md.
/// \param strategy how passes are laid.
/// \param part     surfaces or a mesh.
/// \param cutter   the ball.
/// \param options  see there.
/// \throws DomainError if a tolerance, the height or the axis is out of range.
/// \throws GeometryError with the place if N . axis <= 0 or the surface has no normal, on a
///         mesh only if no facet faces the tool; if the ball fits nowhere; or if the strategy
///         does not suit the part.
/// \throws LimitError if the part needs too many samples or points.
StrategyPlan plan_by_strategy(Strategy strategy, const Part& part,
                              const BallCutter& cutter, const StrategyOptions& options);

/// A strategy that was tried, and its result.
struct TriedStrategy {
    Strategy strategy;
    std::optional<double> travel_mm;  ///< of its cuts; nothing if it made no path
    std::string refusal;              ///< why it made no path; else empty
};

/// The shortest path that is judged good, and the strategies that were compared.
struct BestPlan {
    StrategyPlan plan;
    std::vector<TriedStrategy> tried;  ///< in the order of Strategy
};

/// Plans by every strategy that suits the part and returns the plan with the shortest cuts
/// among those judged good. Paths are judged in the order of their lengths, up to the first
/// good one. If none is good, the shortest is returned.
/// \param part, cutter, options as above.
/// \throws as plan_by_strategy, if no strategy makes a path.
BestPlan plan_by_best_strategy(const Part& part, const BallCutter& cutter,
                               const StrategyOptions& options);

}  // namespace endmill
