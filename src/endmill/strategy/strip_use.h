// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/path/tool_path.h"
#include "endmill/surface/part.h"

/// \file
/// How much of their strips the cuts of a path use, for pictures.

namespace endmill {

/// The area that cuts newly cover per length of contact, divided by the width of the strip
/// on a plane, 2 sqrt(h (2R - h)). It is 1 for a pass over a plane that nothing has covered
/// before, and 0 where others have covered everything. On concave parts and at the
/// beginnings of passes it may exceed 1.
///
/// Each run of cuts is divided into stretches of two strip widths; all moves of a stretch
/// have its value. Areas are those of about 200 000 sampled places, so that a value has an
/// error of some per cent, up to 0.1 where passes run along rows of places. A place is covered by the first move, cut or link, that comes
/// within R of it, raised by h along the normal; the flank above the ball counts.
/// \param part           the part; facets of a mesh that face down do not count.
/// \param path           with the axis +z; contacts are used where they are known, else
///                       tips.
/// \param cutter         the ball.
/// \param scallop_height h in mm.
/// \return the value for the move to each point of the path; 0 for moves that are no cuts.
/// \throws DomainError unless 0 < h < R.
/// \throws GeometryError where the part has no normal or faces away from the tool.
std::vector<double> strip_use(const Part& part, const ToolPath& path,
                              const BallCutter& cutter, double scallop_height);

}  // namespace endmill
