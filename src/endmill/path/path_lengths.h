// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/path/tool_path.h"

namespace endmill {

/// How far the tip of a cutter goes, in mm.
struct PathLengths {
    double at_feed_mm = 0;  ///< cuts and links
    double lifted_mm = 0;   ///< rapids, retracts and plunges
};

/// The lengths of the straight moves of `path`; nothing leads to its first point.
PathLengths path_lengths(const ToolPath& path);

}  // namespace endmill
