// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "endmill/cutter/cutting_body.h"
#include "endmill/machine/tool_motion.h"

namespace endmill {

/// A piece of the motion of a cutter.
struct ToolPiece {
    ToolMotion motion;
    CuttingBody body;
    std::int32_t point;  ///< number of the path point to which its move leads
    std::int32_t order;  ///< place in the order of cutting
};

/// A ball.
struct Sphere {
    Vec3 centre;    ///< mm
    double radius;  ///< mm
};

/// The pieces of the motions of cutters, or of shank and holder, in a tree of bounding
/// volumes. A volume contains
/// the axes of the tools in a capsule whose radius changes evenly from the reference
/// points to the upper ends. It is used for places inside a given ball only, so that
/// endless cutters have an upper end. An immutable value.
class ToolPieces {
public:
    /// \param pieces in any order.
    /// \param region contains all places that are asked for.
    ToolPieces(std::vector<ToolPiece> pieces, const Sphere& region);

    std::span<const ToolPiece> pieces() const { return pieces_; }  ///< in tree order

    /// Calls `visit` for the pieces that may come near a place, in the order of lower
    /// bounds of the signed distance between the place and the volume that the piece
    /// sweeps.
    /// \param place  mm, in the region.
    /// \param visit  takes the number of the piece and the bound in mm; it returns the
    ///               bound up to which pieces are visited from now on.
    /// \param most   the first such bound.
    void visit_nearest(
        const Vec3& place, double most,
        const std::function<double(std::size_t piece, double bound)>& visit) const;

    /// Returns the numbers of the pieces that may come within a distance of a segment.
    /// \param within in mm.
    std::vector<std::uint32_t> near_segment(const Vec3& from, const Vec3& to,
                                            double within) const;

    /// Whether a piece may come within a distance of a segment.
    /// \param within in mm.
    bool is_near(std::uint32_t piece, const Vec3& from, const Vec3& to,
                 double within) const
    {
        return capsules_[piece].is_near(from, to, within);
    }

private:
    // Capsule around the axes of the pieces, thickened by the radius of the cutters.
    struct Capsule {
        Capsule(const Sphere& at_low, const Sphere& at_high);

        Vec3 low;            // mm, middle of the lower ends of the axes
        Vec3 high;           // mm, middle of the upper ends
        double low_radius;   // mm
        double high_radius;  // mm
        double length;       // mm
        Vec3 along;          // unit, from low to high; 0 without a length
        double widening;     // of the radius over the length; 0 without a length

        double distance(const Vec3& place) const;
        bool is_near(const Vec3& from, const Vec3& to, double within) const;
    };
    struct Node {
        Capsule around;
        std::uint32_t first;  // pieces first to last - 1
        std::uint32_t last;
        std::uint32_t second_child;  // the first follows the node; 0: a leaf
    };

    Capsule around(std::size_t piece) const;
    Capsule around(std::span<const Capsule> some) const;
    std::uint32_t add_node(std::uint32_t first, std::uint32_t last);

    std::vector<ToolPiece> pieces_;
    std::vector<Capsule> capsules_;
    std::vector<Node> nodes_;
    Sphere region_;
};

}  // namespace endmill
