// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/interference/offset_profile.h"

namespace endmill {

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
