// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/level_lines.h"

#include <numbers>

#include <gtest/gtest.h>

#include "test_surfaces.h"

namespace endmill {
namespace {

using std::numbers::pi;

class LevelLines : public testing::Test {
protected:
    double length(const LevelLine& line) const
    {
        double sum = 0;
        const auto point = [&](std::size_t k) {
            return samples_.contact(line.places[k]).at.contact.point;
        };
        for (std::size_t k = 0; k + 1 < line.places.size(); ++k)
            sum += (point(k + 1) - point(k)).norm();
        if (line.is_closed)
            sum += (point(0) - point(line.places.size() - 1)).norm();
        return sum;
    }

    // Distance of each sample from a place of the plane.
    std::vector<double> distances(const Vec3& place) const
    {
        std::vector<double> values(samples_.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = (samples_.point(i) - place).norm();
        return values;
    }

    std::vector<Surface> surfaces_{test::plane(20, 10)};
    std::vector<double> sides_{1};
    PartSamples samples_{surfaces_, sides_, 0.2, 1'000'000};
};

TEST_F(LevelLines, ACircleIsClosed)
{
    const auto lines = level_lines(samples_, distances({10, 5, 0}), {}, 3);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_TRUE(lines[0].is_closed);
    EXPECT_NEAR(length(lines[0]), 6 * pi, 0.01 * 6 * pi);
}

TEST_F(LevelLines, ALineEndsAtTheBorder)
{
    const auto lines = level_lines(samples_, distances({0, 0, 0}), {}, 4);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_FALSE(lines[0].is_closed);
    EXPECT_NEAR(length(lines[0]), 2 * pi, 0.01 * 2 * pi);
}

TEST_F(LevelLines, NearSamplesSufficeWhereAllThatAreBelowAreNear)
{
    const std::vector<double> values = distances({10, 5, 0});
    std::vector<std::int32_t> near;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (values[i] < 3.5)
            near.push_back(static_cast<std::int32_t>(i));
    const auto all = level_lines(samples_, values, {}, 3);
    const auto some = level_lines(samples_, values, near, 3);
    ASSERT_EQ(some.size(), 1u);
    EXPECT_EQ(some[0].places.size(), all[0].places.size());
    EXPECT_NEAR(length(some[0]), length(all[0]), 1e-9);
}

TEST_F(LevelLines, AreCutWhereOtherValuesArePositive)
{
    const auto lines = level_lines(samples_, distances({10, 5, 0}), {}, 3);
    std::vector<double> right(samples_.size());
    for (std::size_t i = 0; i < right.size(); ++i)
        right[i] = samples_.point(i).x() - 10;
    const auto parts = where_positive(lines, right);
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_FALSE(parts[0].is_closed);
    EXPECT_NEAR(length(parts[0]), 3 * pi, 0.5);
    EXPECT_TRUE(where_positive(lines, right, 100).empty());
}

TEST(CrossingShare, IsTheZeroOfAParabola)
{
    const auto value = [](double share) { return share * share - 0.16; };
    EXPECT_NEAR(crossing_share(value), 0.4, 1e-12);
    EXPECT_NEAR(crossing_share([](double share) { return 0.3 - share; }), 0.3, 1e-12);
    EXPECT_EQ(crossing_share([](double share) { return share + 1; }), 0);
    EXPECT_EQ(crossing_share([](double share) { return share - 2; }), 1);
}

}  // namespace
}  // namespace endmill
