// SPDX-License-Identifier: GPL-3.0-or-later
// The meaning of each option of plan_iso_parametric.
#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/planning/detail/cross_section.h"
#include "endmill/planning/economy.h"
#include "endmill/planning/iso_parametric.h"
#include "endmill/planning/path_interval.h"
#include "planned_path.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

using test::contact_point;
using test::passes_of;

constexpr double R = 5;

// A surface of three by two patches whose curvature across the feed varies along each
// pass.
Surface uneven_surface()
{
    return test::graph(test::monomial(0, 2, 0.01) + test::monomial(1, 2, 2e-4) +
                           test::monomial(2, 0, -0.004) + test::monomial(2, 2, -4e-6),
                       {{-50, 60}, {-30, 30}}, {3, 2});
}

std::vector<std::vector<PathPoint>> planned(const Surface& surface,
                                            const IsoParametricOptions& options)
{
    return passes_of(plan_iso_parametric(surface, BallCutter{R}, options).path);
}

// The candidate of the contact at (u, v) for the next pass. [KimChoi, eq. (8), (9), (10)]
double candidate(const Surface& surface, double u, double v,
                 const IsoParametricOptions& options)
{
    const FeedFrame frame = feed_frame({u, v}, surface.jet(u, v), 1);
    const double k = options.cross_curvature == CrossCurvature::Exact
                         ? cross_curvature(frame)
                         : cross_curvature_by_chord(surface, frame, options.cross_step);
    const PathInterval interval = path_interval(BallCutter{R}, k, options.scallop_height);
    return check_plane_point(surface, frame, interval.projected).at.v;
}

std::vector<double> candidates(const Surface& surface, const std::vector<PathPoint>& pass,
                               const IsoParametricOptions& options)
{
    std::vector<double> found;
    found.reserve(pass.size());
    for (const PathPoint& point : pass)
        found.push_back(
            candidate(surface, point.contact()->u, point.contact()->v, options));
    return found;
}

TEST(Policies, GoverningMinTakesTheSmallestCandidate)
{
    const IsoParametricOptions options;
    const auto passes = planned(uneven_surface(), options);
    for (std::size_t n = 0; n + 2 < passes.size(); ++n)
        EXPECT_NEAR(passes[n + 1][0].contact()->v,
                    std::ranges::min(candidates(uneven_surface(), passes[n], options)),
                    1e-9);
}

TEST(Policies, GoverningMaxTakesTheLargestCandidate)
{
    IsoParametricOptions options;
    options.governing = Governing::Max;
    const auto passes = planned(uneven_surface(), options);
    for (std::size_t n = 0; n + 2 < passes.size(); ++n)
        EXPECT_NEAR(passes[n + 1][0].contact()->v,
                    std::ranges::max(candidates(uneven_surface(), passes[n], options)),
                    1e-9);
}

TEST(Policies, GoverningMeanTakesTheMean)
{
    IsoParametricOptions options;
    options.governing = Governing::Mean;
    const IsoParametricPlan plan =
        plan_iso_parametric(uneven_surface(), BallCutter{R}, options);
    const auto passes = passes_of(plan.path);
    for (std::size_t n = 0; n + 2 < passes.size(); ++n) {
        const auto found = candidates(uneven_surface(), passes[n], options);
        const double mean =
            std::accumulate(found.begin(), found.end(), 0.0) / double(found.size());
        EXPECT_NEAR(passes[n + 1][0].contact()->v, mean, 1e-9);
        EXPECT_FALSE(plan.governing[n]);
    }
}

TEST(Policies, GoverningFirstUsesTheFirstContact)
{
    for (const March march : {March::Forward, March::Alternate}) {
        IsoParametricOptions options;
        options.governing = Governing::First;
        options.march = march;
        const auto passes = planned(uneven_surface(), options);
        for (std::size_t n = 0; n + 2 < passes.size(); ++n) {
            const bool from_far_end = march == March::Alternate && n % 2 == 1;
            EXPECT_NEAR(passes[n + 1][0].contact()->v,
                        candidate(uneven_surface(), from_far_end ? 3 : 0,
                                  passes[n][0].contact()->v, options),
                        1e-9);
        }
    }
}

TEST(Policies, GoverningDenseMinAlsoUsesPlacesBetweenThePoints)
{
    IsoParametricOptions options;
    options.chord_tolerance = 5;  // long steps
    options.governing = Governing::DenseMin;
    const Surface surface = uneven_surface();
    const auto passes = planned(surface, options);
    for (std::size_t n = 0; n + 2 < passes.size(); ++n) {
        const double v = passes[n][0].contact()->v;
        double least = std::ranges::min(candidates(surface, passes[n], options));
        for (int sample = 0; sample <= 48; ++sample)
            least = std::min(least, candidate(surface, sample / 16.0, v, options));
        EXPECT_NEAR(passes[n + 1][0].contact()->v, least, 1e-9);
    }
    options.governing = Governing::Min;
    EXPECT_LE(planned(surface, options).size(), passes.size());
}

// Passes on a plane of `width` mm at intervals of 6 mm.
std::size_t passes_on_plane(double width, LastPath last_path)
{
    IsoParametricOptions options;
    options.scallop_height = 1;
    options.last_path = last_path;
    return planned(test::plane(10, width), options).size();
}

TEST(Policies, LastPathDecidesWhatHappensAtTheBorder)
{
    struct {
        double width;
        std::size_t border, none, half;
    } const cases[] = {{26, 6, 5, 5},    // 2 of 6 mm are left
                       {28, 6, 5, 6},    // 4 of 6 mm
                       {27, 6, 5, 6},    // just half
                       {24, 5, 5, 5},    // the border falls on a pass
                       {3.1, 2, 1, 2}};  // the first pass and a little more than half
    for (const auto& [width, border, none, half] : cases) {
        EXPECT_EQ(passes_on_plane(width, LastPath::Border), border) << width;
        EXPECT_EQ(passes_on_plane(width, LastPath::None), none) << width;
        EXPECT_EQ(passes_on_plane(width, LastPath::Half), half) << width;
    }
}

TEST(Policies, EndPointFreeOmitsTheForcedLastPoint)
{
    const Surface cylinder = test::parabolic_cylinder(0.03, 40, 30, {3, 2});
    IsoParametricOptions options;
    const auto forced = planned(cylinder, options);
    options.end_point = EndPoint::Free;
    const auto free = planned(cylinder, options);
    ASSERT_EQ(free.size(), forced.size());
    for (std::size_t n = 0; n < free.size(); ++n) {
        ASSERT_EQ(free[n].size() + 1, forced[n].size());
        const std::size_t shift = n % 2;  // odd passes are turned round
        for (std::size_t k = 0; k < free[n].size(); ++k)
            EXPECT_LT(
                (contact_point(free[n][k]) - contact_point(forced[n][k + shift])).norm(),
                1e-12)
                << "any point of a pass may govern, they differ by rounding";
    }
}

TEST(Policies, EndPointFreeOnAStraightLineKeepsItsStartAlone)
{
    IsoParametricOptions options;
    options.end_point = EndPoint::Free;
    for (const auto& pass : planned(test::plane(20, 12), options)) {
        ASSERT_EQ(pass.size(), 1U);
        EXPECT_EQ(pass[0].contact()->u, 0);
    }
}

TEST(Policies, StopAtBordersPutsAPointOnEveryBorder)
{
    IsoParametricOptions options;
    options.patch_borders = PatchBorders::Stop;
    for (const EndPoint end_point : {EndPoint::Force, EndPoint::Free}) {
        options.end_point = end_point;
        for (const auto& pass : planned(test::plane(200, 20, {3, 2}), options)) {
            ASSERT_EQ(pass.size(), 4U);
            for (const PathPoint& point : pass)
                EXPECT_EQ(point.contact()->u, std::round(point.contact()->u));
        }
    }
    for (const auto& pass : planned(uneven_surface(), options))
        for (const double border : {0.0, 1.0, 2.0, 3.0})
            EXPECT_TRUE(std::ranges::any_of(pass, [&](const PathPoint& point) {
                return point.contact()->u == border;
            })) << border;
}

TEST(Policies, StepCurvatureDistinguishesGeodesicFromNormalCurvature)
{
    // (x, y + x^2 / 50, 0): curved lines on a plane.
    const Surface plane = test::polynomial_surface(
        {test::monomial(1, 0, 1), test::monomial(0, 1, 1) + test::monomial(2, 0, 0.02),
         test::monomial(0, 0, 0)},
        {{0, 40}, {0, 20}});
    IsoParametricOptions options;
    EXPECT_GT(planned(plane, options)[0].size(), 3U);
    options.step_curvature = StepCurvature::Normal;
    for (const auto& pass : planned(plane, options))
        EXPECT_EQ(pass.size(), 2U);
    const Surface cylinder = test::parabolic_cylinder(0.03, 40, 30);
    const auto by_normal = planned(cylinder, options);
    options.step_curvature = StepCurvature::Curve;
    const auto by_curve = planned(cylinder, options);
    ASSERT_EQ(by_normal[0].size(), by_curve[0].size()) << "its lines are geodesics";
    for (std::size_t k = 0; k < by_curve[0].size(); ++k)
        EXPECT_NEAR(by_normal[0][k].contact()->u, by_curve[0][k].contact()->u, 1e-10);
}

// Every step of a forward pass but the last has the projected length D on the tangent at
// its start; the option selects the curvature from which D follows. [KimChoi, eq. (1),
// (2), (3)]
TEST(Policies, StepCurvatureDeterminesEveryStep)
{
    const Surface surface = uneven_surface();
    IsoParametricOptions options;
    for (const StepCurvature policy : {StepCurvature::Curve, StepCurvature::Normal}) {
        options.step_curvature = policy;
        const auto pass = planned(surface, options)[0];
        ASSERT_GT(pass.size(), 4U);
        for (std::size_t k = 0; k + 2 < pass.size(); ++k) {
            const SurfaceJet jet =
                surface.jet(pass[k].contact()->u, pass[k].contact()->v);
            const double bend =
                policy == StepCurvature::Normal
                    ? std::abs(jet.duu.dot(jet.du.cross(jet.dv).normalized()))
                    : jet.duu.cross(jet.du.normalized()).norm();
            const double cosine =
                1 - options.chord_tolerance * bend / jet.du.squaredNorm();  // of theta
            const double expected =
                2 * std::sqrt(1 - cosine * cosine) * cosine * jet.du.squaredNorm() / bend;
            const Vec3 step = contact_point(pass[k + 1]) - contact_point(pass[k]);
            EXPECT_NEAR(step.dot(jet.du.normalized()), expected, 1e-9) << k;
        }
    }
}

TEST(Policies, MarchAlternateComputesOddPassesFromTheirFarEnd)
{
    // z = x^3 / 6000 has different curvatures at its two ends, and is constant in v.
    const test::Polynomial height = test::monomial(3, 0, 1 / 6000.0);
    const Surface surface = test::graph(height, {{20, 90}, {0, 30}}, {3, 1});
    const Surface turned = test::graph(height, {{90, 20}, {0, 30}}, {3, 1});
    IsoParametricOptions options;
    const auto forward = planned(surface, options);
    const auto backward = planned(turned, options);
    options.march = March::Alternate;
    const auto alternate = planned(surface, options);
    ASSERT_EQ(alternate.size(), forward.size());
    ASSERT_NE(forward[0].size(), 2U);
    for (std::size_t n = 0; n < alternate.size(); ++n) {
        const auto& expected = n % 2 == 0 ? forward[0] : backward[0];
        ASSERT_EQ(alternate[n].size(), expected.size());
        for (std::size_t k = 0; k < expected.size(); ++k)
            EXPECT_NEAR(contact_point(alternate[n][k]).x(),
                        contact_point(expected[k]).x(), 1e-9)
                << "already in cutting order";
    }
}

TEST(Policies, MarchForwardComputesEveryPassAlike)
{
    const Surface surface =
        test::graph(test::monomial(3, 0, 1 / 6000.0), {{20, 90}, {0, 30}}, {3, 1});
    const auto passes = planned(surface, {});
    for (std::size_t n = 1; n < passes.size(); ++n) {
        ASSERT_EQ(passes[n].size(), passes[0].size());
        for (std::size_t k = 0; k < passes[n].size(); ++k) {
            const std::size_t there = n % 2 == 0 ? k : passes[n].size() - 1 - k;
            EXPECT_NEAR(passes[n][there].contact()->u, passes[0][k].contact()->u, 1e-12);
        }
    }
}

TEST(Policies, CrossCurvatureByChordUsesTheChord)
{
    IsoParametricOptions options;
    options.cross_curvature = CrossCurvature::Chord;
    options.cross_step = 2;
    const auto passes = planned(uneven_surface(), options);
    for (std::size_t n = 0; n + 2 < passes.size(); ++n)
        EXPECT_NEAR(passes[n + 1][0].contact()->v,
                    std::ranges::min(candidates(uneven_surface(), passes[n], options)),
                    1e-9);
}

TEST(Policies, CrossCurvatureByChordTendsToTheExactOneInFirstOrder)
{
    const Surface surface = test::graph(
        test::monomial(0, 2, 0.01) + test::monomial(0, 3, 2e-4), {{0, 20}, {-30, 30}});
    IsoParametricOptions options;
    const double exact = planned(surface, options)[1][0].contact()->v;
    options.cross_curvature = CrossCurvature::Chord;
    const auto error = [&](double step) {
        options.cross_step = step;
        return planned(surface, options)[1][0].contact()->v - exact;
    };
    EXPECT_NEAR(error(0.2) / error(0.1), 2, 0.05);
    EXPECT_NEAR(error(1e-3), 0, 1e-6);
}

TEST(Policies, OneWayCutsTheSamePassesForwardsAndLiftsBetweenThem)
{
    IsoParametricOptions options;
    const ToolPath zigzag =
        plan_iso_parametric(uneven_surface(), BallCutter{R}, options).path;
    options.link.order = PassOrder::OneWay;
    options.link.safe_height = 200;
    const ToolPath one_way =
        plan_iso_parametric(uneven_surface(), BallCutter{R}, options).path;
    const PathEconomy there_and_back = path_economy(zigzag);
    const PathEconomy forwards = path_economy(one_way);
    EXPECT_EQ(forwards.ncl, there_and_back.ncl);
    EXPECT_EQ(forwards.passes, there_and_back.passes);
    EXPECT_NEAR(forwards.cut.contact_mm, there_and_back.cut.contact_mm, 1e-8);
    EXPECT_EQ(forwards.link.contact_mm, 0);
    EXPECT_EQ(one_way.points.size(), forwards.ncl + 2 * (forwards.passes - 1));
    for (const auto& pass : passes_of(one_way)) {
        EXPECT_EQ(pass.front().move, Move::Plunge);
        EXPECT_LT(pass.front().contact()->u, pass.back().contact()->u);
    }
    for (const PathPoint& point : one_way.points)
        if (point.move == Move::Rapid || point.move == Move::Retract) {
            EXPECT_NEAR(point.location.tip.z(), 200, 1e-12);
        }
}

}  // namespace
}  // namespace endmill
