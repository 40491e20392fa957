// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace endmill {

/// One of the two parameters of a surface.
enum class Parameter { U, V };

/// A place on a surface by its global parameters.
struct SurfacePoint {
    double u;
    double v;
};

/// A closed interval of a parameter, or of a length in mm.
struct Interval {
    double low;
    double high;

    double length() const { return high - low; }  ///< in the interval's own unit
};

}  // namespace endmill
