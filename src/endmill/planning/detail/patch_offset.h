// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "endmill/planning/detail/marched_surface.h"

namespace endmill {

/// The offset r + h N of one patch of a surface. At a border of the patch the normal is
/// that of this patch, also where the surface has a crease.
class PatchOffset {
public:
    /// \param marched the surface; must outlive this.
    /// \param inside  parameters of any place inside the patch.
    /// \param height  h in mm, of either sign.
    PatchOffset(const MarchedSurface& marched, const SurfacePoint& inside, double height);

    /// The point r + h N in mm at parameters of the surface.
    /// \return nothing if the patch has no normal there, not even as a limit from its
    ///         inside.
    std::optional<Vec3> at(double u, double v) const;

private:
    const MarchedSurface& marched_;
    int i_;  // numbers of the patch
    int j_;
    std::span<const double> u_;  // both ends of the patch in u
    std::span<const double> v_;  // and in v
    double height_;
};

}  // namespace endmill
