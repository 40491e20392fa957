// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/curve_search.h"

#include <algorithm>
#include <array>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

namespace endmill {
namespace {

constexpr SurfaceFamily family = SurfaceFamily::Translational;

// The numbers that a curve has, with its lengths within 0.3 mm.
CurveTarget target_of(const CompositeCurve& curve)
{
    const auto march = march_both_ways(curve).value();
    CurveTarget target{};
    for (int i = 0; i < 3; ++i)
        target[i] = {march[i].points_forward + march[i].points_backward,
                     march[i].points_forward,
                     (march[i].forward_mm + march[i].backward_mm) / 2, 0.3};
    return target;
}

TEST(CurveSearch, FindsCurvesThatHaveAllNumbers)
{
    const CurveSearch search{
        .wanted = 2, .searches = 60, .accepted_loss = 0, .most_height = 150};
    const std::array arches{std::vector<double>{60, 100, 130, 128, 100, 55, 2},
                            std::vector<double>{40, 65, 66, 42, -3}};
    for (int k = 0; k < 2; ++k) {
        const CurveTarget target = target_of(family_curve(family, k, arches[k]));
        const auto curves = search_curves(family, k, target, search);
        EXPECT_FALSE(curves.empty());
        for (const std::vector<double>& values : curves) {
            const CompositeCurve curve = family_curve(family, k, values);
            EXPECT_EQ(curve_matches(march_both_ways(curve).value(), target), 9);
            EXPECT_LE(height_of(curve), search.most_height + 1e-9);
        }
    }
}

// A curve over x with these heights above 0, 1/9, ... of 200 mm.
CompositeCurve curve_with_heights(const std::vector<double>& free_heights)
{
    return family_curve(family, 0, free_heights);
}

TEST(CurveSearch, DrawsOnlyCurvesThatCouldBeTheOnesOfTheTables)
{
    // An arch bends to one side only.
    const CompositeCurve arch = curve_with_heights({60, 100, 130, 128, 100, 55, 2});
    EXPECT_TRUE(is_plausible(arch, 200));
    EXPECT_FALSE(is_plausible(arch, 100));  // it is higher
    // Turned over, its bend of radius 20 mm or so is a trough, still wider than the limit of 4 mm.
    EXPECT_TRUE(
        is_plausible(curve_with_heights({-60, -100, -130, -128, -100, -55, -2}), 200));
    // A trough with a radius below 4 mm.
    EXPECT_FALSE(is_plausible(curve_with_heights({0, -170, -170, 170, 170, 0, 0}), 400));
}

// The parabola z = c x^2 / 2 has the curvature c at its vertex; turned over it is convex.
TEST(CurveSearch, MeasuresTheConcavityOfACurve)
{
    const double c = 0.05;
    const auto parabola = [](double bend) {
        // Control points of z = bend x^2 / 2 over -30 to 30.
        return CompositeCurve{{{-30, 0, 450 * bend},
                               {-10, 0, -150 * bend},
                               {10, 0, -150 * bend},
                               {30, 0, 450 * bend}}};
    };
    EXPECT_NEAR(concavity_of(parabola(c)), c, 1e-12);
    EXPECT_EQ(concavity_of(parabola(-c)), 0);
    EXPECT_NEAR(height_of(parabola(c)), 450 * c, 1e-12);
}

TEST(CurveSearch, SplitsTheValuesBetweenTheCurves)
{
    for (const SurfaceFamily each :
         {SurfaceFamily::Translational, SurfaceFamily::Uneven, SurfaceFamily::Skew}) {
        const std::vector<Interval> ranges = value_ranges(each);
        std::vector<int> used(ranges.size(), 0);
        for (int k = 0; k < 2; ++k)
            for (const std::size_t position : curve_positions(each, k))
                ++used[position];
        EXPECT_EQ(used, std::vector<int>(ranges.size(), 1));
        // A value of A moves A and not B.
        std::vector<double> values(ranges.size(), 0.0);
        values[curve_positions(each, 0).back()] = 5;
        const FamilyMember member = family_surface(each, values);
        const auto& surface = std::get<TranslationalSurface>(member);
        const FamilyMember flat =
            family_surface(each, std::vector<double>(ranges.size(), 0.0));
        const auto& even = std::get<TranslationalSurface>(flat);
        const auto differs = [](const CompositeCurve& one, const CompositeCurve& other) {
            double most = 0;
            for (std::size_t i = 0; i < one.points().size(); ++i)
                most = std::max(most, (one.points()[i] - other.points()[i]).norm());
            return most > 0;
        };
        EXPECT_TRUE(differs(surface.along_u, even.along_u));
        EXPECT_FALSE(differs(surface.along_v, even.along_v));
    }
}

}  // namespace
}  // namespace endmill
