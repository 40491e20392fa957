// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/core/vec.h"

namespace endmill {

/// One of the two parameters of a surface.
enum class Parameter { U, V };

/// A place on a surface by its global parameters.
struct SurfacePoint {
    double u;
    double v;
};

/// "u = 1.5, v = 0 (30, 0, 12 mm)": the place and its point, for a message; parameters to
/// 1e-4, coordinates to 0.001 mm.
std::string place_text(const SurfacePoint& at, const Vec3& point);

/// A closed interval of a parameter, or of a length in mm.
struct Interval {
    double low;
    double high;

    double length() const { return high - low; }  ///< in the interval's own unit
};

}  // namespace endmill
