// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "endmill/path/tool_path.h"

namespace endmill {

/// A way straight down: vertical plunges one below the other with one tool.
struct Descent {
    std::size_t first;  ///< index of the first point to which it leads
    std::size_t last;   ///< index of the point at which it ends
    double from;        ///< mm, height at which it begins
    double to;          ///< mm, height at which it ends, below `from`
};

/// The descent that begins with the move to point `first`. The move to the first point of
/// the path counts as a plunge unless it is a rapid, because the tool comes from above.
/// \param path the path.
/// \param first index of a point.
/// \param start_height mm, height at which the tool is over the first point of the path.
/// \return std::nullopt if that move is no plunge, or does not go straight down.
std::optional<Descent> descent_at(const ToolPath& path, std::size_t first,
                                  double start_height);

/// Whether a cut with the same tool follows `descent`. Otherwise it drills.
bool leads_to_cut(const ToolPath& path, const Descent& descent);

}  // namespace endmill
