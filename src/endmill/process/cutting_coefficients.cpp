// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/cutting_coefficients.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/process/detail/top_integrals.h"

// The coefficients are computed in four steps:
// 1. EngagedRegion describes the engaged part of the ball by its borders.
// 2. `border_integrals` and `top_integrals` add up line integrals along the borders,
//    which equal the surface integrals by Green's theorem.
// 3. Division by 2 pi gives the means over a spindle revolution.
// 4. `shank_coefficients` adds the cylinder above the ball in closed form.

namespace endmill {
namespace {

using std::numbers::pi;

// The two rules of an arc may differ by this share of the accuracy (of 2 pi times a
// coefficient). The error of the longer rule is far smaller than the difference, and only
// a few arcs come near the tolerance, so the sum of all errors stays below the accuracy.
constexpr double tolerance_share = 0.1;
// Share of the accuracy that is demanded for level moves, for which 1e-11 is promised.
constexpr double level_share = 0.1;

CuttingCoefficients means(const CoefficientSums& sums)
{
    constexpr double turn = 2 * pi;
    return {sums[0] / turn, sums[1] / turn, sums[2] / turn, sums[3] / turn,
            sums[4] / turn, sums[5] / turn, sums[6] / turn, sums[7] / turn};
}

double total_angle(std::span<const AzimuthRange> azimuths)
{
    double angle = 0;
    for (const AzimuthRange& range : azimuths)
        angle += range.to - range.from;
    return angle;
}

}  // namespace

double engaged_angle(const BallEngagement& engagement)
{
    require_sound(engagement);
    if (is_air(engagement))
        return 0;
    const EngagedRegion region{engagement};
    return total_angle(region.ranges_at(region.top_sine, region.top_cosine));
}

CuttingCoefficients shank_coefficients(const BallEngagement& engagement, ChipModel chip)
{
    require_sound(engagement);
    const double length = std::max(0.0, engagement.depth_ratio - 1);
    if (is_air(engagement) || length == 0)
        return {};
    const double angle = shank_angle(engagement);
    const double share = chip == ChipModel::Exact ? std::cos(engagement.lambda) : 1;
    const double sine = std::sin(angle);
    const double cosine = std::cos(angle);
    const double edge = length / (2 * pi);
    return {edge * share * sine * sine / 2,
            edge * share * (angle - sine * cosine) / 2,
            edge * sine,
            edge * (1 - cosine),
            edge * share * (1 - cosine),
            edge * angle,
            edge * share * (1 - cosine),
            edge * angle};
}

CuttingCoefficients sum(const CuttingCoefficients& first,
                        const CuttingCoefficients& second)
{
    return {first.I1 + second.I1, first.I2 + second.I2, first.I3 + second.I3,
            first.I4 + second.I4, first.I5 + second.I5, first.I6 + second.I6,
            first.I7 + second.I7, first.I8 + second.I8};
}

CuttingCoefficients cutting_coefficients(const BallEngagement& engagement, ChipModel chip,
                                         double accuracy)
{
    return engaged_coefficients(engagement, chip, accuracy).coefficients;
}

EngagedCoefficients engaged_coefficients(const BallEngagement& engagement, ChipModel chip,
                                         double accuracy)
{
    require_sound(engagement);
    require(accuracy >= 1e-12 && accuracy <= 1e-3,
            "cutting_coefficients: need an accuracy from 1e-12 to 1e-3");
    if (is_air(engagement))
        return {};
    const EngagedRegion region{engagement};
    double tolerance = 2 * pi * tolerance_share * accuracy;
    if (engagement.lambda == 0)
        tolerance *= level_share;
    CoefficientSums sums = border_integrals(region, chip, tolerance);
    const std::vector<AzimuthRange> azimuths =
        region.ranges_at(region.top_sine, region.top_cosine);
    const CoefficientSums top = top_integrals(region, chip, azimuths);
    for (std::size_t k = 0; k < sums.size(); ++k)
        sums[k] += top[k];
    return {sum(means(sums), shank_coefficients(engagement, chip)),
            total_angle(azimuths)};
}

std::vector<CuttingCoefficients> cutting_coefficients(
    std::span<const BallEngagement> engagements, ChipModel chip, double accuracy)
{
    std::vector<CuttingCoefficients> all(engagements.size());
    parallel_for(engagements.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            all[k] = cutting_coefficients(engagements[k], chip, accuracy);
    });
    return all;
}

}  // namespace endmill
