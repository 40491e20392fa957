// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/cutting_force.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "endmill/core/detail/units.h"
#include "endmill/core/error.h"
#include "endmill/process/detail/force_pattern.h"
#include "endmill/process/detail/helical_edge.h"

// The force at one position of the cutter is computed in four steps:
// 1. HelicalEdge gives the ranges of height in which each flute cuts.
// 2. Each range is split where the force per height has a corner: where sin(azimuth)
//    changes its sign, which changes the paper's chip, and where runout makes the chip
//    vanish.
// 3. A Gauss rule of 16 nodes integrates the force over each part. On the ball the
//    variable is the latitude, because the force is smooth in it down to the tip; on the
//    shank it is the height.
// 4. The sums of all flutes are scaled by K r0.

namespace endmill {
namespace {

using std::numbers::pi;

// Gauss nodes on [-1, 1] above 0, and their weights. The table of the handbook has 16
// digits; its last digit is rounded differently from that of the exact value, and stored
// results were computed with it.
// Source: [AbramowitzStegun, table 25.4], n = 16.
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
            "force_profile: need a feed per tooth of 0 or more");
    require(std::isfinite(cut.runout.offset_mm) && cut.runout.offset_mm >= 0 &&
                std::isfinite(cut.runout.angle),
            "force_profile: need a runout of 0 or more");
    return cut;
}

double latitude_at(double height)
{
    return 2 * std::asin(std::sqrt(std::clamp(height / 2, 0.0, 0.5)));
}

// Tangential, radial and axial force per height, divided by K.
struct EdgeLoad {
    double tangential_mm;
    double radial_mm;
    double axial_mm;
};

// Forces of all flutes over K r0, and their torque over K r0^2.
struct ForceSums {
    double along = 0;   // along the feed
    double across = 0;  // across the feed, towards the stock
    double axial = 0;   // along the axis
    double torque = 0;  // about the axis
};

class ForceProfile {
public:
    explicit ForceProfile(const MillingCut& cut)
        : cut_{sound(cut)},
          edge_{cut.engagement, cut.tool.helix},
          cos_lambda_{std::cos(cut.engagement.lambda)},
          sin_lambda_{std::sin(cut.engagement.lambda)}
    {
    }

    CuttingForce at(double turn) const
    {
        const int flutes = cut_.tool.flutes;
        ForceSums sums;
        for (int flute = 0; flute < flutes; ++flute) {
            const double behind = 2 * pi * flute / flutes;
            const double runout_chip =
                cut_.runout.offset_mm *
                (std::cos(behind - cut_.runout.angle) -
                 std::cos(behind - 2 * pi / flutes - cut_.runout.angle));
            for (const EdgeRange& range : edge_.engaged(turn - behind))
                add_range(range, turn - behind, runout_chip, sums);
        }
        const double scale =
            cut_.material.specific_resistance_n_per_mm2 * cut_.tool.radius;
        return {scale * sums.along, scale * sums.across, scale * sums.axial,
                scale * cut_.tool.radius * sums.torque / mm_per_m};
    }

private:
    // Chip thickness in mm for an element of height, at an azimuth and a height above the
    // tip.
    double thickness(double azimuth, double height, double runout_chip) const
    {
        const double sine = std::sin(azimuth);
        if (cut_.chip == ChipModel::Paper)
            return cut_.feed_per_tooth_mm * std::abs(sine) + runout_chip;
        const double cotangent =
            height < 1 ? (1 - height) / std::sqrt(height * (2 - height)) : 0;
        return cut_.feed_per_tooth_mm * (cos_lambda_ * sine - sin_lambda_ * cotangent) +
               runout_chip;
    }

    EdgeLoad load(double thickness_mm) const
    {
        if (thickness_mm < 0)
            return {0, 0, 0};
        const CuttingMaterial& m = cut_.material;
        const double h = m.edge_thickness_mm;
        return {thickness_mm + h, m.r1 * thickness_mm + m.r2 * h,
                m.r3 * thickness_mm + m.r4 * h};
    }

    // Adds a part of an edge on which the chip thickness is smooth.
    void add_part(const EdgeRange& part, double azimuth, double runout_chip,
                  ForceSums& sums) const
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
                const EdgeLoad edge = load(thickness(at, height, runout_chip));
                const double weight = gauss_weight[k] * (to - from) / 2 * radius;
                const double sine = std::sin(at);
                const double cosine = std::cos(at);
                sums.along +=
                    weight * (side * edge.tangential_mm * cosine + edge.radial_mm * sine);
                sums.across +=
                    weight * (edge.radial_mm * cosine - side * edge.tangential_mm * sine);
                sums.axial += weight * edge.axial_mm;
                sums.torque += weight * radius * side * edge.tangential_mm;
            }
    }

    // Splits an engaged range at the corners of the chip thickness and adds the parts.
    void add_range(const EdgeRange& range, double azimuth, double runout_chip,
                   ForceSums& sums) const
    {
        constexpr int samples = 32;
        constexpr int halvings =
            45;  // 2^-45 of a sample's width is far below the accuracy
        const auto kind = [&](double height) {
            const double at = azimuth - height * edge_.tangent();
            const bool has_chip = thickness(at, height, runout_chip) >= 0;
            return (std::sin(at) > 0 ? 2 : 0) + (has_chip ? 1 : 0);
        };
        // Samples are dense at the lower end: near the tip the exact chip grows without
        // bound.
        const auto height_at = [&](double share) {
            return range.from + (range.to - range.from) * share * share;
        };
        double from = range.from;
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
                add_part({from, high}, azimuth, runout_chip, sums);
                from = high;
            }
            last = next;
        }
        add_part({from, range.to}, azimuth, runout_chip, sums);
    }

    MillingCut cut_;
    HelicalEdge edge_;
    double cos_lambda_;
    double sin_lambda_;
};

}  // namespace

CuttingForce mean_force(const CuttingCoefficients& coefficients,
                        const CuttingMaterial& material, const MillingTool& tool,
                        double feed_per_tooth_mm, Milling milling)
{
    require_sound(material);
    require_sound(tool);
    require(std::isfinite(feed_per_tooth_mm) && feed_per_tooth_mm >= 0,
            "mean_force: need a feed per tooth of 0 or more");
    const CuttingCoefficients& mean = coefficients;
    const double s = milling == Milling::Up ? 1 : -1;
    const double f = feed_per_tooth_mm;
    const double h = material.edge_thickness_mm;
    const double scale =
        tool.flutes * tool.radius * material.specific_resistance_n_per_mm2;
    return {scale * (f * (s * mean.I1 + material.r1 * mean.I2) +
                     h * (s * mean.I3 + material.r2 * mean.I4)),
            scale * (f * (material.r1 * mean.I1 - s * mean.I2) +
                     h * (material.r2 * mean.I3 - s * mean.I4)),
            scale * (f * material.r3 * mean.I5 + h * material.r4 * mean.I6),
            s * scale * tool.radius * (f * mean.I7 + h * mean.I8) / mm_per_m};
}

std::vector<CuttingForce> force_profile(const MillingCut& cut,
                                        std::span<const double> turns)
{
    const ForceProfile profile{cut};
    std::vector<CuttingForce> forces;
    forces.reserve(turns.size());
    for (const double turn : turns)
        forces.push_back(profile.at(turn));
    return forces;
}

double peak_factor(const BallEngagement& engagement, ChipModel chip,
                   const MillingTool& tool)
{
    return ForcePattern{engagement, chip, tool}.peak_factor();
}

}  // namespace endmill
