// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/top_integrals.h"

#include <cmath>
#include <numbers>

// On the stock's top the latitude is constant, so the integral of g_k(t) h_k(latitude)
// over the azimuth t is h_k times a closed integral of g_k. The azimuths engaged on the
// top come from the region.

namespace endmill {
namespace {

using std::numbers::pi;

// Integrals of g_k over a range of azimuths in which sin(azimuth) has one sign.
struct AzimuthIntegrals {
    double sine_cosine;  // of sin t cos t
    double sine_square;  // of sin^2 t
    double cosine;       // of cos t
    double sine;         // of sin t
    double length;       // of 1
};

// The integrals in closed form.
AzimuthIntegrals azimuth_integrals(const AzimuthRange& range)
{
    const double sin_from = std::sin(range.from);
    const double cos_from = std::cos(range.from);
    const double sin_to = std::sin(range.to);
    const double cos_to = std::cos(range.to);
    const double length = range.to - range.from;
    return {(sin_to * sin_to - sin_from * sin_from) / 2,
            (length - sin_to * cos_to + sin_from * cos_from) / 2, sin_to - sin_from,
            cos_from - cos_to, length};
}

// Adds a range of azimuths in which sin(azimuth) has one sign.
void add_top(const EngagedRegion& region, ChipModel chip, const AzimuthRange& range,
             CoefficientSums& sums)
{
    const AzimuthIntegrals of = azimuth_integrals(range);
    const double edge = region.depth;
    const double torque =
        region.depth * region.top_sine * torque_height_share(region.depth);
    sums[2] += edge * of.cosine;
    sums[3] += edge * of.sine;
    sums[5] += edge * of.length;
    sums[7] += torque * of.length;
    if (chip == ChipModel::Paper) {
        const bool in_front = range.from >= 0 && range.to <= pi;
        const double side = in_front ? 1 : -1;
        sums[0] += side * edge * of.sine_cosine;
        sums[1] += side * edge * of.sine_square;
        sums[4] += side * edge * of.sine;
        sums[6] += side * torque * of.sine;
        return;
    }
    const double along = region.cos_lambda;
    const double down = region.sin_lambda * region.top_sine;
    sums[0] += along * edge * of.sine_cosine - down * of.cosine;
    sums[1] += along * edge * of.sine_square - down * of.sine;
    sums[4] += along * edge * of.sine - down * of.length;
    sums[6] += along * torque * of.sine - down * region.top_sine / 2 * of.length;
}

}  // namespace

CoefficientSums top_integrals(const EngagedRegion& region, ChipModel chip,
                              std::span<const AzimuthRange> azimuths)
{
    CoefficientSums sums{};
    for (AzimuthRange range : azimuths) {
        // The range is split at multiples of pi, where sin(azimuth) changes its sign.
        for (const double turn : {0.0, pi})
            if (range.from < turn && turn < range.to) {
                add_top(region, chip, {range.from, turn}, sums);
                range.from = turn;
            }
        add_top(region, chip, range, sums);
    }
    return sums;
}

}  // namespace endmill
