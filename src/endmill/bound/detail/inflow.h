// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "endmill/bound/detail/cover_boundary.h"
#include "endmill/bound/detail/density_grid.h"

namespace endmill {

/// A piece of the boundary of D(x) as the search for a density stores it.
struct StoredFlow {
    GridPlace place;  ///< where the density is taken
    float x;          ///< component of the flow along e1, mm
    float y;          ///< component along e2, mm
};

/// The pieces in the order of the angles of their flows.
std::vector<StoredFlow> stored_flows(std::span<const BoundaryFlow> boundary,
                                     const DensityGrid& grid);

/// The greatest inflow over all directions t of travel: the maximum of
/// sum g max(0, flow . t). It is the length of the longest sum of flows within half a
/// turn, which n sums give exactly.
/// \param flows from `stored_flows`.
/// \param grid of the density.
/// \param density g at the nodes, 1/mm.
/// \return at most 1 if the density keeps the condition of the bound here.
double greatest_inflow(std::span<const StoredFlow> flows, const DensityGrid& grid,
                       std::span<const double> density);

}  // namespace endmill
