// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/table_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

namespace endmill {
namespace {

constexpr SurfaceFamily family = SurfaceFamily::Translational;

// Two arches of about the size of the paper's part, and h / delta.
const std::vector<double> wave{60, 100, 130, 128, 100, 55, 2, 40, 65, 66, 42, -3, 0.5};

RunPolicies alternate()
{
    RunPolicies policies;
    policies.table.plan.march = March::Alternate;
    return policies;
}

// The numbers that a faultless interpretation of the cells of `values` has.
DecodedTables decoding_of(std::span<const double> values, RunPolicies policies)
{
    policies.table.scallop_per_tolerance = values.back();
    const FamilyMember member = family_surface(family, values.first(values.size() - 1));
    const auto& surface = std::get<TranslationalSurface>(member);
    DecodedTables decoded{};
    for (int k = 0; k < 2; ++k) {
        const auto march =
            march_both_ways(k == 0 ? surface.along_u : surface.along_v).value();
        for (int i = 0; i < 3; ++i)
            decoded.passes[k][i] = {march[i].points_forward + march[i].points_backward,
                                    march[i].points_forward,
                                    (march[i].forward_mm + march[i].backward_mm) / 2,
                                    0.3};
    }
    visit_runs(member, policies, [&](const RunPlace& at, const TableRun& run) {
        decoded.counts[at.direction][at.tolerance][at.diameter] = run.passes;
        return true;
    });
    return decoded;
}

TEST(TableSearch, LossIsZeroExactlyOnItsOwnCells)
{
    const EconomyTables cells = fitted_tables(family, alternate(), wave).value();
    EXPECT_EQ(table_loss(family, alternate(), cells, wave, 1e9), 0);
    std::vector<double> other = wave;
    other[3] += 1;
    EXPECT_GT(table_loss(family, alternate(), cells, other, 1e9), 10);
    EXPECT_GT(table_loss(family, alternate(), cells, other, 5), 5);
}

TEST(TableSearch, TakesTheRatioOfScallopAndTolerance)
{
    RunPolicies policies = alternate();
    policies.table.scallop_per_tolerance = wave.back();
    const Surface surface = as_surface(
        family_surface(family, std::span<const double>{wave}.first(wave.size() - 1)));
    const EconomyTables planned = planned_tables(surface, policies.table);
    const EconomyTables fitted = fitted_tables(family, alternate(), wave).value();
    EXPECT_EQ(fitted.runs[1][2][0].ncl, planned.runs[1][2][0].ncl);
    EXPECT_NEAR(fitted.runs[1][2][0].tcd_mm, planned.runs[1][2][0].tcd_mm, 1e-4);
}

TEST(TableSearch, StartsWithCurvesThatHaveTheirNumbers)
{
    const DecodedTables decoded = decoding_of(wave, alternate());
    const StagedSearch search{
        .curves = 2, .curve_searches = 60, .accepted_curve_loss = 0, .most_height = 150};
    for (int k = 0; k < 2; ++k) {
        const auto curves = search_curves(family, k, decoded.passes[k], search);
        EXPECT_FALSE(curves.empty());
        for (const std::vector<double>& values : curves) {
            const CompositeCurve curve = family_curve(family, k, values);
            EXPECT_EQ(curve_matches(march_both_ways(curve).value(), decoded.passes[k]),
                      9);
            EXPECT_LE(height_of(curve), search.most_height + 1e-9);
        }
    }
}

// A curve over x with these heights above 0, 1/9, ... of 200 mm.
CompositeCurve curve_with_heights(const std::vector<double>& free_heights)
{
    return family_curve(family, 0, free_heights);
}

TEST(TableSearch, DrawsOnlyCurvesThatCouldBeTheOnesOfTheTables)
{
    // The arch of `wave`: it bends to one side only.
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
TEST(TableSearch, MeasuresTheConcavityOfACurve)
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

TEST(TableSearch, SplitsTheValuesBetweenTheCurves)
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

TEST(TableSearch, InStagesComesNearThePlantedCells)
{
    const EconomyTables cells = fitted_tables(family, alternate(), wave).value();
    const StagedSearch search{.curves = 4,
                              .curve_searches = 20,
                              .curve_evaluations = 2000,
                              .scored = 16,
                              .fitted = 1,
                              .refined = 1,
                              .evaluations = 300};
    const StagedFit fit = search_in_stages(family, alternate(), cells,
                                           decoding_of(wave, alternate()), search);
    ASSERT_FALSE(fit.best.values.empty());
    const TableMatch match =
        table_match(fitted_tables(family, alternate(), fit.best.values).value(), cells);
    EXPECT_LT(match.rms_percent, 5);
    const StagedFit again = search_in_stages(family, alternate(), cells,
                                             decoding_of(wave, alternate()), search);
    EXPECT_EQ(fit.best.values, again.best.values);
}

TEST(TableSearch, ByCellsIsRepeatable)
{
    const EconomyTables cells = fitted_tables(family, alternate(), wave).value();
    const BoundedSearch search{.evaluations = 150, .seed = 3};
    const TableFit fit = search_cells(family, alternate(), cells, search);
    EXPECT_EQ(fit.values, search_cells(family, alternate(), cells, search).values);
    EXPECT_EQ(fit.evaluations, 150);
}

}  // namespace
}  // namespace endmill
