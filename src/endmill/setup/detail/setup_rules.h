// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/setup/setup_pose.h"

namespace endmill {

/// The rules of a mode: which poses it tries at a given tool axis, and how it compares
/// limits. A table has one row of these rules for each mode.
/// Source: docs/methods/five-axis-setup.md, the table of modes before section 1.
struct SetupRules {
    SetupMode mode;                 ///< the mode that these rules describe
    bool has_wide_sectors;          ///< C,A: the range of C may be 180 degrees or more
    bool takes_hull_vertices_only;  ///< A,B: beta is taken over the hull's vertices only
    bool has_both_hulls;            ///< A,B: edges of the orthographic hull are tried too
    /// A,B: directions may lie 90 degrees or more from the tool axis.
    bool takes_low_directions;
    bool has_signed_limits;  ///< A,B: limits are compared with their signs
};

/// The rules of a mode. `WholeCones` has the rules of `Corrected`.
const SetupRules& setup_rules(SetupMode mode);

}  // namespace endmill
