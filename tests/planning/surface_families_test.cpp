// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/surface_families.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/planning/detail/portable_uniform.h"
#include "endmill/surface/bezier_patch.h"
#include "endmill/surface/continuity.h"

namespace endmill {
namespace {

// Random values within `share` of the ranges.
std::vector<double> random_values(SurfaceFamily family, std::uint32_t seed,
                                  double share = 0.3)
{
    PortableUniform uniform{seed};
    std::vector<double> values;
    for (const auto [low, high] : value_ranges(family)) {
        const double middle = (low + high) / 2;
        const double half = share * (high - low) / 2;
        values.push_back(uniform(middle - half, middle + half));
    }
    return values;
}

class EachFamily : public testing::TestWithParam<SurfaceFamily> {};

TEST_P(EachFamily, HasSixPatchesThatJoinWithOneTangent)
{
    const Surface surface =
        as_surface(family_surface(GetParam(), random_values(GetParam(), 3)));
    EXPECT_EQ(surface.patches(Parameter::U), 3);
    EXPECT_EQ(surface.patches(Parameter::V), 2);
    for (int border = 1; border < 3; ++border)
        for (const double v : {0.0, 0.3, 0.9}) {
            const SurfaceJet left = surface.jet_in_patch(border - 1, 0, border, v);
            const SurfaceJet right = surface.jet_in_patch(border, 0, border, v);
            EXPECT_NEAR((left.point - right.point).norm(), 0, 1e-11);
            EXPECT_NEAR((left.du - right.du).norm(), 0, 1e-10);
        }
    for (const double u : {0.1, 1.7, 2.9}) {
        const int i = surface.patch_number(Parameter::U, u);
        const SurfaceJet below = surface.jet_in_patch(i, 0, u, 1);
        const SurfaceJet above = surface.jet_in_patch(i, 1, u, 1);
        EXPECT_NEAR((below.point - above.point).norm(), 0, 1e-11);
        EXPECT_NEAR((below.dv - above.dv).norm(), 0, 1e-10);
    }
}

TEST_P(EachFamily, HasTheSizeOfThePart)
{
    const SurfaceFamily family = GetParam();
    const Surface surface = as_surface(family_surface(family, random_values(family, 4)));
    const auto at = [&](double u, double v) { return surface.tangents(u, v).point; };
    if (family != SurfaceFamily::Skew) {
        EXPECT_NEAR(at(3, 0).x() - at(0, 0).x(), 200, 1e-10);
    }
    if (family != SurfaceFamily::Skew && family != SurfaceFamily::Revolution) {
        EXPECT_NEAR(at(0, 2).y() - at(0, 0).y(), 120, 1e-10);
    }
}

TEST_P(EachFamily, IsFoundByItsName)
{
    EXPECT_EQ(family_named(family_name(GetParam())), GetParam());
}

INSTANTIATE_TEST_SUITE_P(All, EachFamily, testing::ValuesIn(surface_families),
                         [](const auto& test) {
                             return std::string{family_name(test.param)};
                         });

TEST(SurfaceFamilies, RefuseAnUnknownName)
{
    EXPECT_THROW(family_named("wave"), DomainError);
}

TEST(SurfaceFamilies, TranslationalPassesAreCongruent)
{
    for (const SurfaceFamily family :
         {SurfaceFamily::Translational, SurfaceFamily::Uneven, SurfaceFamily::Skew}) {
        const Surface surface =
            as_surface(family_surface(family, random_values(family, 5)));
        const auto at = [&](double u, double v) { return surface.tangents(u, v).point; };
        for (const double u : {0.4, 1.5, 3.0})
            for (const double v : {0.2, 1.0, 1.9}) {
                const Vec3 moved = at(u, v) - at(0, v);
                EXPECT_NEAR((moved - (at(u, 0) - at(0, 0))).norm(), 0, 1e-10);
            }
    }
}

TEST(SurfaceFamilies, SymmetricIsItsOwnMirrorImage)
{
    const Surface surface = as_surface(family_surface(
        SurfaceFamily::Symmetric, random_values(SurfaceFamily::Symmetric, 6)));
    for (const double u : {0.3, 1.2})
        for (const double v : {0.1, 0.8}) {
            const double z = surface.tangents(u, v).point.z();
            EXPECT_NEAR(surface.tangents(3 - u, v).point.z(), z, 1e-10);
            EXPECT_NEAR(surface.tangents(u, 2 - v).point.z(), z, 1e-10);
        }
}

TEST(SurfaceFamilies, FergusonHasNoTwists)
{
    const Surface surface = as_surface(family_surface(
        SurfaceFamily::Ferguson, random_values(SurfaceFamily::Ferguson, 7)));
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 3; ++i)
            for (const double u : {0.0, 1.0})
                for (const double v : {0.0, 1.0})
                    EXPECT_NEAR(surface.patch(i, j).jet(u, v).duv.norm(), 0, 1e-9);
}

TEST(SurfaceFamilies, TensHasHeightsInWholeTens)
{
    const std::vector<double> values(12, 14.0);
    const FamilyMember rounded = family_surface(SurfaceFamily::Tens, values);
    const FamilyMember ten =
        family_surface(SurfaceFamily::Translational, std::vector(12, 10.0));
    EXPECT_NEAR((as_surface(rounded).tangents(1.3, 0.4).point -
                 as_surface(ten).tangents(1.3, 0.4).point)
                    .norm(),
                0, 1e-12);
}

TEST(SurfaceFamilies, RevolutionKeepsItsRadius)
{
    std::vector<double> values(9, 0.0);
    values[0] = 100;
    values[8] = 1.2;
    const Surface surface = as_surface(family_surface(SurfaceFamily::Revolution, values));
    for (const double v : {0.0, 0.4, 1.0, 1.6, 2.0}) {
        const Vec3 point = surface.tangents(1.4, v).point;
        EXPECT_NEAR(std::hypot(point.y(), point.z()), 100, 0.03);
    }
}

TEST(SurfaceFamilies, RuledHasStraightLines)
{
    const Surface surface = as_surface(
        family_surface(SurfaceFamily::Ruled, random_values(SurfaceFamily::Ruled, 8)));
    const Vec3 front = surface.tangents(0.7, 0).point;
    const Vec3 back = surface.tangents(0.7, 2).point;
    EXPECT_NEAR((surface.tangents(0.7, 1).point - (front + back) / 2).norm(), 0, 1e-10);
}

// The same runs by the two ways of visit_runs.
TEST(SurfaceFamilies, RunsAreThoseOfThePlanner)
{
    const SurfaceFamily family = SurfaceFamily::Uneven;
    const FamilyMember two_curves = family_surface(family, random_values(family, 9));
    const FamilyMember net = as_surface(two_curves);
    RunPolicies policies;
    policies.table.plan.march = March::Alternate;
    std::vector<TableRun> runs;
    const auto keep = [&](const RunPlace&, const TableRun& run) {
        runs.push_back(run);
        return runs.size() % 18 != 0;
    };
    ASSERT_TRUE(visit_runs(two_curves, policies, keep));
    ASSERT_TRUE(visit_runs(net, policies, keep));
    ASSERT_EQ(runs.size(), 36U);
    for (int i = 0; i < 18; ++i) {
        EXPECT_EQ(runs[i].passes, runs[18 + i].passes);
        EXPECT_EQ(runs[i].cost.ncl, runs[18 + i].cost.ncl);
        EXPECT_NEAR(runs[i].cost.tcd_mm, runs[18 + i].cost.tcd_mm, 1e-4);
    }
}

}  // namespace
}  // namespace endmill
