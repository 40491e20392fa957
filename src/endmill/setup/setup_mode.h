// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string_view>

#include "endmill/machine/rotary_limits.h"

namespace endmill {

/// Which algorithm of the paper finds a setup, the weakest first.
enum class SetupMode {
    PaperLiteral,  ///< as printed
    Paper,         ///< the print, its misprints corrected
    Corrected      ///< exact for the given directions and tool axis
};

/// What a mode does. A mode is one enumerator and one line of these.
struct SetupRules {
    SetupMode mode;
    std::string_view name;          ///< as a person writes it
    bool has_wide_sectors;          ///< C,A: C may turn by 180 degrees or more
    bool takes_hull_vertices_only;  ///< A,B: beta is taken over the hull's vertices
    bool has_both_hulls;            ///< A,B: parallels through two directions count, too
    bool takes_low_directions;      ///< A,B: directions 90 degrees off the tool axis
    bool has_signed_limits;         ///< A,B: a rigid part cannot be mirrored
};

/// The line of `mode`.
const SetupRules& setup_rules(SetupMode mode);

/// The mode of that name, if it is one.
std::optional<SetupMode> setup_mode(std::string_view name);

/// What is asked of a setup.
struct SetupOptions {
    RotaryFamily family = RotaryFamily::CA;
    SetupMode mode = SetupMode::Paper;
    RotaryLimits limits{};

    /// A,B: the first rotary axis is B, so that r2 = r1 x C; else r2 = C x r1.
    bool is_b_first = false;

    /// Called after each of the two looks at a pose, the quick and the exact one, with the
    /// number of those done, by one thread at a time, whichever. What it throws ends the work.
    std::function<void(std::size_t done)> progress = {};
};

/// Areas, in rad^2, above which a fit is of no interest.
struct AreaBounds {
    double least = std::numeric_limits<double>::infinity();  ///< of those of any range
    double feasible =
        std::numeric_limits<double>::infinity();  ///< of those within limits
};

/// \throws DomainError unless each range of `limits` holds 0 and is at most 2 pi wide.
void check_setup_options(const SetupOptions& options);

}  // namespace endmill
