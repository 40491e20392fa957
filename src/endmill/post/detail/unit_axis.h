// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "endmill/core/tolerance.h"
#include "endmill/core/vec.h"

namespace endmill {

/// The unit vector that an axis in a file means: as it stands if rounding of doubles
/// explains its length (1e-12), so that what was written is read; else scaled.
/// \return nothing if its length is not 1 within `axis_length_tolerance`.
std::optional<Vec3> unit_axis(const Vec3& axis);

}  // namespace endmill
