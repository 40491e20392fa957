// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "endmill/surface/bezier_patch.h"
#include "endmill/surface/surface_jet.h"

namespace endmill {

/// The side of a surface on which the tool is.
enum class ToolSide {
    Up,         ///< the side whose normal has N . axis > 0
    DuCrossDv,  ///< the side to which du x dv points
    DvCrossDu,  ///< the opposite side
};

/// A parametric surface of any kind, represented exactly as a grid of Bezier patches.
/// Patch (i, j) covers breaks(U)[i] to breaks(U)[i + 1] by breaks(V)[j] to breaks(V)[j +
/// 1]. An immutable value.
class Surface {
public:
    /// \param breaks_u borders of the patches in u, rising; one more than patches in u.
    /// \param breaks_v the same in v.
    /// \param patches patch (i, j) at [j * patches_u + i].
    /// \param tool_side the side of the tool.
    /// \throws DomainError if the sizes do not match, or the breaks are not finite and
    ///         rising.
    Surface(std::vector<double> breaks_u, std::vector<double> breaks_v,
            std::vector<BezierPatch> patches, ToolSide tool_side = ToolSide::Up);

    int patches(Parameter along) const;  ///< number of patches, at least 1
    /// Borders of the patches, rising.
    std::span<const double> breaks(Parameter along) const
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

    /// Number of the patch that contains `parameter`. At a border it is the patch above
    /// the border. Beyond the range it is the first or the last patch, whose polynomial
    /// is extrapolated.
    int patch_number(Parameter along, double parameter) const;

    /// Width of the patch that contains `parameter`.
    double patch_width(Parameter along, double parameter) const;

    /// Point and first partial derivatives at (u, v).
    SurfaceTangents tangents(double u, double v) const;

    /// Point, first and second partial derivatives at (u, v). They are one-sided at a
    /// border; see patch_number.
    SurfaceJet jet(double u, double v) const;

    /// Point and partial derivatives of patch (i, j) at (u, v), which may lie on its
    /// border.
    SurfaceJet jet_in_patch(int i, int j, double u, double v) const;

    /// Diagonal in mm of the bounding box of all control points: the size to which
    /// tolerances refer.
    double diagonal() const { return diagonal_; }

private:
    std::vector<double> breaks_u_;
    std::vector<double> breaks_v_;
    std::vector<BezierPatch> patches_;
    ToolSide tool_side_;
    double diagonal_;
};

/// The surface of a composite bicubic net whose patches share their borders, with global
/// parameters u from 0 to patches_u and v from 0 to patches_v.
/// Source: [KimChoi, section 2 and fig. 11].
/// \param patches_u number of patches in u.
/// \param patches_v number of patches in v.
/// \param net (3 patches_u + 1) (3 patches_v + 1) control points in mm, u varying
///         fastest.
/// \param tool_side the side of the tool.
/// \throws DomainError if a number is below 1, the net has another size, or a point is
///         not finite.
Surface composite_bezier(int patches_u, int patches_v, std::span<const Vec3> net,
                         ToolSide tool_side = ToolSide::Up);

/// The same surface with u and v exchanged. Its tool side stays the same in space.
Surface transposed(const Surface& surface);

/// The same surface with u reversed: what was at u is at low + high - u, where low and
/// high are the ends of the range of u. Its tool side stays the same in space.
Surface reversed_in_u(const Surface& surface);

}  // namespace endmill
