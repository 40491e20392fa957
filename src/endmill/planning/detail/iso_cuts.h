// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>

#include "endmill/path/tool_path.h"
#include "endmill/surface/detail/iso_line.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// A cutting move of an iso-parametric path. The surface is transposed if the passes run
/// along v, so that every pass here runs along u. The references are valid during the
/// visit only.
struct IsoCut {
    const Surface& surface;  ///< the surface, transposed for passes along v
    const IsoLine& line;     ///< the line of the pass
    double from;             ///< u at the start of the move
    double to;               ///< u at the end of the move
    const PathPoint& start;  ///< first point of the move
    const PathPoint& end;    ///< last point of the move
};

/// Calls `visit` for each cutting move of `path`, in order. Links, lifts and plunges are
/// skipped. The line of a pass is computed once for all its moves.
/// \param surfaces the part.
/// \param path     a path whose patch numbers are indices of `surfaces`.
/// \param along    the parameter that varies along a pass.
/// \param visit    called with each move.
/// \pre every point of a cut has a contact, and its patch is one of `surfaces`.
void for_each_iso_cut(std::span<const Surface> surfaces, const ToolPath& path,
                      Parameter along, const std::function<void(const IsoCut&)>& visit);

}  // namespace endmill
