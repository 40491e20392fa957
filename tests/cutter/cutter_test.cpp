// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/cutter.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(Cutter, RefusesRadiiOutOfRange)
{
    for (const double radius : {0.0, -1.0, infinite, std::nan("")})
        EXPECT_THROW(Cutter(radius, 0), DomainError) << radius;
    for (const double corner_radius : {-1e-9, 5.000001, std::nan("")})
        EXPECT_THROW(Cutter(5, corner_radius), DomainError) << corner_radius;
}

TEST(Profile, IsACircleOnTheBallAndAPlaneOnTheFlat)
{
    const Cutter ball = Cutter::ball(5);
    const Cutter flat = Cutter::flat(5);
    for (const double d : {0.0, 0.1, 3.0, 4.0, 5.0}) {
        EXPECT_NEAR(ball.profile(d), 5 - std::sqrt(25 - d * d), 1e-15 * 5) << d;
        EXPECT_EQ(flat.profile(d), 0) << d;
    }
    EXPECT_EQ(ball.profile(std::nextafter(5.0, 6.0)), infinite);
    EXPECT_EQ(flat.profile(5.001), infinite);
}

TEST(Profile, OfABullNoseHasAFlatThenACorner)
{
    const Cutter bull{5, 2};
    EXPECT_EQ(bull.profile(3), 0);
    EXPECT_NEAR(bull.profile(4), 2 - std::sqrt(3.0), 1e-15);
    EXPECT_EQ(bull.profile(5), 2);
}

// The profile tends to a^2 / 2r; the plain difference would give 0.
TEST(Profile, KeepsItsDigitsNearTheTip)
{
    EXPECT_NEAR(Cutter::ball(5).profile(1e-9) / 1e-19, 1, 1e-15);
}

TEST(CutterWord, ReadsBackTheSameCutter)
{
    for (const Cutter& cutter :
         {Cutter::ball(7.5), Cutter::flat(3), Cutter{5, 2}, Cutter{0.1, 1e-5}})
        EXPECT_EQ(cutter_from_word(cutter_word(cutter)), cutter);
    EXPECT_EQ(cutter_word(Cutter{5, 2}), "bull:10:2");
}

TEST(CutterWord, IsRefusedIfItsNumbersAreOutOfRange)
{
    for (const char* word :
         {"", "ball", "ball:", "ball:0", "ball:-1", "ball:1:2", "Ball:10", "bull:10",
          "bull:10:6", "bull:10:-1", "flat:1e999", "bull:10:2:3", "ball:nan"})
        EXPECT_FALSE(cutter_from_word(word)) << word;
}

TEST(CutterWord, IsRefusedWithTheRangeOfTheWrongNumber)
{
    EXPECT_EQ(expected_cutter("ball:0"), "a diameter above 0 mm");
    EXPECT_EQ(expected_cutter("bull:-10:1"), "a diameter above 0 mm");
    EXPECT_EQ(expected_cutter("bull:10:6"),
              "a corner radius from 0 to 5 mm, half the diameter");
    EXPECT_EQ(expected_cutter("bull:10:-1"), expected_cutter("bull:10:6"));
    EXPECT_EQ(expected_cutter("ball:10mm"),
              "numbers in mm without a unit, as in ball:10");
    EXPECT_EQ(expected_cutter("bull:10mm:2mm"),
              "numbers in mm without a unit, as in bull:10:2");
    for (const char* word : {"", "ball", "ball:nan", "bull:10", "bull:10:2:3", "drill:3"})
        EXPECT_TRUE(expected_cutter(word).starts_with("ball:DIAMETER, ")) << word;
}

}  // namespace
}  // namespace endmill
