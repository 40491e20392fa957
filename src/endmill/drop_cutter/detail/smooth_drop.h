// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "endmill/drop_cutter/detail/patch_climb.h"
#include "endmill/gouge/detail/piece_tree.h"

namespace endmill {

/// A position on a part: the number of a surface, and global parameters.
struct PartPlace {
    std::size_t surface;  ///< number of the surface
    SurfacePoint at;      ///< global parameters
};

/// A contact of a cutter that was lowered onto a part. There may be several with equal
/// height.
struct PartContact {
    std::size_t surface;  ///< number of the surface
    /// The contact on the surface.
    PatchContact on;
    /// True if the cutter touches with the surface's own normal, false on an edge or in a
    /// corner.
    bool is_inside;
};

/// The drop cutter on smooth surfaces: the height of a cutter that is lowered onto them,
/// over contacts on surfaces, borders, creases and corners. Its error is at most
/// `rest_gouge` along the normal of the part. An immutable value that all threads may
/// use.
///
/// 1. From a known contact the cutter climbs to a local maximum of the height
///    (patch_climb.h), across the borders of patches.
/// 2. A point of the part deeper than rest_gouge in the cutter at that height is searched
///    for in a tree of Bezier pieces. If there is one, the climb starts again from it.
/// 3. If there is none, the contact is the highest.
/// Source: docs/methods/interference.md, section 6 (R3).
class SmoothDrop {
public:
    /// \param surfaces the part with N_z > 0 everywhere; they must outlive this object.
    /// \param cutter the cutter with its allowance.
    SmoothDrop(std::span<const Surface> surfaces, const Cutter& cutter);

    /// The contact reached by climbing from `start`, across the borders of the patches of
    /// its surface.
    /// \param start where the climb begins.
    /// \param axis x and y of the cutter in mm.
    /// \return nothing if no point below the cutter was found.
    std::optional<PartContact> climb(const PartPlace& start,
                                     const Eigen::Vector2d& axis) const;

    /// The highest contact of all.
    /// \param known some contact over `axis`.
    /// \param axis x and y of the cutter in mm.
    /// \param finer belongs to this object and to this thread alone.
    PartContact highest(PartContact known, const Eigen::Vector2d& axis,
                        FinerPieces& finer) const;

private:
    std::span<const Surface> surfaces_;
    Cutter cutter_;
    PieceTree tree_;
};

}  // namespace endmill
