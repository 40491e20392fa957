// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/path/tool_path.h"
#include "endmill/planning/economy.h"
#include "endmill/planning/linking.h"
#include "endmill/planning/verified_plan.h"
#include "endmill/strategy/protected_part.h"

/// \file
/// The strategies, their options, and what each returns.

namespace endmill {

/// How passes are laid.
enum class Strategy {
    IsoU,        ///< along parameter lines, u varying
    IsoV,        ///< along parameter lines, v varying
    Planar,      ///< in parallel upright planes
    IsoScallop,  ///< each as far from the passes before it as the scallop height allows
    Field,       ///< across the widest strips, along the level lines of a guide field
};

/// All of them, in the order in which they are tried.
inline constexpr std::array every_strategy{Strategy::IsoU, Strategy::IsoV,
                                           Strategy::Planar, Strategy::IsoScallop,
                                           Strategy::Field};

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
    /// Another part that no move may enter, for the same ball and inner tolerance; empty:
    /// none. Places that the ball cannot come near because of it need not be covered.
    std::shared_ptr<const ProtectedPart> protected_part = {};
    std::size_t most_points = 40'000'000;   ///< a longer path throws LimitError
    std::size_t most_samples = 20'000'000;  ///< a part that needs more throws LimitError
    /// If set, it is called with the finished share, 0 to 1; by several threads, also at once,
    /// and a share may be less than the one before.
    std::function<void(double share)> progress = {};
};

/// What passes of Strategy::Planar in a direction would cost, found on a coarse net.
struct ComparedDirection {
    Angle direction;  ///< from +x towards +y, from 0 to below 180 degrees
    /// Length of the passes by contacts; unknown for a cutter other than a ball.
    std::optional<double> cut_contact_mm;
    double cut_tip_mm;   ///< length of the passes by tips
    std::size_t passes;  ///< number of passes
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
    std::size_t arched_links = 0;  ///< links that are arched at feed for that reason
    /// Area in mm^2 of the parts of the sampled surface in which a place was found that
    /// keeps more than the scallop height.
    double uncovered_mm2 = 0;
    std::vector<UncoveredPlace> uncovered = {};  ///< these places, the worst of each part
    std::optional<Angle> direction = {};         ///< of the passes of Strategy::Planar
    /// The directions that were compared, by rising angle; none if it was given.
    std::vector<ComparedDirection> compared = {};
    /// Area in mm^2 of the places that the ball cannot come near to: parts of a mesh that face
    /// the tool, and what a protected part bars. They need not be covered.
    double unreached_mm2 = 0;
};

/// A strategy that was tried, and its result.
struct TriedStrategy {
    Strategy strategy;                ///< that was tried
    std::optional<double> travel_mm;  ///< of its cuts; nothing if it made no path
    /// Length of its cuts by trials; set if it was not planned for that reason.
    std::optional<double> estimated_mm;
    std::string refusal;  ///< why it can make no path; else empty
};

}  // namespace endmill
