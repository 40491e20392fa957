// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/io/shown_setup.h"

namespace endmill {

/// A part as it is set up on a machine, as a VTK XML PolyData file (.vtp), for ParaView and
/// VTK: lengths in mm, in the machine's directions with all rotary axes at zero.
///
/// Cells, by `object`: 0 the part's facets, in their order; 1 the tool axis, 2 R1 and 3 R2 as
/// lines through the middle of the part; 4 the border of the directions that the part asks for
/// and 5 that of the machine's, on a sphere around the part, a direction standing where a tool
/// along it leaves the sphere. A border that is one direction is a vertex. Facets have
/// `visible_fraction` (share of the sphere, 0 … 1) and `reached_at_zero` (1 or 0), other cells
/// 0 of both.
/// \throws DomainError if the mesh has no facet, `access` is not of its facets, or as
///         `motion_borders`.
std::string setup_vtp(const TriangleMesh& mesh, const FacetAccess& access,
                      const ShownSetup& setup);

}  // namespace endmill
