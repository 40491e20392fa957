// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "endmill/drop_cutter/detail/patch_climb.h"
#include "endmill/gouge/gouge_test.h"

namespace endmill {

/// A place on a part: a surface by its number, and global parameters.
struct PartPlace {
    std::size_t surface;
    SurfacePoint at;
};

/// Where a cutter rests on a part that it is lowered onto, one of several such places.
struct PartContact {
    std::size_t surface;
    PatchContact on;
    /// Whether it touches with the surface's own normal, and not an edge or a corner.
    bool is_inside;
};

/// How deep in mm a part may enter the cutter where it is said to rest on it: far below
/// what is asked of its height, 1e-4 mm, also where it touches a slope of 80 degrees.
inline constexpr double rest_gouge = 2e-6;

/// The drop cutter on smooth surfaces: how high a cutter stands that comes down from above,
/// over all contacts with surfaces, borders, creases and corners, right to `rest_gouge` along
/// the part's normal. An immutable value, which all threads may ask.
/// Source: specification of the interference removal, section 6, R3.
class SmoothDrop {
public:
    /// \param surfaces outlive it, and their N_z > 0. \param cutter with the allowance.
    SmoothDrop(std::span<const Surface> surfaces, const Cutter& cutter);

    /// The contact uphill from `start`, over borders between patches of its surface; nothing
    /// if no point was found below the cutter.
    /// \param axis x and y of the cutter in mm.
    std::optional<PartContact> climb(const PartPlace& start,
                                     const Eigen::Vector2d& axis) const;

    /// The highest contact of all, if some contact of that axis is known.
    /// \param finer of this drop and this thread alone.
    PartContact highest(PartContact known, const Eigen::Vector2d& axis,
                        FinerPieces& finer) const;

private:
    std::span<const Surface> surfaces_;
    Cutter cutter_;
    PieceTree tree_;
};

}  // namespace endmill
