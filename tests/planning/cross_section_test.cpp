// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/cross_section.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

FeedFrame frame_at(const Surface& surface, double u, double v, double side = 1)
{
    return feed_frame({u, v}, surface.jet(u, v), side);
}

// z = height(y) over [-20, 20] in x and y. Passes run along x; u = v = 1/2 is the origin.
Surface ruled_along_x(const test::Polynomial& height)
{
    return test::graph(height, {{-20, 20}, {-20, 20}});
}

TEST(FeedFrame, IsOrthogonalAndPointsTowardsTheNextPass)
{
    for (unsigned seed = 0; seed < 20; ++seed)
        for (const double side : {1.0, -1.0}) {
            const FeedFrame frame = frame_at(test::random_surface(seed), 0.3, 0.7, side);
            Eigen::Matrix3d axes;
            axes << frame.feed, frame.cross_feed, frame.forms.normal;
            EXPECT_LT((axes.transpose() * axes - Eigen::Matrix3d::Identity()).norm(),
                      1e-14);
            EXPECT_GT(frame.feed.dot(frame.jet.du), 0);
            EXPECT_GT(frame.cross_feed.dot(frame.jet.dv), 0);
            EXPECT_GT(side * frame.forms.normal.dot(frame.jet.du.cross(frame.jet.dv)), 0);
            const Vec3 sum = frame.cross.a * frame.jet.du + frame.cross.b * frame.jet.dv;
            EXPECT_LT((sum - frame.cross_feed).norm(), 1e-14);
        }
}

TEST(FeedFrame, IsRefusedAtAPole)
{
    const SurfaceJet pole{Vec3::Zero(), Vec3::Zero(),  Vec3::UnitY(),
                          Vec3::Zero(), Vec3::UnitX(), Vec3::Zero()};
    EXPECT_THROW(feed_frame({0, 0}, pole, 1), GeometryError);
}

TEST(CrossCurvature, OfTheSaddleIsConvexAcrossXAndConcaveAcrossY)
{
    const Surface saddle = test::saddle(32, 40);
    EXPECT_NEAR(cross_curvature(frame_at(saddle, 0.5, 0.5)), 1.0 / 32, 1e-16);
    EXPECT_NEAR(cross_curvature(frame_at(transposed(saddle), 0.5, 0.5, -1)), -1.0 / 32,
                1e-16)
        << "transposed, du x dv points down";
    EXPECT_NEAR(cross_curvature(frame_at(saddle, 0.5, 0.5, -1)), -1.0 / 32, 1e-16);
}

// A cylinder z = bend x^2 / 2 whose passes cross its axis at an angle. Euler's theorem
// gives the curvature across the feed.
TEST(CrossCurvature, OfACylinderCrossedAtAnAngleIsEulers)
{
    constexpr double bend = 0.04;
    for (const double angle : {0.0, 0.3, 1.0, 1.5}) {
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        const Surface cylinder =
            test::polynomial_surface({test::monomial(1, 0, c) + test::monomial(0, 1, -s),
                                      test::monomial(1, 0, s) + test::monomial(0, 1, c),
                                      test::monomial(2, 0, bend * c * c / 2) +
                                          test::monomial(1, 1, -bend * c * s) +
                                          test::monomial(0, 2, bend * s * s / 2)},
                                     {{-10, 10}, {-10, 10}});
        for (const double u : {0.2, 0.5, 0.9}) {
            const FeedFrame frame = frame_at(cylinder, u, 0.4);
            const double slope = bend * frame.jet.point.x();
            const double steep = 1 + slope * slope;
            const Vec3 principal = Vec3{1, 0, slope} / std::sqrt(steep);
            const double cosine = principal.dot(frame.cross_feed);
            EXPECT_NEAR(cross_curvature(frame),
                        -bend / std::pow(steep, 1.5) * cosine * cosine, 1e-16);
        }
    }
}

// [KimChoi, eq. (8)] on the parabola z = y^2 / 40; vectors computed with 50 digits.
TEST(CrossCurvatureByChord, OnAParabolaIsTheTabulatedOne)
{
    const Surface parabola = ruled_along_x(test::monomial(0, 2, 1.0 / 40));
    const FeedFrame bottom = frame_at(parabola, 0.5, 0.5);
    EXPECT_NEAR(cross_curvature_by_chord(parabola, bottom, 0.5), -0.0499921887205124,
                1e-13);
    EXPECT_NEAR(cross_curvature(bottom), -0.05, 1e-16);
    const FeedFrame slope = frame_at(parabola, 0.5, 0.75);
    EXPECT_NEAR(cross_curvature_by_chord(parabola, slope, 0.5), -0.0354578344755912,
                1e-13);
    EXPECT_NEAR(cross_curvature(slope), -0.0357770876399966, 1e-15);
}

TEST(CrossCurvatureByChord, ErrsByAThirdOfTheThirdDerivativeTimesItsStep)
{
    constexpr double k2 = 0.03;
    constexpr double k3 = 0.004;
    const Surface section =
        ruled_along_x(test::monomial(0, 2, k2 / 2) + test::monomial(0, 3, k3 / 6));
    const FeedFrame frame = frame_at(section, 0.5, 0.5);
    for (const double step : {0.1, 0.01, 0.001})
        EXPECT_NEAR(cross_curvature_by_chord(section, frame, step), -k2 - k3 * step / 3,
                    1e-3 * step * step + 1e-9);
}

TEST(CrossCurvatureByChord, TendsToTheExactOneInFirstOrder)
{
    for (unsigned seed = 0; seed < 5; ++seed) {
        const Surface surface = test::random_surface(seed);
        const FeedFrame frame = frame_at(surface, 0.4, 0.6);
        const double exact = cross_curvature(frame);
        const double coarse = cross_curvature_by_chord(surface, frame, 0.02) - exact;
        const double fine = cross_curvature_by_chord(surface, frame, 0.01) - exact;
        EXPECT_NEAR(coarse / fine, 2, 0.1) << seed;
        EXPECT_NEAR(cross_curvature_by_chord(surface, frame, 1e-4), exact, 1e-4);
    }
}

TEST(CheckPlanePoint, LiesInThePlaneAtTheDistance)
{
    test::Random random{1};
    int converged = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
        const Surface surface = test::random_surface(seed, {2, 2}, 2);
        const FeedFrame frame =
            frame_at(surface, random.uniform(0, 2), random.uniform(0, 2));
        const double distance = random.uniform(-8, 8);
        const CheckPlanePoint found = check_plane_point(surface, frame, distance);
        EXPECT_LE(found.iterations, 8);
        if (!found.converged)
            continue;
        ++converged;
        const Vec3 chord =
            surface.tangents(found.at.u, found.at.v).point - frame.jet.point;
        EXPECT_NEAR(chord.dot(frame.feed), 0, 1.01e-12 * surface.diagonal());
        EXPECT_NEAR(chord.dot(frame.cross_feed), distance, 1.01e-12 * surface.diagonal());
    }
    EXPECT_GT(converged, 190);
}

TEST(CheckPlanePoint, OnAPlaneConvergesAtOnceEvenBeyondTheBorder)
{
    const Surface plane = test::parallelogram({200, 0, 0}, {60, 120, 0}, {3, 2});
    const FeedFrame frame = frame_at(plane, 0.1, 1.9);
    const CheckPlanePoint found = check_plane_point(plane, frame, 30);
    EXPECT_TRUE(found.converged);
    EXPECT_LE(found.iterations, 1);
    EXPECT_NEAR(found.at.v, 1.9 + 0.5, 1e-13) << "120 mm wide, 2 patches";
    EXPECT_NEAR(found.at.u, 0.1 - 15 * 3 / 200.0, 1e-13) << "against the shear";
}

TEST(CheckPlanePoint, OnAParabolaIsTheRootOfAQuadratic)
{
    constexpr double bend = 0.05;
    const Surface parabola = ruled_along_x(test::monomial(0, 2, bend / 2));
    for (const double y : {-15.0, 0.0, 12.0})
        for (const double distance : {0.5, 4.0, 9.0}) {
            const CheckPlanePoint found = check_plane_point(
                parabola, frame_at(parabola, 0.5, 0.5 + y / 40), distance);
            ASSERT_TRUE(found.converged);
            // (Y - y) + slope bend (Y^2 - y^2) / 2 = distance sqrt(1 + slope^2)
            const double slope = bend * y;
            const double a = slope * bend / 2;
            const double c = -(y + a * y * y + distance * std::hypot(1, slope));
            const double expected = -2 * c / (1 + std::sqrt(1 - 4 * a * c));
            EXPECT_NEAR(40 * found.at.v - 20, expected, 1e-10) << y << ' ' << distance;
            EXPECT_EQ(found.at.u, 0.5);
        }
}

TEST(CheckPlanePoint, BeyondTheGreatestVEndsTheSearch)
{
    test::Random random{2};
    int left_alone = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
        const Surface surface = test::random_surface(seed, {2, 2}, 2);
        const FeedFrame frame =
            frame_at(surface, random.uniform(0, 2), random.uniform(0, 2));
        const CheckPlanePoint whole = check_plane_point(surface, frame, 4);
        const double most_v = whole.at.v + random.uniform(-0.2, 0.2);
        const CheckPlanePoint found = check_plane_point(surface, frame, 4, most_v);
        if (!whole.converged)
            continue;
        EXPECT_TRUE(found.converged || found.at.v > most_v);
        EXPECT_TRUE(found.converged || whole.at.v > most_v) << "seed " << seed;
        if (found.converged)
            EXPECT_EQ(found.at.v, whole.at.v);
        else
            ++left_alone;
    }
    EXPECT_GT(left_alone, 50);
}

TEST(CheckPlanePoint, AtNoDistanceIsTheContactItself)
{
    const Surface surface = test::random_surface(5);
    const CheckPlanePoint found =
        check_plane_point(surface, frame_at(surface, 0.2, 0.3), 0);
    EXPECT_TRUE(found.converged);
    EXPECT_EQ(found.iterations, 0);
    EXPECT_EQ(found.at.u, 0.2);
    EXPECT_EQ(found.at.v, 0.3);
}

TEST(CheckPlanePoint, ThatDoesNotExistIsTheLinearEstimate)
{
    // z = -y^2: no point of the surface lies 1000 mm uphill from the steep flank at y =
    // 15.
    const Surface ridge = ruled_along_x(test::monomial(0, 2, -1));
    const FeedFrame frame = frame_at(ridge, 0.5, 0.875);
    const CheckPlanePoint found = check_plane_point(ridge, frame, -1000);
    EXPECT_FALSE(found.converged);
    EXPECT_EQ(found.at.u, 0.5 - 1000 * frame.cross.a);
    EXPECT_EQ(found.at.v, 0.875 - 1000 * frame.cross.b);
}

// (120 x, 60 x y, 0): the lines along u are rays from the pole x = 0.
Surface fan()
{
    return test::polynomial_surface(
        {test::monomial(1, 0, 120), test::monomial(1, 1, 60), test::monomial(0, 0, 0)},
        {{0, 1}, {0, 1}});
}

TEST(FeedFrame, AtThePoleOfRaysPointsAlongTheRayAndAllPassesMeet)
{
    const FeedFrame frame = feed_frame({0, 0.5}, fan().jet(0, 0.5), Vec3::UnitZ());
    EXPECT_TRUE(frame.passes_meet);
    EXPECT_LT((frame.feed - Vec3{4, 1, 0}.normalized()).norm(), 1e-14);
    EXPECT_LT((frame.cross_feed - Vec3{-1, 4, 0}.normalized()).norm(), 1e-14);
    EXPECT_FALSE(frame_at(fan(), 0.1, 0.5).passes_meet);
}

TEST(FeedFrame, OnAPassThatIsAPolePointsAlongThePassesBesideIt)
{
    const Surface turned = transposed(fan());  // passes run across the rays
    const FeedFrame frame = feed_frame({0.5, 0}, turned.jet(0.5, 0), Vec3::UnitZ());
    EXPECT_FALSE(frame.passes_meet);
    EXPECT_LT((frame.feed - Vec3::UnitY()).norm(), 1e-14);
    EXPECT_LT((frame.cross_feed - Vec3::UnitX()).norm(), 1e-14);
    const CheckPlanePoint found = check_plane_point(turned, frame, 6);
    EXPECT_TRUE(found.converged);
    EXPECT_NEAR(found.at.v, 6 / 120.0, 1e-12);
}

}  // namespace
}  // namespace endmill
