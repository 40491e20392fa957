// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to interference
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "endmill/interference/offset_mesh.h"
#include "endmill/interference/sheet_newton.h"

namespace endmill {

/// The smooth offset that an offset mesh is a sampling of: from a place on the mesh to the
/// smooth piece that it was sampled from, and where on it the place is about.
class SmoothOffset {
public:
    /// \param offset, surfaces as offset_mesh had them; both outlive this.
    /// \param grid_lines as OffsetOptions had them: a search stays within the cells next
    ///        to where it starts.
    SmoothOffset(const OffsetMesh& offset, std::span<const Surface> surfaces,
                 int grid_lines);

    /// Where on which smooth piece the point at `share` of the way from edge.below to
    /// edge.above is about; `third` is a vertex of a triangle at the edge.
    /// \return nothing over a corner of the part, where the contact stays as it is, and
    ///         where the vertices belong to different surfaces.
    std::optional<SheetStart> start(const CrossedEdge& edge, double share,
                                    std::int32_t third) const;

    const TriangleMesh& mesh() const { return offset_.mesh; }  ///< the sampling

private:
    std::optional<SheetStart> face_start(const CrossedEdge& edge, double share,
                                         std::int32_t third) const;
    std::optional<SheetStart> strip_start(const CrossedEdge& edge, double share,
                                          std::int32_t turned) const;
    Eigen::Vector2d cell(const Surface& surface) const;

    const OffsetMesh& offset_;
    std::span<const Surface> surfaces_;
    std::vector<double> sides_;
    int grid_lines_;
};

}  // namespace endmill
