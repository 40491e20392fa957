// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "endmill/bound/detail/cover_boundary.h"
#include "endmill/bound/detail/density_grid.h"
#include "endmill/bound/detail/tool_bins.h"

namespace endmill {

/// The raised surfaces of a part in small cells, sorted by their place in the xy plane.
/// They find covered points that the rays of a contact do not meet, on other surfaces,
/// across the seam of a closed surface or beyond a gap, and then give the whole boundary
/// of D(x) by marching triangles.
class RaisedCells {
public:
    /// \param part its surfaces must outlive this.
    /// \param problem must outlive this.
    /// \param spacing of the cells in mm.
    RaisedCells(const BoundedPart& part, const BoundProblem& problem, double spacing);

    /// Whether the rays contain every sampled point that is covered.
    /// \param frame of the contact.
    /// \param rays of the same contact.
    bool has_only(const ContactFrame& frame, const CoverRays& rays) const;

    /// The boundary of D(x) with all its components. Each cell near it is divided into 4
    /// by 4. Crossings are exact to second order in the size of these.
    std::vector<BoundaryFlow> boundary(const ContactFrame& frame) const;

    /// The covered set in pieces, at the same resolution.
    std::vector<CoveredPiece> covered(const ContactFrame& frame) const;

private:
    // A cell and the raised point of its lowest corner.
    struct Entry {
        Vec3 point;
        double size;  // greatest distance of the other raised corners, mm
        std::uint32_t cell;
    };

    std::vector<Entry> entries() const;
    double far_from(const ToolReach& tool) const;

    const BoundedPart& part_;
    const BoundProblem& problem_;
    DensityGrid grid_;
    ToolBins<Entry> bins_;
};

}  // namespace endmill
