// SPDX-License-Identifier: GPL-3.0-or-later Changes of the input that must leave the plan
// unchanged, or change it as they change the part.
#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/parallel.h"
#include "endmill/planning/economy.h"
#include "endmill/planning/iso_parametric.h"
#include "planned_path.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr double R = 2;
constexpr test::PatchCounts patches{3, 2};

test::Polynomial some_height()
{
    return test::monomial(2, 0, 0.004) + test::monomial(1, 2, 2e-4) +
           test::monomial(3, 1, 3e-7) + test::monomial(0, 2, -0.006) +
           test::monomial(0, 3, 3e-5);
}

std::vector<Vec3> some_net()
{
    return test::polynomial_net({test::monomial(1, 0, 1) + test::monomial(0, 1, 0.3),
                                 test::monomial(0, 1, 1), some_height()},
                                {{-40, 50}, {-30, 25}}, patches);
}

ToolPath planned(const std::vector<Vec3>& net, const IsoParametricOptions& options,
                 double radius = R)
{
    return plan_iso_parametric(composite_bezier(patches.u, patches.v, net),
                               BallCutter{radius}, options)
        .path;
}

TEST(Invariance, AlongVIsAlongUOnTheTransposedSurfaceToTheBit)
{
    const Surface surface = composite_bezier(patches.u, patches.v, some_net());
    IsoParametricOptions options;
    options.march = March::Alternate;
    options.direction = Parameter::V;
    const ToolPath along_v = plan_iso_parametric(surface, BallCutter{R}, options).path;
    options.direction = Parameter::U;
    ToolPath along_u =
        plan_iso_parametric(transposed(surface), BallCutter{R}, options).path;
    test::swap_parameters(along_u);
    EXPECT_GT(along_v.points.size(), 100U);
    EXPECT_TRUE(test::are_equal(along_v, along_u));
}

TEST(Invariance, ContactsAndLengthsDoNotDependOnTheAxis)
{
    IsoParametricOptions options;
    const ToolPath upright = planned(some_net(), options);
    const PathEconomy expected = path_economy(upright);
    for (const Vec3& axis : {Vec3{0.3, 0, 1}, {-0.2, 0.4, 1}, {0, -0.5, 1}}) {
        options.link.axis = axis.normalized();
        const ToolPath inclined = planned(some_net(), options);
        ASSERT_EQ(inclined.points.size(), upright.points.size());
        const Vec3 shift = R * (Vec3::UnitZ() - options.link.axis);
        for (std::size_t k = 0; k < upright.points.size(); ++k) {
            EXPECT_EQ(test::contact_point(inclined.points[k]),
                      test::contact_point(upright.points[k]));
            EXPECT_LT(
                (inclined.points[k].location.tip - upright.points[k].location.tip - shift)
                    .norm(),
                1e-12)
                << "tips differ by a constant";
        }
        const PathEconomy economy = path_economy(inclined);
        EXPECT_EQ(economy.cut.contact_mm, expected.cut.contact_mm);
        EXPECT_LT(test::relative_error(economy.cut.tip_mm, expected.cut.tip_mm), 1e-12);
        EXPECT_LT(test::relative_error(economy.link.tip_mm, expected.link.tip_mm), 1e-12);
    }
}

TEST(Invariance, ScalesExactlyWithPowersOfTwo)
{
    for (const CrossCurvature cross : {CrossCurvature::Exact, CrossCurvature::Chord}) {
        IsoParametricOptions options;
        options.cross_curvature = cross;
        const ToolPath path = planned(some_net(), options);
        for (const double scale : {0x1p-30, 0x1p17}) {
            std::vector<Vec3> net = some_net();
            for (Vec3& point : net)
                point *= scale;
            IsoParametricOptions scaled_options = options;
            scaled_options.chord_tolerance *= scale;
            scaled_options.scallop_height *= scale;
            scaled_options.cross_step *= scale;
            const ToolPath scaled = planned(net, scaled_options, scale * R);
            ASSERT_EQ(scaled.points.size(), path.points.size());
            for (std::size_t k = 0; k < path.points.size(); ++k) {
                EXPECT_EQ(test::contact_point(scaled.points[k]),
                          scale * test::contact_point(path.points[k]));
                EXPECT_EQ(scaled.points[k].location.tip,
                          scale * path.points[k].location.tip);
                EXPECT_EQ(scaled.points[k].contact()->u, path.points[k].contact()->u);
            }
        }
    }
}

TEST(Invariance, AMirroredPartHasTheMirroredPath)
{
    IsoParametricOptions options;
    const ToolPath path = planned(some_net(), options);
    for (const Vec3& mirror : {Vec3{-1, 1, 1}, {1, -1, 1}}) {
        std::vector<Vec3> net = some_net();
        for (Vec3& point : net)
            point = point.cwiseProduct(mirror);
        const ToolPath mirrored = planned(net, options);
        ASSERT_EQ(mirrored.points.size(), path.points.size());
        for (std::size_t k = 0; k < path.points.size(); ++k)
            EXPECT_EQ(test::contact_point(mirrored.points[k]),
                      test::contact_point(path.points[k]).cwiseProduct(mirror));
    }
}

TEST(Invariance, ATurnedPartHasTheTurnedPath)
{
    const Eigen::AngleAxisd turn{0.4, Vec3{1, -2, 5}.normalized()};
    std::vector<Vec3> net = some_net();
    IsoParametricOptions options;
    const ToolPath path = planned(net, options);
    for (Vec3& point : net)
        point = turn * point;
    options.link.axis = (turn * Vec3::UnitZ()).normalized();
    const ToolPath turned = planned(net, options);
    ASSERT_EQ(turned.points.size(), path.points.size());
    for (std::size_t k = 0; k < path.points.size(); ++k)
        EXPECT_LT(
            (turned.points[k].location.tip - turn * path.points[k].location.tip).norm(),
            1e-8);
}

TEST(Invariance, PathDoesNotDependOnTheDivisionIntoPatches)
{
    const test::Rectangle over{{-40, 50}, {-30, 25}};
    const IsoParametricOptions options;
    const auto planned_on = [&](test::PatchCounts counts) {
        return plan_iso_parametric(test::graph(some_height(), over, counts),
                                   BallCutter{R}, options)
            .path;
    };
    const ToolPath whole = planned_on({1, 1});
    for (const test::PatchCounts counts : {test::PatchCounts{3, 2}, {5, 7}}) {
        const ToolPath cut = planned_on(counts);
        ASSERT_EQ(cut.points.size(), whole.points.size());
        for (std::size_t k = 0; k < whole.points.size(); ++k)
            EXPECT_LT((test::contact_point(cut.points[k]) -
                       test::contact_point(whole.points[k]))
                          .norm(),
                      1e-7);
    }
}

TEST(Invariance, TheSameInputGivesTheSameBitsOnAnyNumberOfThreads)
{
    IsoParametricOptions options;
    options.governing = Governing::DenseMin;
    const ToolPath first = planned(some_net(), options);
    for (const int threads : {1, 2, 5}) {
        set_thread_count(threads);
        EXPECT_TRUE(test::are_equal(planned(some_net(), options), first));
    }
}

}  // namespace
}  // namespace endmill
