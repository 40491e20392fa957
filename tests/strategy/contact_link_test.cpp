// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/contact_link.h"

#include <gtest/gtest.h>

#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr MoveLimits link_limits{0.4, 0.005};

TEST(ContactLink, HasEqualStepsOfTheSamplesDistanceOnAPlane)
{
    const Part plane = std::vector<Surface>{test::plane(20, 10)};
    const CoveredPart part{plane, BallCutter{5}, {0.01, 0.5}};
    const PartSamples samples = part.samples(1, 100'000);
    const auto steps = steps_along(samples.contact({0.2, 0.3}, 0),
                                   samples.contact({0.4, 0.6}, 0), samples);
    ASSERT_EQ(steps.size(), 6u) << "5 mm in steps of 1 mm";
    for (std::size_t k = 0; k < steps.size(); ++k)
        EXPECT_NEAR(
            (steps[k].at.contact.point - Vec3(4 + 0.8 * k, 3 + 0.6 * k, 0)).norm(), 0,
            1e-9);
}

TEST(ContactLink, IsOneMoveOnAPlane)
{
    const Part plane = std::vector<Surface>{test::plane(20, 10)};
    const CoveredPart part{plane, BallCutter{5}, {0.01, 0.5}};
    const PartSamples samples = part.samples(1, 100'000);
    const PassContact from = samples.contact({0.2, 0.3}, 0);
    const PassContact to = samples.contact({0.4, 0.8}, 0);
    const auto link = contact_link(from, to, samples, part, link_limits);
    ASSERT_TRUE(link);
    ASSERT_EQ(link->size(), 2u);
    EXPECT_EQ(link->front().at.contact.point, from.at.contact.point);
    EXPECT_EQ(link->back().at.contact.point, to.at.contact.point);
    EXPECT_FALSE(contact_link(from, from, samples, part, link_limits));
}

// No centre of a contact link strays from its place above the part by more than the inner
// tolerance downwards, or by more than the slack of the cover upwards.
TEST(ContactLink, StaysInContactOnASaddle)
{
    const std::vector<Surface> surfaces{test::saddle(60, 20)};
    const Part saddle = surfaces;
    const BallCutter ball{5};
    const CoveredPart part{saddle, ball, {0.01, 0.5}};
    const PartSamples samples = part.samples(1, 100'000);
    const GougeTest gouge{surfaces, ball, Vec3::UnitZ()};
    const PassContact from = samples.contact({0.3, 0.3}, 0);
    for (const SurfacePoint& at : {SurfacePoint{0.3, 0.7}, {0.7, 0.3}, {0.6, 0.6}}) {
        const auto link =
            contact_link(from, samples.contact(at, 0), samples, part, link_limits);
        ASSERT_TRUE(link);
        EXPECT_GT(link->size(), 2u);
        for (std::size_t k = 0; k + 1 < link->size(); ++k) {
            const Vec3 a = ball_centre((*link)[k].at, ball);
            const Vec3 b = ball_centre((*link)[k + 1].at, ball);
            EXPECT_NE(gouge.test({a, b}, 0.0101).gouges, Answer::Yes);
            const Vec3 middle = (a + b) / 2;
            double least = 100;
            for (double u = 0.2; u <= 0.8; u += 0.0025)
                for (double v = 0.2; v <= 0.8; v += 0.0025) {
                    const Vec3 point = samples.contact({u, v}, 0).at.contact.point;
                    least = std::min(least, (middle - point).norm());
                }
            EXPECT_GT(least, 5 - 0.0101);
            EXPECT_LT(least, 5 + 0.01);
        }
    }
}

TEST(ContactLink, StaysOnOneSurface)
{
    const Part two = std::vector<Surface>{test::plane(20, 10), test::plane(20, 20)};
    const CoveredPart part{two, BallCutter{5}, {0.01, 0.5}};
    const PartSamples samples = part.samples(1, 100'000);
    const PassContact from = samples.contact({0.2, 0.3}, 0);
    std::int32_t other = 0;
    while (samples.surface(other) == 0)
        ++other;
    const PassContact to = samples.contact({0.4, 0.8}, other);
    EXPECT_EQ(to.surface, 1);
    EXPECT_FALSE(contact_link(from, to, samples, part, link_limits));
}

}  // namespace
}  // namespace endmill
