// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// hold: paper/notes/whole-cones.md.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/setup/detail/axis_fit.h"
#include "endmill/setup/detail/coverage_table.h"

namespace endmill {

/// What a node's triangle holds.
enum class NodeKind : std::uint8_t {
    Axis,  ///< axes of sets wider than the thin width: C in C,A, R1 in A,B
    Arc    ///< normals of the great circles along which narrower sets lie
};

/// Levels of sets, rad: low < m <= high, but m = 0 lies in the lowest box. In a node of arcs both
/// sides are the half width of the band about the circle.
struct LevelBox {
    std::array<double, 2> low;
    std::array<double, 2> high;
    double bound;  ///< no set in node and box has a smaller objective
};

/// A triangle of axes and what its sets may be.
struct AxisNode {
    std::array<Vec3, 3> corners;  ///< unit, less than 90 degrees apart
    NodeKind kind;
    std::vector<LevelBox> boxes;
    double bound;  ///< the least of the boxes'
};

/// Middle of the node's triangle, a unit vector.
Vec3 centre(const AxisNode& node);

/// rad: no point of the triangle is farther from its centre.
double radius(const AxisNode& node);

/// A part of the node, 0 to 3: cut through the middles of its sides; with the node's boxes.
AxisNode part(const AxisNode& node, int number);

/// The whole search: triangles of 7 to 10 degrees that cover the sphere of axes (C,A), or one
/// of each pair of opposite ones (A,B, and arcs).
std::vector<AxisNode> root_nodes(const ConeFitting& fitting);

/// A good ConeFitting::thin_width to begin with, rad. Sets narrower than it slide along their
/// great circle, so that nodes of axes would have to be small all along it; nodes of arcs need
/// not, but take a lune for the band that holds it, and so may be too low by the whole width.
/// Where that is too much the search is to begin again with less. 0 for Tilt, which has no such
/// sets. `best`: the least objective known, or infinite.
double thin_width(const PoseMeasure& measure, double best);

/// Bounds nodes. Keeps its memory between calls; one a thread.
class NodeBounder {
public:
    explicit NodeBounder(const ConeFitting& fitting);

    /// Splits the node's boxes and drops those that have nothing below `target`: what stays
    /// is in node.boxes, its least bound in node.bound. Bounds are rounded down.
    void bound(AxisNode& node, double target);

private:
    struct Useful {
        double from;  ///< windows that are narrower count as this
        double to;    ///< windows from here on do not matter
    };

    Useful useful(NodeKind kind, const LevelBox& box, double target) const;
    double objective(NodeKind kind, const LevelBox& box, double window) const;
    void split(NodeKind kind, const LevelBox& box);

    ConeFitting fitting_;
    WindowSweep sweep_;
    CoverageTable table_;
    std::vector<LevelBox> open_;
};

}  // namespace endmill
