// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/cutting_coefficients.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/process/detail/top_integrals.h"

namespace endmill {
namespace {

using std::numbers::pi;

// The rules of a stretch may differ by this share of the accuracy of 2 pi times a
// coefficient: where they do, the longer one is far better than the difference, and the
// few stretches that come near it add up to less than the whole.
constexpr double tolerance_share = 0.1;
// Level moves are held to a tenth of the accuracy.
constexpr double level_share = 0.1;

CuttingCoefficients means(const CoefficientSums& sums)
{
    constexpr double turn = 2 * pi;
    return {sums[0] / turn, sums[1] / turn, sums[2] / turn, sums[3] / turn,
            sums[4] / turn, sums[5] / turn, sums[6] / turn, sums[7] / turn};
}

}  // namespace

double engaged_angle(const BallEngagement& engagement)
{
    require_sound(engagement);
    if (is_air(engagement))
        return 0;
    const EngagedRegion region{engagement};
    double angle = 0;
    for (const AzimuthRange& range : region.ranges_at(region.top_sine, region.top_cosine))
        angle += range.to - range.from;
    return angle;
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
    const CoefficientSums top = top_integrals(region, chip);
    for (std::size_t k = 0; k < sums.size(); ++k)
        sums[k] += top[k];
    return sum(means(sums), shank_coefficients(engagement, chip));
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
