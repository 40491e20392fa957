// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>

#include "endmill/machine/axis_limits.h"

/// \file
/// The four modes of a setup search and the rules that three of them follow at a given
/// tool axis. Source: docs/mathematics/five-axis-setup.md, table of modes.

namespace endmill {

/// The algorithm that finds a setup, from the weakest to the strongest.
enum class SetupMode {
    PaperLiteral,  ///< nearest cells, as printed
    Paper,         ///< nearest cells, as printed without the misprints
    Corrected,     ///< nearest cells, exact for these cells and a given tool axis
    WholeCones     ///< all cells of each cone and all poses, with a certified lower bound
};

/// What a mode tries at a given tool axis and how it compares limits. Each mode is one
/// enumerator and one row of a table of these rules.
struct SetupRules {
    SetupMode mode;
    std::string_view name;          ///< the word of the command line: "paper", "set", ...
    bool has_wide_sectors;          ///< C,A: C may turn by 180 degrees or more
    bool takes_hull_vertices_only;  ///< A,B: beta is taken over the hull's vertices only
    bool has_both_hulls;            ///< A,B: edges of the orthographic hull are tried too
    bool takes_low_directions;  ///< A,B: directions may be 90 degrees off the tool axis
    bool has_signed_limits;     ///< A,B: limits are compared with their signs
};

/// The rules of a mode. Those of `WholeCones` are the ones of `Corrected`.
const SetupRules& setup_rules(SetupMode mode);

/// Finds a mode by its name: "paper-literal", "paper", "corrected" or "set".
/// \return nothing if no mode has this name.
std::optional<SetupMode> setup_mode(std::string_view name);

/// Options of the fits and searches whose tool axes are given: `pose_fit` and
/// `pose_search`.
struct PoseFitOptions {
    RotaryFamily family = RotaryFamily::CA;
    SetupMode mode = SetupMode::Paper;  ///< any but `WholeCones`
    RotaryLimits limits{};              ///< turns of the tool against the part

    /// A,B: the first rotary axis is B, so that r2 = r1 x C; otherwise r2 = C x r1.
    bool is_b_first = false;

    /// Called twice for each tool axis, after its quick bound and after its fit, with the
    /// number of calls so far. Any thread may call, one at a time. An exception ends the
    /// search.
    std::function<void(std::size_t done)> progress = {};
};

/// Checks the options of a fit or search.
/// \throws DomainError if the mode is `WholeCones`, or if a range of `limits` does not
///         contain 0 or is wider than 2 pi.
void check_pose_fit_options(const PoseFitOptions& options);

}  // namespace endmill
