// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/figures/axonometric_figure.h"
#include "endmill/path/tool_path.h"

namespace endmill {

/// A tool path in parallel projection, as an SVG file: contact points (tips where there
/// is no contact) joined in the order of the path. Links have another colour; rapids,
/// plunges and retracts are dashed.
/// Source: after [KimChoi, figs. 12 and 13].
/// \throws DomainError if the path has no points or one that is not finite.
std::string tool_path_svg(const ToolPath& path, const FigureOptions& options = {});

}  // namespace endmill
