// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/setup_figures.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "drawn_svg.h"
#include "endmill/core/error.h"
#include "posed_setups.h"
#include "test_meshes.h"

namespace endmill {
namespace {

using test::setup_turned;

// The shades of a facet that faces the viewer.
const std::string reached_fill = "#a3cfea";
const std::string turned_fill = "#f3d98c";
const std::string back_fill = "#c6c6c6";

std::vector<std::string> fills_of(const std::string& svg)
{
    std::vector<std::string> fills;
    for (const XmlElement& element : SmallXml::parse(svg))
        if (element.name == "path" && element.attributes.at("fill") != "none")
            fills.push_back(element.attributes.at("fill"));
    return fills;
}

ShownSetup upright(const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity())
{
    return setup_turned(RotaryFamily::AB, turn, {{0, 0}, {0, 0}});
}

const SetupFigure from_above{.elevation = Angle::degrees(90)};

// Two squares, seen from above: the lower one is drawn first, whichever comes first.
TEST(SetupSvg, DrawsTheNearerFacetLast)
{
    const auto square = [](double height) {
        return test::grid_mesh(1, 1, [height](int i, int j) {
            return Vec3{double(i), double(j), height};
        });
    };
    const std::vector<std::uint8_t> reached{1, 1, 0, 0};
    const std::vector<std::string> first{reached_fill, reached_fill, turned_fill,
                                         turned_fill};
    const std::vector<std::string> last{turned_fill, turned_fill, reached_fill,
                                        reached_fill};
    EXPECT_EQ(fills_of(setup_svg(test::both(square(0), square(1)), reached, upright(),
                                 from_above)),
              first);
    EXPECT_EQ(fills_of(setup_svg(test::both(square(1), square(0)), reached, upright(),
                                 from_above)),
              last);
}

// The part's +x face comes to the top when x becomes Z; it alone is drawn in full light.
TEST(SetupSvg, TurnsThePart)
{
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd{-test::rad(90), Vec3::UnitY()}.toRotationMatrix();
    ASSERT_NEAR((turn * Vec3::UnitX()).z(), 1, 1e-15);
    const TriangleMesh box = test::box_mesh({0, 0, 0}, {3, 2, 1});
    std::vector<std::uint8_t> reached(12, 0);
    reached[10] = reached[11] = 1;  // x = 3
    const auto fills = fills_of(setup_svg(box, reached, upright(turn), from_above));
    ASSERT_EQ(fills.size(), 12U);
    EXPECT_EQ(std::ranges::count(fills, reached_fill), 2);
    EXPECT_EQ(fills[10], reached_fill);
    EXPECT_EQ(fills[11], reached_fill);
    EXPECT_EQ(std::ranges::count(fills, turned_fill), 0);
    EXPECT_EQ(std::ranges::count(fills, back_fill), 2);
}

// R1 is X: from the front it goes to the right, through the middle of the part.
TEST(SetupSvg, DrawsTheAxesThroughTheMiddle)
{
    const SetupFigure from_front{.azimuth = Angle::degrees(-90),
                                 .elevation = Angle::degrees(0)};
    const TriangleMesh box = test::box_mesh({0, 0, 0}, {3, 2, 1});
    const std::string svg =
        setup_svg(box, std::vector<std::uint8_t>(12, 1), upright(), from_front);
    PixelPoint low{1e9, 1e9};
    PixelPoint high{-1e9, -1e9};
    for (const XmlElement& element : SmallXml::parse(svg))
        if (element.name == "path" && element.attributes.at("fill") != "none")
            for (const PixelPoint& point : points_of(element.attributes.at("d"))) {
                low = low.cwiseMin(point);
                high = high.cwiseMax(point);
            }
    const PixelPoint middle = (low + high) / 2;
    const auto runs = lines_of(svg, "#b8006b");
    ASSERT_EQ(runs.size(), 3U);  // left and right of the part, and in the legend
    for (std::size_t k = 0; k < 2; ++k)
        for (const PixelPoint& point : runs[k])
            EXPECT_NEAR(point.y(), middle.y(), 0.1);
    // Up to a piece of the axis.
    const double piece = 0.02 * (high.x() - low.x());
    EXPECT_LT(runs[0].front().x(), low.x());
    EXPECT_NEAR(runs[0].back().x(), low.x(), piece);
    EXPECT_NEAR(runs[1].front().x(), high.x(), piece);
    EXPECT_GT(runs[1].back().x(), high.x());
}

// The part's z is the machine's X: a quarter turn from the tool axis.
TEST(SetupSvg, DrawsThePartsOwnAxesIfTheyHaveNames)
{
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd{test::rad(90), Vec3::UnitY()}.toRotationMatrix();
    const TriangleMesh box = test::box_mesh({0, 0, 0}, {3, 2, 1});
    const std::vector<std::uint8_t> reached(12, 1);
    SetupFigure figure{.azimuth = Angle::degrees(-90), .elevation = Angle::degrees(0)};
    const std::string without = setup_svg(box, reached, upright(turn), figure);
    EXPECT_TRUE(lines_of(without, "#b3261e").empty());
    figure.part_axis_names = {"", "", "z of the part"};
    const std::string svg = setup_svg(box, reached, upright(turn), figure);
    EXPECT_NE(svg.find("z of the part"), std::string::npos);
    EXPECT_NE(svg.find("90°"), std::string::npos);
    const auto lines = lines_of(svg, "#b3261e");
    ASSERT_GE(lines.size(), 2U);  // the visible part of z, the arc, the legend
    for (const PixelPoint& point : lines.front())
        EXPECT_NEAR(point.y(), lines.front().front().y(), 0.1);
    EXPECT_GT(lines.front().back().x(), lines.front().front().x());
}

TEST(SetupSvg, StatesThatALargePartIsDrawnCoarser)
{
    const TriangleMesh torus = test::torus_mesh(100, 40);
    const std::vector<std::uint8_t> reached(torus.triangles().size(), 1);
    SetupFigure figure;
    figure.most_facets = 3000;
    const std::string svg = setup_svg(torus, reached, upright(), figure);
    const auto fills = fills_of(svg).size();
    EXPECT_LE(fills, 3000U);
    EXPECT_NE(svg.find("drawn coarser: " + std::to_string(fills) + " of 8000 facets"),
              std::string::npos);
    EXPECT_EQ(setup_svg(torus, reached, upright(), {}).find("drawn coarser"),
              std::string::npos);
}

TEST(SetupSvg, RefusesAnotherNumberOfFacets)
{
    const TriangleMesh box = test::box_mesh({0, 0, 0}, {3, 2, 1});
    EXPECT_THROW(setup_svg({}, {}, upright(), {}), DomainError);
    EXPECT_THROW(setup_svg(box, std::vector<std::uint8_t>(11, 1), upright(), {}),
                 DomainError);
    SetupFigure figure;
    figure.most_facets = 0;
    EXPECT_THROW(setup_svg(box, std::vector<std::uint8_t>(12, 1), upright(), figure),
                 DomainError);
}

}  // namespace
}  // namespace endmill
