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

// The number of lines, or of those with this stroke.
std::size_t lines_in(const std::string& svg, const std::string& stroke = "")
{
    const std::string start =
        stroke.empty() ? "<path" : "<path fill=\"none\" stroke=\"" + stroke;
    std::size_t count = 0;
    for (auto at = svg.find(start); at != std::string::npos; at = svg.find(start, at + 1))
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
    EXPECT_THAT(svg, HasSubstr(">s, mm</text>"));
    EXPECT_THAT(svg, HasSubstr(">z, mm</text>"));
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
    // All but the axes, whose ticks depend on the extent.
    const auto drawn = [](const std::string& svg) {
        return lines_in(svg) - lines_in(svg, "#444444");
    };
    EXPECT_EQ(drawn(curves_svg(three)), drawn(curves_svg(one)) + 2);
}

TEST(ComparedSections, DrawAndNameEveryDifferentResult)
{
    const auto exact = trimmed_loop();
    const ComparedSections alone{.before = loop, .exact = {"exact", exact}, .others = {}};
    ComparedSections both = alone;
    both.others.push_back({"method <3>", exact});
    const std::string without = compared_sections_svg(alone);
    const std::string with = compared_sections_svg(both);
    EXPECT_EQ(lines_in(with), lines_in(without) + 2);  // the curve and its legend
    EXPECT_THAT(with, HasSubstr(">method &lt;3&gt;<"));
    both.cutter = Cutter::ball(2);
    both.places = {{0, 0}};
    EXPECT_THAT(compared_sections_svg(both), HasSubstr(">cutter where they differ<"));
    EXPECT_THROW(
        compared_sections_svg({.before = {}, .exact = {"exact", {}}, .others = {}}),
        DomainError);
}

// Only what is within half a side of the place is drawn: the scale is then larger.
TEST(ComparedSections, DrawAWindowAboutThePlace)
{
    const auto exact = trimmed_loop();
    ComparedSections drawing{.before = loop, .exact = {"exact", exact}, .others = {}};
    EXPECT_THAT(compared_sections_svg(drawing), HasSubstr(">6</text>"));
    drawing.places = {{0, 0}};
    drawing.half_side = 3;
    EXPECT_THAT(compared_sections_svg(drawing), testing::Not(HasSubstr(">6</text>")));
    EXPECT_THAT(compared_sections_svg(drawing), HasSubstr(">2</text>"));
    EXPECT_THAT(compared_sections_svg(drawing), HasSubstr(">s, mm</text>"));
}

MethodRow row_of(std::string name, std::vector<double> distances,
                 std::vector<bool> is_right)
{
    return {std::move(name), 2, 1, 3, std::move(distances), std::move(is_right)};
}

// The boxes of one colour: "M x y h width v height".
std::vector<std::array<int, 4>> boxes_of(const std::string& svg,
                                         const std::string& colour)
{
    std::vector<std::array<int, 4>> boxes;
    const std::string begin = "fill=\"" + colour + "\" stroke=\"none\"";
    for (auto at = svg.find(begin); at != std::string::npos;
         at = svg.find(begin, at + 1)) {
        const char* text = svg.c_str() + svg.find(" d=\"", at) + 4;
        std::array<int, 4> box{};
        int length = 0;
        while (std::sscanf(text, "M%d %dh%dv%dh%*dz%n", &box[0], &box[1], &box[2],
                           &box[3], &length) == 4) {
            boxes.push_back(box);
            text += length;
        }
    }
    return boxes;
}

// A decade of the logarithmic scale has the same height everywhere; wrong planes have
// another colour.
TEST(MethodsChart, DrawsDifferencesOnALogarithmicScale)
{
    const std::vector<MethodRow> rows{
        row_of("1", {0, 0.1, 1, 10, 0.001}, {true, false, false, false, true}),
        row_of("2", {0, 0.1, 0, 0, 0}, {true, true, true, true, true})};
    const std::string svg = methods_chart_svg(rows, {.tolerance_mm = 0.01});
    const auto wrong = boxes_of(svg, "#d55e00");
    ASSERT_EQ(wrong.size(), 4U);  // the last one belongs to the legend
    EXPECT_NEAR(wrong[1][3] - wrong[0][3], wrong[2][3] - wrong[1][3], 1);
    EXPECT_NEAR(wrong[1][0] - wrong[0][0], wrong[2][0] - wrong[1][0], 1);
    const auto right = boxes_of(svg, "#1d4f91");
    ASSERT_EQ(right.size(), 2U);
    EXPECT_EQ(right[0][0], wrong[0][0]);
    EXPECT_EQ(right[0][3], wrong[0][3]);
    EXPECT_THAT(svg, HasSubstr(">2 ms<"));
}

TEST(MethodsChart, StatesThatAMethodHasNoDifference)
{
    const std::vector<MethodRow> rows{row_of("1", {0, 0.005}, {true, true})};
    EXPECT_THAT(methods_chart_svg(rows, {}), HasSubstr("no difference"));
    EXPECT_EQ(methods_chart_svg(rows, {}), methods_chart_svg(rows, {}));
}

// More planes than columns of pixels: the largest difference of a column is drawn.
TEST(MethodsChart, DrawsTheLargestOfManyPlanes)
{
    MethodRow row =
        row_of("1", std::vector<double>(100000), std::vector<bool>(100000, true));
    row.distances_mm[54321] = 3;
    row.is_right[54321] = false;
    const std::vector<MethodRow> rows{row};
    const std::string svg = methods_chart_svg(rows, {});
    EXPECT_EQ(boxes_of(svg, "#d55e00").size(), 2U);
    EXPECT_LT(svg.size(), 20000U);
}

TEST(MethodsChart, RefusesRowsThatCannotBeDrawn)
{
    EXPECT_THROW(methods_chart_svg({}, {}), DomainError);
    const std::vector<MethodRow> uneven{row_of("1", {0, 0}, {true})};
    EXPECT_THROW(methods_chart_svg(uneven, {}), DomainError);
    const std::vector<MethodRow> odd{row_of("1", {NAN}, {true})};
    EXPECT_THROW(methods_chart_svg(odd, {}), DomainError);
    const std::vector<MethodRow> fine{row_of("1", {0}, {true})};
    EXPECT_THROW(methods_chart_svg(fine, {.tolerance_mm = 0}), DomainError);
}

}  // namespace
}  // namespace endmill
