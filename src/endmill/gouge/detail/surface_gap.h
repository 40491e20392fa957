// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "endmill/gouge/detail/cutter_core.h"
#include "endmill/gouge/gouge_test.h"

namespace endmill {

/// A point of a surface and its signed distance from a cutter, mm.
struct SurfaceGap {
    double gap;
    Vec3 point;
    std::size_t surface = 0;  ///< number of its surface; of a mesh no more is known
    SurfacePoint at{};
};

/// The point of the surfaces nearest to the cutter, or deepest in it, its gap known to
/// `resolution` mm, if that is below `enough`.
/// \param finer of the same tree.
std::optional<SurfaceGap> surface_gap(const PieceTree& tree, const CutterCore& core,
                                      double resolution, double enough,
                                      FinerPieces& finer);

/// Any point whose gap is below `limit`; nothing if that of none is by more than
/// `resolution` mm: quicker to tell than the least where the cutter is deep in the part.
std::optional<SurfaceGap> gap_below(const PieceTree& tree, const CutterCore& core,
                                    double resolution, double limit, FinerPieces& finer);

}  // namespace endmill
