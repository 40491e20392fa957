// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/coverage.h"

#include <cmath>

#include <gtest/gtest.h>

#include "test_surfaces.h"

namespace endmill {
namespace {

// A plane of 20 x 10 mm, a ball of radius 5 mm and a scallop height of 1 mm. The ball covers
// 3 mm on both sides of a pass.
class CoverageOfAPlane : public testing::Test {
protected:
    PassContact at(double u, double v) const
    {
        std::int32_t near = 0;
        const Vec3 place = samples_.contact({u, v}, 0).at.contact.point;
        for (std::size_t i = 0; i < samples_.size(); ++i)
            if ((samples_.point(i) - place).norm() <
                (samples_.point(near) - place).norm())
                near = static_cast<std::int32_t>(i);
        return samples_.contact({u, v}, near);
    }

    std::vector<Surface> surfaces_{test::plane(20, 10)};
    std::vector<double> sides_{1};
    PartSamples samples_{surfaces_, sides_, 0.5, 100'000};
    Coverage coverage_{samples_, BallCutter{5}, 1};
};

TEST_F(CoverageOfAPlane, IsTheStripBesideAPass)
{
    coverage_.add(std::vector{at(0, 0.5), at(1, 0.5)}, false);
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        const double beside = std::abs(samples_.point(i).y() - 5);
        if (std::abs(beside - 3) > 1e-9) {
            EXPECT_EQ(coverage_.gaps()[i] <= 0, beside < 3);
        }
        if (beside < 3) {
            EXPECT_NEAR(coverage_.gaps()[i], (beside * beside - 9) / 10, 1e-9);
        }
    }
}

TEST_F(CoverageOfAPlane, CanBeTakenBack)
{
    coverage_.add(std::vector{at(0, 0.5), at(1, 0.5)}, false);
    coverage_.accept();
    const std::vector<double> before(coverage_.gaps().begin(), coverage_.gaps().end());
    coverage_.add(std::vector{at(0, 0.2), at(1, 0.2)}, false);
    EXPECT_FALSE(coverage_.newly_covered(0).empty());
    coverage_.withdraw();
    EXPECT_TRUE(coverage_.newly_covered(0).empty());
    EXPECT_TRUE(std::equal(before.begin(), before.end(), coverage_.gaps().begin()));
}

TEST_F(CoverageOfAPlane, FindsWhatLiesBetweenSamples)
{
    std::vector<std::int32_t> all;
    for (std::size_t k = 0; k < samples_.triangles().size(); ++k)
        all.push_back(static_cast<std::int32_t>(k));
    // strips from 0 to 3 + 3.02 and from 6.17 on leave a gap between two rows of samples,
    // which are 0.3125 mm apart
    coverage_.add(std::vector{at(0, 0.302), at(1, 0.302)}, false);
    coverage_.add(std::vector{at(0, 0.917), at(1, 0.917)}, false);
    EXPECT_FALSE(coverage_.missed(all, 0).empty());
    coverage_.withdraw();
    coverage_.add(std::vector{at(0, 0.302), at(1, 0.302)}, false);
    coverage_.add(std::vector{at(0, 0.9), at(1, 0.9)}, false);
    EXPECT_TRUE(coverage_.missed(all, 1e-9).empty());
}

TEST_F(CoverageOfAPlane, TellsWhereAPlaceIsMissed)
{
    std::vector<std::int32_t> all;
    for (std::size_t k = 0; k < samples_.triangles().size(); ++k)
        all.push_back(static_cast<std::int32_t>(k));
    coverage_.add(std::vector{at(0, 0.302), at(1, 0.302)}, false);
    coverage_.add(std::vector{at(0, 0.917), at(1, 0.917)}, false);
    for (const MissedPlace& place : coverage_.missed(all, 0)) {
        const Vec3 point = contact_at(samples_, place).at.contact.point;
        EXPECT_GT(point.y(), 6.02);
        EXPECT_LT(point.y(), 6.17);
        const double beside = std::min(point.y() - 3.02, 9.17 - point.y());
        EXPECT_NEAR(place.gap, (beside * beside - 9) / 10, 1e-9);
        EXPECT_LT((samples_.point(sample_beside(samples_, place)) - point).norm(), 0.5);
    }
}

TEST_F(CoverageOfAPlane, MeasuresPlacesBetweenSamples)
{
    coverage_.add(std::vector{at(0, 0.5), at(1, 0.5)}, false);
    const std::int32_t from = at(0.5, 0.7).near;
    for (const std::int32_t to : samples_.neighbours(from)) {
        const double y = 0.4 * samples_.point(from).y() + 0.6 * samples_.point(to).y();
        EXPECT_NEAR(coverage_.gap_at({from, to, 0.6}), ((y - 5) * (y - 5) - 9) / 10,
                    1e-9);
    }
}

TEST_F(CoverageOfAPlane, OfPlacesOnTheNetIsThatOfTheirContacts)
{
    const std::int32_t from = at(0, 0.5).near;
    const std::int32_t to = at(1, 0.5).near;
    coverage_.add(std::vector<SampleEdge>{{from, from, 0}, {to, to, 0}}, false);
    const std::vector<double> on_net(coverage_.gaps().begin(), coverage_.gaps().end());
    coverage_.withdraw();
    coverage_.add(
        std::vector{samples_.contact({from, from, 0}), samples_.contact({to, to, 0})},
        false);
    for (std::size_t i = 0; i < on_net.size(); ++i)
        EXPECT_NEAR(on_net[i], coverage_.gaps()[i], 1e-12);
}

TEST_F(CoverageOfAPlane, WatchesPlaces)
{
    coverage_.watch(std::vector{SampleEdge{at(0.5, 0.8).near, at(0.5, 0.8).near, 0}});
    EXPECT_EQ(coverage_.watched_gaps()[0], 5);
    coverage_.add(std::vector{at(0, 0.8), at(1, 0.8)}, false);
    EXPECT_LT(coverage_.watched_gaps()[0], 0);
}

}  // namespace
}  // namespace endmill
