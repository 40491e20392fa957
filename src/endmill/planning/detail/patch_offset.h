// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "endmill/planning/detail/pass_march.h"

namespace endmill {

/// A surface's offset r + h N within one of its patches, whose normals count at its borders.
class PatchOffset {
public:
    /// \param marched outlives this. \param inside a place inside the patch.
    /// \param height h in mm, of either sign.
    PatchOffset(const MarchedSurface& marched, const SurfacePoint& inside, double height);

    /// r + h N at global parameters, mm; where there is no normal, not even a limit of
    /// normals from inside the patch, nothing.
    std::optional<Vec3> at(double u, double v) const;

private:
    const MarchedSurface& marched_;
    int i_;
    int j_;
    std::span<const double> u_;
    std::span<const double> v_;
    double height_;
};

}  // namespace endmill
