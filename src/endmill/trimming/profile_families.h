// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "endmill/offset/section_curve.h"

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

/// 21 profiles whose offset curves are hard to trim, usually sampled at 401 points. Their
/// exact answers are in datasets/offset-curves/hard-cases.json.
std::vector<OffsetProfile> hard_profiles();

/// 400 random profiles, sums of two cosines and a parabola, usually sampled at 401 points:
/// about 85 % of their offsets cross themselves. Defined by its draws, the same everywhere
/// but for the last bits of the functions: datasets/offset-curves/random-families.json.
std::vector<OffsetProfile> wavy_profiles();

/// 500 random convex profiles, polynomials of degree 4 with a ball that often does not fit,
/// for a sampling of 41, 101, 401 or 1601 points. Defined as `wavy_profiles`.
/// \throws DomainError for another number of points.
std::vector<OffsetProfile> convex_profiles(int points);

}  // namespace endmill
