// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/axonometric_figure.h"

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drawn_svg.h"
#include "endmill/core/error.h"

namespace endmill {
namespace {

std::vector<PixelPoint> drawn(const std::vector<PixelPoint>& points)
{
    SvgPicture picture{100, 100, ""};
    picture.add_polyline(points, {});
    return lines_of(picture.text()).at(0);
}

// Half a hundredth in x and y, by which a coordinate is rounded.
constexpr double coordinate_rounding = 0.0071;

TEST(SvgPicture, IsWellFormedForAnyText)
{
    const std::string hostile = "</text><script>alert('1')</script> & \"q\" \x1b[0m\xff";
    SvgPicture picture{640, 480.5, hostile};
    picture.add_text({10, 20}, hostile, {.size_px = 12, .bold = true});
    const auto elements = SmallXml::parse(picture.text());
    EXPECT_EQ(elements.front().attributes.at("viewBox"), "0 0 640 480.5");
    EXPECT_EQ(elements.back().text, "</text><script>alert('1')</script> & \"q\" [0m?");
    EXPECT_THAT(
        elements,
        testing::Not(testing::Contains(testing::Field(&XmlElement::name, "script"))));
}

TEST(SvgPicture, DrawsAPolylineWithinATenthOfAPixel)
{
    std::mt19937 random{5};
    std::normal_distribution<double> step;
    for (const double size : {0.01, 0.1, 1.0, 10.0}) {
        std::vector<PixelPoint> points{{50, 50}};
        for (int i = 0; i < 2000; ++i)
            points.emplace_back(points.back() +
                                size * PixelPoint{step(random), step(random)});
        const auto line = drawn(points);
        EXPECT_LE((line.front() - points.front()).norm(), coordinate_rounding);
        EXPECT_LE((line.back() - points.back()).norm(), coordinate_rounding);
        for (const PixelPoint& point : points)
            EXPECT_LE(distance(point, line), 0.1 + coordinate_rounding);
    }
}

TEST(SvgPicture, LeavesOutInvisibleElements)
{
    std::vector<PixelPoint> straight;
    std::vector<PixelPoint> circle;
    for (int i = 0; i <= 100000; ++i) {
        const double angle = 2 * M_PI * i / 100000;
        straight.emplace_back(1e-3 * i, 5e-4 * i);
        circle.emplace_back(50 + 40 * std::cos(angle), 50 + 40 * std::sin(angle));
    }
    EXPECT_EQ(drawn(straight).size(), 2U);
    // A chord that strays s from a circle of radius r spans at least 2 acos(1 - s / r).
    const double sharpest = 2 * std::acos(1 - 0.1 / 40);
    EXPECT_LT(drawn(circle).size(), 2 * 2 * M_PI / sharpest);
}

TEST(SvgPicture, KeepsTheTurnsOfALineThatGoesBackOnItself)
{
    EXPECT_EQ(drawn({{0, 0}, {10, 0}, {5, 0}, {20, 0}, {0, 0}}).size(), 5U);
}

TEST(SvgPicture, RoundingsDoNotAddUp)
{
    std::vector<PixelPoint> zigzag;
    zigzag.reserve(10000);
    for (int i = 0; i < 10000; ++i)
        zigzag.emplace_back(0.333 * i, i % 2 == 0 ? 0.0 : 7.777);
    const auto line = drawn(zigzag);
    ASSERT_EQ(line.size(), zigzag.size());
    for (std::size_t i = 0; i < line.size(); ++i)
        EXPECT_LE((line[i] - zigzag[i]).norm(), coordinate_rounding);
}

TEST(SvgPicture, DrawsBoxesAsOneElementWithSharpSides)
{
    SvgPicture picture{100, 100, ""};
    picture.add_boxes(std::vector<PixelBox>{{3, 4, 20, 5}, {-7, 8, 1, 2}}, "#123456");
    const XmlElement path = SmallXml::parse(picture.text()).back();
    EXPECT_EQ(path.attributes.at("fill"), "#123456");
    EXPECT_EQ(path.attributes.at("shape-rendering"), "crispEdges");
    EXPECT_EQ(path.attributes.at("d"), "M3 4h20v5h-20zM-7 8h1v2h-1z");
}

TEST(SvgPicture, IgnoresEmptyElements)
{
    SvgPicture picture{100, 100, ""};
    const std::string before = picture.text();
    picture.add_polyline({}, {});
    picture.add_polyline(std::vector<PixelPoint>{{1, 1}}, {});
    picture.add_polygon(std::vector<PixelPoint>{{1, 1}, {2, 2}}, "#ffffff", {});
    picture.add_boxes({}, "#ffffff");
    EXPECT_EQ(picture.text(), before);
    EXPECT_EQ(drawn({{5, 5}, {5, 5}}).size(), 2U);
}

TEST(SvgPicture, RefusesNonFiniteCoordinates)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    SvgPicture picture{100, 100, ""};
    EXPECT_THROW(picture.add_polyline(std::vector<PixelPoint>{{0, 0}, {nan, 1}}, {}),
                 DomainError);
    EXPECT_THROW((SvgPicture{nan, 10, ""}), DomainError);
    EXPECT_THROW((SvgPicture{0, 10, ""}), DomainError);
}

}  // namespace
}  // namespace endmill
