// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/process/detail/cut_moves.h"

namespace endmill {

/// Intersection of an earlier move with the plane across a later one.
struct PassCrossing {
    std::size_t move;  ///< index of the earlier move
    double share;      ///< position on the earlier move, 0 at its start, 1 at its end
    Vec3 offset;       ///< mm, from the crossing to the middle of the later move
    double distance;   ///< mm, length of `offset`
};

/// The nearest crossing on each side of a move, seen along the move from above.
struct NeighbouringPasses {
    std::optional<PassCrossing> left;   ///< to the left of the move
    std::optional<PassCrossing> right;  ///< to the right of the move
};

/// Finds for every move the earlier passes beside it.
///
/// The index is a tree of bounding boxes over runs of consecutive moves. Each node has eight
/// children, whose boxes are tested at once. A run is a short piece of a pass, so its box is
/// narrow. The boxes are aligned with the mean
/// direction of the moves, which keeps them narrow for rasters at any angle. The runs are
/// sorted by strips across that direction, and by the order of cutting within a strip: the
/// plane across a move meets few strips, in which neighbouring passes follow one another.
/// Source: docs/methods/ball-end-milling.md, section 12, `passes`.
class PassIndex {
public:
    /// \param moves in the order of cutting; must outlive the index.
    explicit PassIndex(std::span<const CutMove> moves);

    /// The nearest crossings of earlier moves with the plane through the middle of a
    /// move, across its direction. A crossing counts if
    /// - it is nearer than `reach` (mm),
    /// - its move runs within 45 degrees of this move or of its reverse,
    /// - it is not part of the same pass within `reach` of path length, and
    /// - it does not lie straight above or below, where the pick feed would have no
    ///   direction.
    ///
    /// A crossing at the middle itself counts as left. Of several equally near crossings
    /// the one cut last is returned. Takes about log(n) steps in a raster.
    ///
    /// \param nearby crossings of a move nearby, such as the one before. They shorten the
    ///        search and have no effect on the result.
    NeighbouringPasses beside(std::size_t move, double reach,
                              const NeighbouringPasses& nearby = {}) const;

private:
    struct Box {
        Vec3 centre;  // mm, in the rotated frame
        Vec3 half;    // mm, half the extents
    };
    struct Node {
        Box box;
        std::uint32_t first;  // lowest number of its moves
    };
    struct Leaf {
        std::uint32_t first;  // its moves are [first, end)
        std::uint32_t end;
    };
    struct Bound;
    struct Query;
    struct Search;
    static constexpr std::size_t lanes = 8;
    // Up to eight nodes. Unused lanes have moves that are later than all others.
    struct Group {
        std::array<std::array<double, lanes>, 3> centre;  // x, y and z of the boxes
        std::array<std::array<double, lanes>, 3> half;    // likewise
        std::array<std::uint32_t, lanes> first;
    };

    Box box_of(const Leaf& leaf) const;
    std::vector<Node> build_leaves();
    static std::vector<Group> groups_of(std::span<const Node> nodes);
    static std::vector<Node> nodes_around(std::span<const Node> nodes);
    static unsigned lanes_near(const Query& query, const Group& group);
    void look_into(Search& search, const Leaf& leaf) const;
    void descend(Search& search, std::size_t level, std::size_t group) const;

    std::span<const CutMove> moves_;
    Eigen::Matrix3d turn_;      // rotation about z into the frame of the boxes
    std::vector<Leaf> leaves_;  // runs of moves, sorted by strips
    std::vector<std::vector<Group>> levels_;  // of the leaves, of groups of them, ...
};

}  // namespace endmill
