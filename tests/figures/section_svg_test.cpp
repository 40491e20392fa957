// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/section_svg.h"

#include <array>
#include <cmath>
#include <cstdio>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::vector<SectionCurve> loop{
    {{{-6, 6}, {2, -2}, {0, -1}, {-2, -2}, {6, 6}}, false}};

std::vector<TrimmedCurve> trimmed_loop()
{
    TrimmedCurve curve;
    curve.points = {{{-6, 6}, {0, 0}, {0, 0}, TrimmedKind::Vertex},
                    {{0, 0}, {0, 0}, {0, 3}, TrimmedKind::Crossing},
                    {{6, 6}, {0, 4}, {0, 4}, TrimmedKind::Vertex}};
    return {curve};
}

std::size_t lines_in(const std::string& svg)
{
    std::size_t count = 0;
    for (auto at = svg.find("<path"); at != std::string::npos;
         at = svg.find("<path", at + 1))
        ++count;
    return count;
}

TEST(SectionSvg, DrawsBothStatesAndTheCutterAtTheCrossing)
{
    const auto after = trimmed_loop();
    const std::string without = section_svg({loop, after});
    const std::string with = section_svg({loop, after, Cutter{2, 0.5}});
    EXPECT_EQ(lines_in(with), lines_in(without) + 2);  // its outline and its legend
    EXPECT_THAT(with, HasSubstr(">cutter<"));
    EXPECT_THAT(without, Not(HasSubstr(">cutter<")));
}

TEST(SectionSvg, NamesTheAxesOfTheSection)
{
    const std::string svg = section_svg({loop, {}});
    EXPECT_THAT(svg, HasSubstr(">s</text>"));
    EXPECT_THAT(svg, HasSubstr(">z</text>"));
}

TEST(SectionSvg, HasOneScaleInBothDirections)
{
    // A square's sides are equally long: its corners lie on two verticals and two levels.
    const std::vector<SectionCurve> square{
        {{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}, true}};
    const std::string svg = section_svg({square, {}});
    // Relative moves along the sides: "l W 0 0 -W -W 0", each side as long as the first.
    const auto from = svg.find(" d=\"M", svg.find("#d1402f"));
    ASSERT_NE(from, std::string::npos);
    double x = 0;
    double y = 0;
    std::array<double, 6> sides{};
    ASSERT_EQ(
        std::sscanf(svg.c_str() + from, " d=\"M%lf %lfl%lf %lf%lf %lf%lf %lf", &x, &y,
                    &sides[0], &sides[1], &sides[2], &sides[3], &sides[4], &sides[5]),
        8)
        << svg.substr(from, 80);
    EXPECT_EQ(sides[1], 0);
    EXPECT_EQ(sides[2], 0);
    EXPECT_NEAR(sides[0], -sides[3], 0.02);
    EXPECT_NEAR(sides[0], -sides[4], 0.02);
}

TEST(SectionSvg, RefusesSectionsThatCannotBeDrawn)
{
    EXPECT_THROW(section_svg({{}, {}}), DomainError);
    EXPECT_THROW(curves_svg({}), DomainError);
    const std::vector<std::vector<Vec3>> odd{{{0, 0, 0}, {1, NAN, 0}}};
    EXPECT_THROW(curves_svg(odd), DomainError);
}

TEST(CurvesSvg, DrawsEachCurve)
{
    const std::vector<std::vector<Vec3>> one{{{0, 0, 0}, {9, 0, 1}}};
    std::vector<std::vector<Vec3>> three = one;
    three.push_back({{0, 5, 0}, {9, 5, 1}});
    three.push_back({{0, 9, 0}, {9, 9, 1}});
    EXPECT_EQ(lines_in(curves_svg(three)), lines_in(curves_svg(one)) + 2);
}

}  // namespace
}  // namespace endmill
