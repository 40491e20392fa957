// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "endmill/interference/section_curve.h"

namespace endmill {

/// A planar profile z = f(x) and the ball that cuts it: a case to try trimming methods on.
struct OffsetProfile {
    std::string name;
    std::function<double(double)> height;  ///< f in mm, of x in mm
    std::function<double(double)> slope;   ///< f'; at a crease the mean of both sides
    double from = 0;                       ///< mm, least x
    double to = 0;                         ///< mm, largest x
    double radius = 0;                     ///< mm, of the ball
};

/// The path of the ball's centre along `profile`, folds and loops kept: for each of
/// `points` equidistant x from one end to the other the point (x, f) + R n with
/// n = (-f', 1) / sqrt(1 + f'^2).
/// Source: [JangKimJeong, eq. (1), (2)], the slope of the normal corrected to -1/f'.
/// \throws DomainError unless points >= 2, from < to and 0 < radius.
SectionCurve offset_curve(const OffsetProfile& profile, int points);

}  // namespace endmill
