// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/direction_figures.h"

#include <algorithm>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "drawn_svg.h"
#include "endmill/core/error.h"
#include "posed_setups.h"

namespace endmill {
namespace {

using test::range_deg;

std::set<std::string> texts_of(const std::string& svg)
{
    std::set<std::string> texts;
    for (const XmlElement& element : SmallXml::parse(svg))
        texts.insert(element.text);
    return texts;
}

ChartedDirections charted(ChartProjection projection)
{
    return {"a title",
            Vec3::UnitZ(),
            Vec3::UnitX(),
            {Vec3{0.3, 0, 1}.normalized(), Vec3{0, -0.4, 1}.normalized()},
            projection};
}

FeasibleDirections motion_of(RotaryFamily family, const RotaryLimits& limits)
{
    return {test::axes_of_machine(family), limits};
}

std::size_t discs_of(const std::string& svg)
{
    return static_cast<std::size_t>(std::ranges::count(
        SmallXml::parse(svg), std::string{"circle"}, &XmlElement::name));
}

TEST(MotionChart, ShowsDirectionsAndTheBorderOfTheMotion)
{
    const FeasibleDirections motion =
        motion_of(RotaryFamily::AB, {range_deg(-30, 20), range_deg(-10, 25)});
    const std::string svg =
        motion_chart(charted(ChartProjection::Equidistant), motion, "border");
    EXPECT_EQ(discs_of(svg), 3U);  // two directions and the legend
    const std::set<std::string> texts = texts_of(svg);
    EXPECT_TRUE(texts.contains("border"));
    EXPECT_TRUE(texts.contains("a title"));
    EXPECT_FALSE(texts.contains("towards R1"));
}

// Meridians through R1 and parallels about it: the borders along meridians are straight
// in the gnomonic projection, and R1 itself is at infinity.
TEST(MotionChart, ShowsTheWayToTheFirstAxisInTheGnomonicProjection)
{
    const FeasibleDirections motion =
        motion_of(RotaryFamily::AB, {range_deg(-30, 20), range_deg(-10, 25)});
    const std::string svg =
        motion_chart(charted(ChartProjection::Gnomonic), motion, "border");
    EXPECT_TRUE(texts_of(svg).contains("towards R1"));
    const auto line = lines_of(svg, "#b8006b").at(0);
    EXPECT_NEAR(line.front().y(), line.back().y(), 0.1);  // R1 is x, to the right
}

TEST(HullChart, ClosesTheHull)
{
    const std::vector<Vec3> hull{Vec3::UnitZ(), Vec3{0.3, 0, 1}.normalized(),
                                 Vec3{0, -0.4, 1}.normalized()};
    for (const ChartProjection projection :
         {ChartProjection::Gnomonic, ChartProjection::Orthographic}) {
        const auto line =
            lines_of(hull_chart(charted(projection), hull), "#0072b2").at(0);
        ASSERT_EQ(line.size(), 4U);
        // Coordinates have two decimals.
        EXPECT_LT((line.front() - line.back()).norm(), 0.02);
    }
    EXPECT_THROW(hull_chart(charted(ChartProjection::Gnomonic), {}), DomainError);
}

TEST(DirectionSphere, NamesTheEdgesOfARectangle)
{
    const std::set<std::string> texts = texts_of(direction_sphere_svg(
        motion_of(RotaryFamily::AB, {range_deg(-30, 20), range_deg(-10, 25)}), "t",
        "edge of the set"));
    for (const char* name : {"E1", "E2", "E3", "E4", "P", "tool", "edge of the set",
                             "basis circle, EG1, EG2"})
        EXPECT_TRUE(texts.contains(name)) << name;
}

TEST(DirectionSphere, NamesTheCornersOfASector)
{
    const std::set<std::string> texts = texts_of(direction_sphere_svg(
        motion_of(RotaryFamily::CA, {range_deg(0, 50), range_deg(-120, 60)}), "t",
        "edge"));
    EXPECT_TRUE(texts.contains("tool, R1"));
    EXPECT_TRUE(texts.contains("CR1") || texts.contains("CR2"));
    EXPECT_FALSE(texts.contains("E1"));
}

TEST(DirectionSphere, HasOneDirectionWithoutTurningAxes)
{
    const std::set<std::string> texts = texts_of(direction_sphere_svg(
        motion_of(RotaryFamily::AB, {range_deg(0, 0), range_deg(0, 0)}), "t", "edge"));
    EXPECT_TRUE(texts.contains("the only direction, P"));
    EXPECT_FALSE(texts.contains("edge"));
    EXPECT_FALSE(texts.contains("R1"));
}

// The border that is drawn solid lies within the sphere's outline, and dashed parts exist
// only for a set that reaches behind it.
TEST(DirectionSphere, DashesLinesBehindTheSphere)
{
    const auto dashed = [](double phi_deg) {
        int count = 0;
        const FeasibleDirections set =
            motion_of(RotaryFamily::CA, {range_deg(0, phi_deg), range_deg(-180, 180)});
        for (const XmlElement& element :
             SmallXml::parse(direction_sphere_svg(set, "t", "e")))
            if (element.name == "path" && element.attributes.at("stroke") == "#0072B2" &&
                element.attributes.contains("stroke-dasharray"))
                ++count;
        return count;
    };
    EXPECT_EQ(dashed(20), 0);
    EXPECT_GT(dashed(110), 0);
}

}  // namespace
}  // namespace endmill
