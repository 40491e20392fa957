// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "endmill/core/tolerance.h"
#include "endmill/core/vec.h"

namespace endmill {

/// The unit vector for an axis read from a file. An axis whose length is 1 up to the
/// rounding of doubles (1e-12) is returned unchanged, so that written axes read back
/// exactly. Otherwise the axis is normalised.
/// \return std::nullopt if the length is not 1 within `axis_length_tolerance`.
std::optional<Vec3> unit_axis(const Vec3& axis);

}  // namespace endmill
