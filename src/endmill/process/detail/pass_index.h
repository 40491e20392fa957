// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/process/detail/cut_moves.h"

namespace endmill {

/// Where an earlier move goes through the plane across a later one.
struct PassCrossing {
    std::size_t move;  ///< the earlier one, in the span
    double share;      ///< of its length, 0 to 1
    Vec3 offset;       ///< mm, from the crossing to the later move's middle
    double distance;   ///< mm, length of `offset`
};

/// The nearest crossing on either side of a move, as seen along it from above.
struct NeighbouringPasses {
    std::optional<PassCrossing> left;
    std::optional<PassCrossing> right;
};

/// Finds, for every move, the passes cut before it that lie beside it. Keeps a tree of
/// boxes over runs of moves in the order in which they are cut: a run is a short piece of
/// a pass, so that its box is narrow, and what is cut later is left out by its number.
/// Boxes stand along the mean direction of the moves, for which those of a slanted raster
/// are narrow too.
/// Source: spec of ball-end milling, section 12, `passes`.
class PassIndex {
public:
    /// \param moves in the order of cutting; they must outlive the index.
    explicit PassIndex(std::span<const CutMove> moves);

    /// The nearest crossings of moves before `move` with the plane through its middle
    /// across its direction. A crossing counts if it is nearer than `reach` (mm), if its
    /// move goes within 45 degrees along or against this one, if it is no part of the own
    /// pass within `reach` of path, and does not lie straight above or below: that is no
    /// pick feed. One that coincides with the middle counts as to the left. Of several
    /// equally near ones that which is cut last. About log(n) steps.
    NeighbouringPasses beside(std::size_t move, double reach) const;

private:
    struct Box {
        Vec3 centre;  // turned
        Vec3 half;
    };
    struct Search;

    void build_level();
    bool may_hold(const Search& search, const Box& box) const;
    void look_into(Search& search, std::size_t leaf) const;
    void descend(Search& search, std::size_t level, std::size_t node) const;

    std::span<const CutMove> moves_;
    Eigen::Matrix3d turn_;                  // about z
    std::vector<std::vector<Box>> levels_;  // of leaves, of pairs of them, ...
};

}  // namespace endmill
