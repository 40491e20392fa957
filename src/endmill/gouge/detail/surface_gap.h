// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "endmill/gouge/detail/cutter_core.h"
#include "endmill/gouge/detail/piece_tree.h"

namespace endmill {

/// A point of a surface with its signed distance from a cutter.
struct SurfaceGap {
    /// mm, negative inside the cutter.
    double gap;
    /// mm
    Vec3 point;
    std::size_t surface;  ///< number of the surface
    /// Parameters on the surface.
    SurfacePoint at;
};

/// The point of the surfaces with the smallest gap to the cutter.
/// \param tree the surfaces.
/// \param core the cutter.
/// \param resolution mm, accuracy of the gap.
/// \param enough mm; gaps from here on are of no interest.
/// \param finer of the same tree.
/// \return nothing if no gap is below `enough`.
std::optional<SurfaceGap> surface_gap(const PieceTree& tree, const CutterCore& core,
                                      double resolution, double enough,
                                      FinerPieces& finer);

/// Any point whose gap is below `limit`. Where the cutter is deep in the part, this is
/// faster than finding the smallest gap.
/// \param tree the surfaces.
/// \param core the cutter.
/// \param resolution mm.
/// \param limit mm.
/// \param finer of the same tree.
/// \return nothing if no gap is below `limit` by more than `resolution`.
std::optional<SurfaceGap> gap_below(const PieceTree& tree, const CutterCore& core,
                                    double resolution, double limit, FinerPieces& finer);

}  // namespace endmill
