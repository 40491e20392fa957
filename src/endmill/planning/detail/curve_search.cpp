// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/curve_search.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "endmill/planning/detail/bounded_search.h"
#include "endmill/planning/detail/portable_uniform.h"

namespace endmill {
namespace {

// Penalties of a millimetre of height beyond the limit, and of a concavity of twice the limit; both grow with the
// square.
constexpr double height_weight = 0.01;
constexpr double concavity_weight = 10;
// A ball of 20 mm fits a concavity of 0.1 / mm; seen across a steep pass a curve is flatter.
constexpr double most_concavity = 0.25;  // 1/mm
constexpr int height_samples = 30;       // a piece
// Random curves are drawn in this share of the ranges, and searched in boxes with sides of the second share.
constexpr double drawn_share = 0.6;
constexpr double curve_box = 0.3;
constexpr int most_draws = 100'000;
// A search for a curve ends at this share of the loss with which it is taken.
constexpr double enough_share = 0.1;
constexpr int population = 20;

}  // namespace

std::vector<std::size_t> curve_positions(SurfaceFamily family, int curve)
{
    // Runs of values: those of A, those of B, and again where the family has more.
    std::vector<std::size_t> lengths{7, 5};
    if (family == SurfaceFamily::Uneven)
        lengths.insert(lengths.end(), {6, 4});
    if (family == SurfaceFamily::Skew)
        lengths.insert(lengths.end(), {7, 5});
    std::vector<std::size_t> own;
    std::size_t first = 0;
    for (std::size_t k = 0; k < lengths.size(); ++k) {
        for (std::size_t i = 0; i < lengths[k]; ++i)
            if (static_cast<int>(k % 2) == curve)
                own.push_back(first + i);
        first += lengths[k];
    }
    return own;
}

CompositeCurve family_curve(SurfaceFamily family, int curve,
                            std::span<const double> values)
{
    const std::vector<std::size_t> positions = curve_positions(family, curve);
    std::vector<double> all(value_ranges(family).size(), 0.0);
    for (std::size_t i = 0; i < positions.size(); ++i)
        all[positions[i]] = values[i];
    const FamilyMember member = family_surface(family, all);
    const auto& surface = std::get<TranslationalSurface>(member);
    return curve == 0 ? surface.along_u : surface.along_v;
}

double height_of(const CompositeCurve& curve)
{
    double low = curve.point(0).z();
    double high = low;
    for (int i = 0; i <= height_samples * curve.pieces(); ++i) {
        const double z = curve.point(i / double(height_samples)).z();
        low = std::min(low, z);
        high = std::max(high, z);
    }
    return high - low;
}

double concavity_of(const CompositeCurve& curve)
{
    double most = 0;
    for (int i = 0; i <= height_samples * curve.pieces(); ++i) {
        const CurveJet jet = curve.jet(i / double(height_samples));
        const double speed2 = jet.first.squaredNorm();
        const Vec3 up = Vec3::UnitZ() - jet.first.z() / speed2 * jet.first;
        most = std::max(most, jet.second.dot(up) / (speed2 * up.norm()));
    }
    return most;
}

bool is_plausible(const CompositeCurve& curve, double most_height)
{
    if (concavity_of(curve) > most_concavity || height_of(curve) > most_height)
        return false;
    const auto march = march_both_ways(curve);
    return march && has_regular_passes(*march);
}

std::vector<std::vector<double>> search_curves(SurfaceFamily family, int curve,
                                               const CurveTarget& target,
                                               const CurveSearch& search)
{
    const std::vector<Interval> all_ranges = value_ranges(family);
    std::vector<Interval> ranges;
    for (const std::size_t position : curve_positions(family, curve))
        ranges.push_back(all_ranges[position]);
    const auto loss = [&](std::span<const double> values, double give_up) {
        const CompositeCurve trial = family_curve(family, curve, values);
        const double excess = std::max(0.0, height_of(trial) - search.most_height);
        const double tight = std::max(0.0, concavity_of(trial) / most_concavity - 1);
        const double penalty =
            height_weight * excess * excess + concavity_weight * tight * tight;
        return penalty + curve_loss(trial, target, give_up - penalty);
    };
    PortableUniform uniform{search.seed};
    const auto drawn = [&] {
        std::vector<double> values;
        values.reserve(ranges.size());
        for (const auto [low, high] : ranges)
            values.push_back(uniform(std::lerp(low, high, (1 - drawn_share) / 2),
                                     std::lerp(low, high, (1 + drawn_share) / 2)));
        return values;
    };
    std::vector<std::vector<double>> curves;
    int draws = 0;
    for (int i = 0;
         i < search.searches && static_cast<int>(curves.size()) < search.wanted; ++i) {
        std::vector<double> start = drawn();
        while (!is_plausible(family_curve(family, curve, start), search.most_height)) {
            if (++draws > most_draws)
                return curves;
            start = drawn();
        }
        draws = 0;
        FoundValues best = minimise(box_about(start, ranges, curve_box), loss,
                                    {.evaluations = search.evaluations,
                                     .seed = search.seed + static_cast<std::uint32_t>(i),
                                     .population = population,
                                     .enough = enough_share * search.accepted_loss,
                                     .start = {start}});
        if (best.loss <= search.accepted_loss)
            curves.push_back(std::move(best.values));
    }
    return curves;
}

}  // namespace endmill
