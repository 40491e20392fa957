// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/path/tool_path.h"

namespace endmill {

/// The tool path as a VTK XML PolyData file (.vtp), lengths in mm, for ParaView and VTK.
///
/// Points are the tips. A polyline for each run of moves of one kind in one pass, from
/// the point where the run begins; its cell data are `pass` and `move` (0 cut, 1 link,
/// 2 rapid, 3 plunge, 4 retract). Point data are `axis`, `has_contact` (1 or 0),
/// `contact`, `normal`, `u` and `v`; without a contact they repeat the tip and the
/// axis, and u and v are 0. Numbers are stored in binary, exactly.
/// \throws DomainError if a number is not finite.
std::string tool_path_vtp(const ToolPath& path);

}  // namespace endmill
