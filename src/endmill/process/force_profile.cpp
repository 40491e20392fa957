// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/force_profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "endmill/core/error.h"

namespace endmill {
namespace {

using std::numbers::pi;

// Gauss's nodes on [-1, 1], those of one side, and their weights.
// Source: Abramowitz and Stegun, table 25.4, n = 16.
constexpr std::array<double, 8> gauss_node{
    0.0950125098376374, 0.2816035507792589, 0.4580167776572274, 0.6178762444026438,
    0.7554044083550030, 0.8656312023878318, 0.9445750230732326, 0.9894009349916499};
constexpr std::array<double, 8> gauss_weight{
    0.1894506104550685, 0.1826034150449236, 0.1691565193950025, 0.1495959888165767,
    0.1246289712555339, 0.0951585116824928, 0.0622535239386479, 0.0271524594117541};

MillingCut sound(const MillingCut& cut)
{
    require_sound(cut.engagement);
    require_sound(cut.material);
    require_sound(cut.tool);
    require(std::isfinite(cut.feed_per_tooth_mm) && cut.feed_per_tooth_mm >= 0,
            "ForceProfile: need a feed per tooth of 0 or more");
    require(std::isfinite(cut.runout.offset_mm) && cut.runout.offset_mm >= 0 &&
                std::isfinite(cut.runout.angle),
            "ForceProfile: need a runout of 0 or more");
    return cut;
}

double latitude_at(double height)
{
    return 2 * std::asin(std::sqrt(std::clamp(height / 2, 0.0, 0.5)));
}

}  // namespace

struct ForceProfile::Sums {
    double along = 0;
    double across = 0;
    double axial = 0;
    double torque = 0;
};

ForceProfile::ForceProfile(const MillingCut& cut)
    : cut_{sound(cut)},
      edge_{cut.engagement, cut.tool.helix},
      cos_lambda_{std::cos(cut.engagement.lambda)},
      sin_lambda_{std::sin(cut.engagement.lambda)}
{
}

// Of the chip at an azimuth and height, in mm over the height; `beyond` by runout.
double ForceProfile::thickness(double azimuth, double height, double beyond) const
{
    const double sine = std::sin(azimuth);
    if (cut_.chip == ChipModel::Paper)
        return cut_.feed_per_tooth_mm * std::abs(sine) + beyond;
    const double cotangent =
        height < 1 ? (1 - height) / std::sqrt(height * (2 - height)) : 0;
    return cut_.feed_per_tooth_mm * (cos_lambda_ * sine - sin_lambda_ * cotangent) +
           beyond;
}

ForceProfile::EdgeLoad ForceProfile::load(double thickness_mm) const
{
    if (thickness_mm < 0)
        return {0, 0, 0};
    const CuttingMaterial& m = cut_.material;
    const double h = m.edge_thickness_mm;
    return {thickness_mm + h, m.r1 * thickness_mm + m.r2 * h,
            m.r3 * thickness_mm + m.r4 * h};
}

// A part of an edge over which its chip is smooth: by the latitude on the ball, by the height
// above.
void ForceProfile::add_part(const EdgeStretch& part, double azimuth, double beyond,
                            Sums& sums) const
{
    const bool is_on_ball = part.to <= 1;
    const double from = is_on_ball ? latitude_at(part.from) : part.from;
    const double to = is_on_ball ? latitude_at(part.to) : part.to;
    const double side = cut_.milling == Milling::Up ? 1 : -1;
    for (std::size_t k = 0; k < gauss_node.size(); ++k)
        for (const double node : {-gauss_node[k], gauss_node[k]}) {
            const double place = (from + to) / 2 + (to - from) / 2 * node;
            const double radius = is_on_ball ? std::sin(place) : 1;
            const double half = std::sin(place / 2);
            const double height = is_on_ball ? 2 * half * half : place;
            const double at = azimuth - height * edge_.tangent();
            const EdgeLoad edge = load(thickness(at, height, beyond));
            const double share = gauss_weight[k] * (to - from) / 2 * radius;
            const double sine = std::sin(at);
            const double cosine = std::cos(at);
            sums.along +=
                share * (side * edge.tangential_mm * cosine + edge.radial_mm * sine);
            sums.across +=
                share * (edge.radial_mm * cosine - side * edge.tangential_mm * sine);
            sums.axial += share * edge.axial_mm;
            sums.torque += share * radius * side * edge.tangential_mm;
        }
}

// Parts a stretch where its chip has a corner: where sin(azimuth) changes its sign, and where
// the chip begins or ends.
void ForceProfile::add_stretch(const EdgeStretch& stretch, double azimuth, double beyond,
                               Sums& sums) const
{
    constexpr int samples = 32;
    constexpr int halvings = 45;
    const auto kind = [&](double height) {
        const double at = azimuth - height * edge_.tangent();
        const bool has_chip = thickness(at, height, beyond) >= 0;
        return (std::sin(at) > 0 ? 2 : 0) + (has_chip ? 1 : 0);
    };
    // Dense at the lower end: near the tip the exact chip grows without bound.
    const auto height_at = [&](double share) {
        return stretch.from + (stretch.to - stretch.from) * share * share;
    };
    double from = stretch.from;
    double last = height_at(0.5 / samples);
    for (int k = 1; k < samples; ++k) {
        const double next = height_at((k + 0.5) / samples);
        if (kind(next) != kind(last)) {
            double low = last;
            double high = next;
            for (int j = 0; j < halvings; ++j) {
                const double middle = (low + high) / 2;
                (kind(middle) == kind(next) ? high : low) = middle;
            }
            add_part({from, high}, azimuth, beyond, sums);
            from = high;
        }
        last = next;
    }
    add_part({from, stretch.to}, azimuth, beyond, sums);
}

CuttingForce ForceProfile::at(double turn) const
{
    constexpr double mm_per_m = 1000;
    const int flutes = cut_.tool.flutes;
    Sums sums;
    for (int flute = 0; flute < flutes; ++flute) {
        const double behind = 2 * pi * flute / flutes;
        const double beyond = cut_.runout.offset_mm *
                              (std::cos(behind - cut_.runout.angle) -
                               std::cos(behind - 2 * pi / flutes - cut_.runout.angle));
        for (const EdgeStretch& stretch : edge_.engaged(turn - behind))
            add_stretch(stretch, turn - behind, beyond, sums);
    }
    const double scale = cut_.material.specific_resistance_n_per_mm2 * cut_.tool.radius;
    return {scale * sums.along, scale * sums.across, scale * sums.axial,
            scale * cut_.tool.radius * sums.torque / mm_per_m};
}

}  // namespace endmill
