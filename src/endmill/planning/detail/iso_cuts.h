// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>

#include "endmill/path/tool_path.h"
#include "endmill/surface/detail/iso_line.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// A cutting move of an iso-parametric path, on the surface turned so that its pass runs
/// along u. All references last as long as the visit.
struct IsoCut {
    const Surface& surface;  ///< turned
    const IsoLine& line;     ///< of the surface, at the v of the pass
    double from;             ///< u of the start
    double to;               ///< u of the end
    const PathPoint& start;
    const PathPoint& end;
};

/// Calls `visit` with each move of `path` that cuts, in order.
/// \param surfaces the patches that the points name, all with passes along `along`.
/// \pre every point has a contact, and its patch is one of `surfaces`.
void for_each_iso_cut(std::span<const Surface> surfaces, const ToolPath& path,
                      Parameter along, const std::function<void(const IsoCut&)>& visit);

}  // namespace endmill
