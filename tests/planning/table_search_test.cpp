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

TEST(TableSearch, InStagesComesNearThePlantedCells)
{
    const EconomyTables cells = fitted_tables(family, alternate(), wave).value();
    const StagedSearch search{
        .curves = {.wanted = 4, .searches = 20, .evaluations = 2000},
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
