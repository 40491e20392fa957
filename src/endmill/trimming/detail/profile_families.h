// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "endmill/offset/section_curve.h"

namespace endmill {

/// A planar profile z = f(x) and the ball that cuts it: a test case for trimming methods.
struct OffsetProfile {
    std::string name;                      ///< as in the data files
    std::function<double(double)> height;  ///< f in mm, as a function of x in mm
    /// f'; at a crease the mean of the slopes on both sides
    std::function<double(double)> slope;
    double from = 0;    ///< mm, smallest x
    double to = 0;      ///< mm, largest x
    double radius = 0;  ///< mm, of the ball
};

/// The path of the ball's centre along `profile`, folds and loops included. It has the
/// point (x, f) + R n with n = (-f', 1) / sqrt(1 + f'^2) for each of `points` equidistant
/// x.
/// Source: [JangKimJeong, eq. (1), (2)], with the slope of the normal corrected to -1/f'.
/// \param profile the profile and the ball.
/// \param points number of samples, at least 2. Consecutive equal points are merged.
/// \throws DomainError unless points >= 2, from < to and 0 < radius.
SectionCurve offset_curve(const OffsetProfile& profile, int points);

/// 21 profiles whose offset curves are hard to trim, usually sampled at 401 points. Their
/// exact results are in datasets/offset-curves/hard-cases.json.
std::vector<OffsetProfile> hard_profiles();

/// 400 random profiles, usually sampled at 401 points: sums of two cosines and a
/// parabola. About 85 % of their offsets cross themselves. The draws of the random
/// numbers define the profiles, so that they are the same on every machine but for the
/// last bits of the cosines. Their parameters are in
/// datasets/offset-curves/random-families.json.
std::vector<OffsetProfile> wavy_profiles();

/// 500 random convex profiles, polynomials of degree 4 with a ball that often does not
/// fit. There is one set for each sampling of 41, 101, 401 or 1601 points, defined in the
/// same way as wavy_profiles.
/// \param points the sampling that the set belongs to.
/// \throws DomainError for another number of points.
std::vector<OffsetProfile> convex_profiles(int points);

}  // namespace endmill
