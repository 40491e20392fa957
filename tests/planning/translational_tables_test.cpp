// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/translational_tables.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

// A bell-shaped curve of `pieces` pieces over `width`, smooth at the joints, with heights and
// sideways offsets from `random`. The runs below have about 1000 points.
CompositeCurve bell(test::Random& random, int pieces, double width, bool is_along_x)
{
    std::vector<double> heights;
    std::vector<double> offsets;
    for (int i = 0; i <= 3 * pieces; ++i) {
        const double x = i / (3.0 * pieces);
        heights.push_back(1.3 * width * x * (1 - x) + random.uniform(-4, 4));
        offsets.push_back(random.uniform(-3, 3));
    }
    std::vector<Vec3> points;
    for (int i = 0; i <= 3 * pieces; ++i) {
        const double along = width * i / (3.0 * pieces);
        const bool is_joint = i % 3 == 0 && i > 0 && i < 3 * pieces;
        const double z = is_joint ? (heights[i - 1] + heights[i + 1]) / 2 : heights[i];
        const double off = is_joint ? (offsets[i - 1] + offsets[i + 1]) / 2 : offsets[i];
        points.push_back(is_along_x ? Vec3{along, off, z} : Vec3{off, along, z});
    }
    return CompositeCurve{points};
}

TranslationalSurface random_translational_surface(unsigned seed)
{
    test::Random random{seed};
    CompositeCurve a = bell(random, 3, 200, true);
    CompositeCurve b = bell(random, 2, 120, false);
    return {std::move(a), std::move(b)};
}

// The planner plans the same surface as a net of 6 patches, pass by pass.
void expect_runs_of_the_planner(const RunPolicies& policies)
{
    for (const unsigned seed : {1U, 2U, 3U}) {
        const TranslationalSurface surface = random_translational_surface(seed);
        const auto runs = table_runs(surface, policies);
        ASSERT_TRUE(runs.has_value()) << seed;
        const EconomyTables fast = tables_of(*runs);
        const EconomyTables planned = planned_tables(as_surface(surface), policies.table);
        for (const Parameter direction : table_directions)
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) {
                    const auto cell = [&](const EconomyTables& tables,
                                          TableQuantity quantity) {
                        return tables.cell(quantity, direction, i, j);
                    };
                    EXPECT_EQ(cell(fast, TableQuantity::Ncl),
                              cell(planned, TableQuantity::Ncl));
                    const double travel = cell(planned, TableQuantity::Tcd);
                    EXPECT_NEAR(cell(fast, TableQuantity::Tcd), travel, 1e-9 * travel);
                }
    }
}

struct NamedPolicy {
    std::string name;
    std::function<void(RunPolicies&)> set;
};

class TranslationalTablesOfAPolicy : public testing::TestWithParam<NamedPolicy> {};

TEST_P(TranslationalTablesOfAPolicy, AreThoseOfThePlanner)
{
    RunPolicies policies;
    policies.table.scallop_per_tolerance = 0.6;
    GetParam().set(policies);
    expect_runs_of_the_planner(policies);
}

IsoParametricOptions& plan(RunPolicies& policies)
{
    return policies.table.plan;
}

INSTANTIATE_TEST_SUITE_P(
    EachChoice, TranslationalTablesOfAPolicy,
    testing::Values(
        NamedPolicy{"Default", [](RunPolicies&) {}},
        NamedPolicy{"Alternate",
                    [](RunPolicies& p) { plan(p).march = March::Alternate; }},
        NamedPolicy{"AlternateMean",
                    [](RunPolicies& p) {
                        plan(p).march = March::Alternate;
                        plan(p).governing = Governing::Mean;
                    }},
        NamedPolicy{"AlternateFirst",
                    [](RunPolicies& p) {
                        plan(p).march = March::Alternate;
                        plan(p).governing = Governing::First;
                    }},
        NamedPolicy{"DenseMin",
                    [](RunPolicies& p) { plan(p).governing = Governing::DenseMin; }},
        NamedPolicy{"Max", [](RunPolicies& p) { plan(p).governing = Governing::Max; }},
        NamedPolicy{"LastPathNone",
                    [](RunPolicies& p) { plan(p).last_path = LastPath::None; }},
        NamedPolicy{"LastPathHalf",
                    [](RunPolicies& p) { plan(p).last_path = LastPath::Half; }},
        NamedPolicy{"AlternateFreeEnd",
                    [](RunPolicies& p) {
                        plan(p).march = March::Alternate;
                        plan(p).end_point = EndPoint::Free;
                    }},
        NamedPolicy{"StopAtBorders",
                    [](RunPolicies& p) { plan(p).patch_borders = PatchBorders::Stop; }},
        NamedPolicy{"AlternateNormal",
                    [](RunPolicies& p) {
                        plan(p).march = March::Alternate;
                        plan(p).step_curvature = StepCurvature::Normal;
                    }},
        NamedPolicy{"Chord",
                    [](RunPolicies& p) {
                        plan(p).cross_curvature = CrossCurvature::Chord;
                        plan(p).cross_step = 1;
                    }},
        NamedPolicy{"Tips", [](RunPolicies& p) { p.table.distance = TravelKind::Tip; }},
        NamedPolicy{"CutsOnly",
                    [](RunPolicies& p) { p.table.counted = CountedMoves::Cuts; }}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace endmill
