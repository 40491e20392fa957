// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/setup/detail/axis_fit.h"
#include "endmill/setup/detail/coverage_table.h"

/// \file
/// Nodes of the search over whole cones: spherical triangles of axes with lower bounds of
/// the objective. Source: paper/notes/whole-cones.md, sections 3, 4, 7.

namespace endmill {

/// The meaning of the points of a node's triangle.
enum class NodeKind : std::uint8_t {
    Axis,  ///< axes (C in C,A, R1 in A,B) of ranges wider than the thin width
    Arc    ///< normals of the great circles along which thinner ranges lie
};

/// A box of levels (m0, m1) in rad: low < m <= high; m = 0 belongs to the lowest box. In
/// a node of arcs both sides are the half width of the band about the circle.
struct LevelBox {
    std::array<double, 2> low;   ///< lower limits of m0 and m1
    std::array<double, 2> high;  ///< upper limits of m0 and m1
    /// No range of the node with levels in the box has a smaller objective.
    double bound;
};

/// A spherical triangle of axes, with the boxes of levels that are not excluded.
struct AxisNode {
    std::array<Vec3, 3> corners;  ///< unit, less than 90 degrees apart
    NodeKind kind;                ///< what the points of the triangle are
    std::vector<LevelBox> boxes;  ///< those that are not excluded
    double bound;                 ///< the least bound of the boxes
};

/// Centre of the node's triangle, a unit vector.
Vec3 centre(const AxisNode& node);

/// Largest angle between the centre and a point of the triangle, rad.
double radius(const AxisNode& node);

/// One of the four parts of a node, cut through the middles of its sides, with the same
/// boxes.
/// \param node to be split. \param number 0 to 3.
AxisNode part(const AxisNode& node, int number);

/// The nodes with which the search begins: triangles of 7 to 10 degrees. They cover the
/// sphere of axes in C,A, and one of each pair of opposite axes in A,B and for arcs.
std::vector<AxisNode> root_nodes(const ConeFitting& fitting);

/// A value of ConeFitting::thin_width, rad, with which the search begins.
///
/// The axis of a range with a thin window can slide along the arc of the range, so that
/// nodes of axes would have to be small all along it. Nodes of arcs describe such a range
/// by the normal of its great circle instead. Their bound may be too low by the whole
/// width, because they replace the lune of the window by a band. If nodes of arcs become
/// too small, the search starts again with a smaller thin width.
/// \param measure what is minimised; the result is 0 for Tilt, which has no such ranges.
/// \param best the least objective known, or infinity.
double thin_width(const PoseMeasure& measure, double best);

/// Computes lower bounds of nodes. Keeps its memory between calls; one for each thread.
class NodeBounder {
public:
    /// \param fitting the problem; its cones and centres must outlive the bounder.
    explicit NodeBounder(const ConeFitting& fitting);

    /// Splits the boxes of a node and drops those without a range below `target`. The
    /// remaining boxes are in node.boxes, their least bound in node.bound. Bounds are
    /// rounded down.
    /// \param node to be bounded. \param target rad^2 or rad.
    /// \param grow if set, it is called with the cells that the windows of the remaining
    ///        boxes meet. The bound then takes the cones that it adds into account.
    void bound(AxisNode& node, double target, const GrowCones& grow = {});

private:
    /// Windows that can lead to an objective below the target, rad.
    struct Useful {
        double from;  ///< narrower windows count as this width
        double to;    ///< wider windows do not matter; negative: no window does
    };

    Useful useful(NodeKind kind, const LevelBox& box, double target) const;
    double objective(NodeKind kind, const LevelBox& box, double window) const;
    void split(NodeKind kind, const LevelBox& box);
    std::optional<AzimuthWindow> least_window(const LevelLimits& upto, double cap,
                                              const GrowCones& grow);

    ConeFitting fitting_;
    WindowSweep sweep_;
    CoverageTable table_;
    AxisView view_;
    std::array<double, 2> reach_{};  ///< largest levels that count, rad
    std::vector<LevelBox> open_;
};

}  // namespace endmill
