// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "endmill/mesh/triangle_tree.h"
#include "endmill/simulation/part_cell.h"

namespace endmill {

/// Answers how far a place is from the part: a mesh itself, or a triangulation of the
/// surfaces. Refers to the mesh, which must outlive it.
class PartDistance {
public:
    /// \param chord_tolerance of the triangulation, in mm.
    PartDistance(const PartCharts& charts, double chord_tolerance);
    PartDistance(const PartDistance&) = delete;             ///< its tree points into it
    PartDistance& operator=(const PartDistance&) = delete;  ///< ditto

    /// Distance in mm of `place` from the part, never less than it is, and more by at most
    /// twice the chord tolerance.
    double operator()(const Vec3& place) const;

private:
    TriangleMesh sampled_;
    double chord_error_ = 0;
    std::optional<TriangleTree> tree_;
};

}  // namespace endmill
