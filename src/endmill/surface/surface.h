// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "endmill/surface/bezier_patch.h"
#include "endmill/surface/surface_jet.h"

namespace endmill {

/// Which side of a surface the tool is on.
enum class ToolSide {
    Up,         ///< the side whose normal has N . axis > 0
    DuCrossDv,  ///< the side that du x dv points to
    DvCrossDu,  ///< the other one
};

/// A parametric surface of any kind, held as the grid of Bezier patches that it is:
/// patch (i, j) spans breaks(U)[i] … breaks(U)[i + 1] by breaks(V)[j] … breaks(V)[j + 1].
/// An immutable value.
class Surface {
public:
    /// \param breaks_u  borders of the patches in u, rising, one more than patches in u.
    /// \param breaks_v  the same in v.
    /// \param patches   patch (i, j) at [j * patches_u + i].
    /// \throws DomainError if the sizes disagree, or the breaks are not finite and rising.
    Surface(std::vector<double> breaks_u, std::vector<double> breaks_v,
            std::vector<BezierPatch> patches, ToolSide tool_side = ToolSide::Up);

    int patches(Parameter along) const;                    ///< at least 1
    std::span<const double> breaks(Parameter along) const  ///< rising
    {
        return along == Parameter::U ? breaks_u_ : breaks_v_;
    }
    Interval range(Parameter along) const;             ///< first and last break
    ToolSide tool_side() const { return tool_side_; }  ///< as given

    /// The patch in column i (u) and row j (v).
    /// \pre 0 <= i < patches(U), 0 <= j < patches(V)
    const BezierPatch& patch(int i, int j) const
    {
        return patches_[static_cast<std::size_t>(j) * (breaks_u_.size() - 1) + i];
    }

    /// Number of the patch along `along` that serves `parameter`: at a border the one
    /// above it; beyond the ends the last one, whose polynomial goes on there.
    int patch_number(Parameter along, double parameter) const;

    /// Width in `along` of the patch that serves `parameter`.
    double patch_width(Parameter along, double parameter) const;

    /// Point and first partials at (u, v).
    SurfaceTangents tangents(double u, double v) const;

    /// Point, first and second partials at (u, v); one-sided at a border, see
    /// patch_number.
    SurfaceJet jet(double u, double v) const;

    /// Point and partials of patch (i, j), at a place that may lie on its border.
    SurfaceJet jet_in_patch(int i, int j, double u, double v) const;

    /// Diagonal in mm of the box around all control points: the size that tolerances
    /// refer to.
    double diagonal() const { return diagonal_; }

private:
    std::vector<double> breaks_u_;
    std::vector<double> breaks_v_;
    std::vector<BezierPatch> patches_;
    ToolSide tool_side_;
    double diagonal_;
};

/// The surface of a composite bicubic net whose patches share their borders, with
/// global parameters u in [0, patches_u], v in [0, patches_v].
/// Source: [KimChoi, section 2 and fig. 11].
///
/// \param net (3 patches_u + 1) (3 patches_v + 1) control points in mm, u running
///        fastest.
/// \throws DomainError if a count is below 1, the net has another size, or a point is
///        not finite.
Surface composite_bezier(int patches_u, int patches_v, std::span<const Vec3> net,
                         ToolSide tool_side = ToolSide::Up);

/// The same surface with u and v exchanged; its tool side stays the same in space.
Surface transposed(const Surface& surface);

/// The same surface with u turned round: what was at u is at low + high - u, where low
/// and high end the range of u. Its tool side stays the same in space.
Surface reversed_in_u(const Surface& surface);

}  // namespace endmill
