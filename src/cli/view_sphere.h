// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/view_frame.h"
#include "cli/view_input.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// The sphere of directions of a page, the facets that each direction reaches, and the
/// directions that the machine of the setup can take.
/// \param mesh the part; may be null.
/// \throws FormatError, LimitError as parse_visibility; DomainError unless the part has the facets
///         of the map; LimitError for more than 4e8 bits.
Json sphere_view(const ViewInput& input, const TriangleMesh* mesh,
                 const ReadLimits& limits, ViewFrame& frame);

}  // namespace endmill
