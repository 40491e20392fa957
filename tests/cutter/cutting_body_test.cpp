// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/cutting_body.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "random.h"

namespace endmill {
namespace {

std::vector<CuttingBody> bodies()
{
    return {CuttingBody{Cutter::ball(5)},      CuttingBody{Cutter::flat(5)},
            CuttingBody{Cutter{5, 2}},         CuttingBody{Cutter::ball(5), 12},
            CuttingBody{Cutter::flat(5), 12},  CuttingBody{Cutter{5, 2}, 12},
            CuttingBody{Cutter::flat(0.5), 8}, CuttingBody{Cutter{3, 2.9}, 3}};
}

Vec3 random_place(test::Random& random)
{
    return {random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-6, 16)};
}

// The distance from the surface of revolution, by many points of its profile. The upper
// end is left out.
double sampled_distance(const Cutter& cutter, const Vec3& place)
{
    const double d = place.head<2>().norm();
    double least = 1e9;
    for (int i = 0; i <= 20'000; ++i) {
        const double a = i / 20'000.0;
        const double turn = a * std::acos(0.0);
        const double r = cutter.corner_radius();
        least = std::min({least, std::hypot(d - a * cutter.flat_radius(), place.z()),
                          std::hypot(d - cutter.flat_radius() - r * std::sin(turn),
                                     place.z() - r + r * std::cos(turn)),
                          std::hypot(d - cutter.radius(), place.z() - r - a * 40)});
    }
    const double height = d < cutter.radius() ? cutter.profile(d) : 1e9;
    return place.z() > height ? -least : least;
}

TEST(CuttingBody, DistanceIsThatFromSamplesOfTheSurface)
{
    test::Random random{1};
    for (const Cutter& cutter : {Cutter::ball(5), Cutter::flat(5), Cutter{5, 2}})
        for (int i = 0; i < 50; ++i) {
            const Vec3 place = random_place(random);
            EXPECT_NEAR(CuttingBody{cutter}.distance(place).value,
                        sampled_distance(cutter, place), 2e-3);
        }
}

TEST(CuttingBody, DistanceIsConvexAndLipschitz)
{
    test::Random random{2};
    for (const CuttingBody& body : bodies())
        for (int i = 0; i < 2000; ++i) {
            const Vec3 a = random_place(random);
            const Vec3 b = random_place(random);
            const double t = random.uniform(0, 1);
            const double at_a = body.distance(a).value;
            const double at_b = body.distance(b).value;
            EXPECT_LE(body.distance((1 - t) * a + t * b).value,
                      (1 - t) * at_a + t * at_b + 1e-12);
            EXPECT_LE(std::abs(at_a - at_b), (a - b).norm() + 1e-12);
            const auto here = body.distance(a);
            EXPECT_LE(here.gradient.norm(), 1 + 1e-12);
            EXPECT_LE(here.value + here.gradient.dot(b - a), at_b + 1e-11);
        }
}

TEST(CuttingBody, NothingOutsideANearStretchIsNear)
{
    test::Random random{7};
    int found = 0;
    for (const CuttingBody& body : bodies())
        for (int i = 0; i < 2000; ++i) {
            const Vec3 start = random_place(random);
            const Vec3 end = random_place(random);
            // upright and level lines too
            Vec3 direction = end - start;
            if (i % 10 == 0)
                direction = {0, 0, 1};
            if (i % 10 == 1)
                direction.z() = 0;
            const double within = i % 3 == 0 ? 0 : random.uniform(0, 1);
            const auto near = body.near_stretch(start, direction, within);
            found += near ? 1 : 0;
            for (int k = -100; k <= 100; ++k) {
                const double s = k / 20.0;
                if (near && near->from <= s && s <= near->to)
                    continue;
                ASSERT_GT(body.distance(start + s * direction).value, within);
            }
            // The ends of a ball's stretch are as far away as asked.
            if (near && body.cutter().is_ball() && std::isinf(body.length()) &&
                within > 0 && near->from > -5) {
                EXPECT_NEAR(body.distance(start + near->from * direction).value, within,
                            1e-6);
            }
        }
    EXPECT_GT(found, 4000);
}

TEST(CuttingBody, LeastOnASegmentIsThatOfDenseSamples)
{
    test::Random random{3};
    for (const CuttingBody& body : bodies())
        for (int i = 0; i < 300; ++i) {
            const Vec3 from = random_place(random);
            const Vec3 to = i % 3 == 0
                                ? from + random.uniform(0, 2) * Vec3::UnitX()
                                : (i % 3 == 1 ? random_place(random)
                                              : Vec3{from + 0.1 * random_place(random)});
            const CuttingBody::Least least = body.least_on_segment(from, to);
            double sampled = 1e9;
            for (int k = 0; k <= 400; ++k)
                sampled = std::min(sampled,
                                   body.distance(from + k / 400.0 * (to - from)).value);
            EXPECT_LE(least.lower, sampled + 1e-12);
            EXPECT_LE(least.value, sampled + 1e-8);
            EXPECT_GE(least.value, sampled - (to - from).norm() / 800 - 1e-12);
            EXPECT_LE(least.value - least.lower, 1.1e-8);
            EXPECT_NEAR(body.distance(from + least.at * (to - from)).value, least.value,
                        1e-12);
        }
}

// Above the middle of the ball the distance from the axis counts, below that from the middle.
TEST(CuttingBody, LeastAlongTheAxisIsAtTheUpperEnd)
{
    const CuttingBody ball{Cutter::ball(5)};
    for (const double x : {0.0, 3.0, 7.0})
        for (const auto& [from, to] : {std::pair{-4.0, 1.0}, std::pair{1.0, -4.0},
                                       std::pair{2.0, 9.0}, std::pair{9.0, 2.0}}) {
            const CuttingBody::Least least =
                ball.least_on_segment({x, 0, from}, {x, 0, to});
            EXPECT_NEAR(least.value,
                        std::hypot(x, std::min(0.0, std::max(from, to) - 5)) - 5, 1e-12);
        }
}

TEST(CuttingBody, GradientBoundsTheLeastOfAMovedSegment)
{
    test::Random random{4};
    for (const CuttingBody& body : bodies())
        for (int i = 0; i < 500; ++i) {
            const Vec3 from = random_place(random);
            const Vec3 to = from + 0.3 * random_place(random);
            const Vec3 moved = 0.2 * random_place(random);
            const CuttingBody::Least least = body.least_on_segment(from, to);
            EXPECT_LE(least.lower + least.gradient.dot(moved),
                      body.least_on_segment(from + moved, to + moved).value + 1e-11);
        }
}

TEST(CuttingBody, EarlyEndStillBoundsFromBelow)
{
    test::Random random{5};
    for (const CuttingBody& body : bodies())
        for (int i = 0; i < 200; ++i) {
            const Vec3 from = random_place(random);
            const Vec3 to = random_place(random);
            const double least = body.least_on_segment(from, to).value;
            const CuttingBody::Least early =
                body.least_on_segment(from, to, least - random.uniform(0, 1));
            EXPECT_LE(early.lower, least + 1e-12);
        }
}

TEST(CuttingBody, SupportIsTheLeastOverSamples)
{
    test::Random random{6};
    for (const CuttingBody& body :
         {CuttingBody{Cutter::ball(5), 12}, CuttingBody{Cutter::flat(5), 12},
          CuttingBody{Cutter{5, 2}, 12}})
        for (int i = 0; i < 50; ++i) {
            const Vec3 w = random_place(random).normalized();
            const Cutter& cutter = body.cutter();
            double least = 1e9;
            for (int k = 0; k <= 4000; ++k) {
                const double turn = k / 4000.0 * std::acos(0.0);
                const double d =
                    cutter.flat_radius() + cutter.corner_radius() * std::sin(turn);
                const double h = cutter.corner_radius() * (1 - std::cos(turn));
                least = std::min({least, w.z() * h - d * w.head<2>().norm(),
                                  w.z() * 12 - 5 * w.head<2>().norm()});
            }
            EXPECT_NEAR(body.support(w), least, 1e-5);
        }
    EXPECT_EQ(CuttingBody{Cutter::flat(5)}.support({0, 0, 1}), 0);
    EXPECT_TRUE(std::isinf(CuttingBody{Cutter::flat(5)}.support({0.8, 0, -0.6})));
}

TEST(CuttingBody, RefusesALengthBelowTheCorner)
{
    EXPECT_THROW((CuttingBody{Cutter::ball(5), 4}), DomainError);
    EXPECT_THROW((CuttingBody{Cutter::flat(5), 0}), DomainError);
    EXPECT_NO_THROW((CuttingBody{Cutter::ball(5), 5}));
}

}  // namespace
}  // namespace endmill
