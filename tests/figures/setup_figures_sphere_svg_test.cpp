// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/setup_figures.h"

#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "drawn_svg.h"
#include "endmill/core/error.h"
#include "posed_setups.h"

namespace endmill {
namespace {

using test::range_deg;
using test::setup_turned;

using std::numbers::pi;
const std::string needed_colour = "#e05a00";
const std::string rim_colour = "#8a8a8a";
const std::string cell_sides = "#ffffff";

// Facet j of 10 is reached along the first (j + 1) tenths of all cells.
VisibilityMap stepped_map(const SphereGrid& grid)
{
    const std::size_t cells = grid.centres.size();
    VisibilityMap map{10, cells};
    for (std::size_t i = 0; i < cells; ++i)
        for (std::size_t j = 0; j < 10; ++j)
            if (10 * i < (j + 1) * cells)
                map.column(i)[0] |= std::uint64_t{1} << j;
    return map;
}

double polygon_area(const std::vector<PixelPoint>& polygon)
{
    double twice = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const PixelPoint& a = polygon[k];
        const PixelPoint& b = polygon[(k + 1) % polygon.size()];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return std::abs(twice) / 2;
}

// What is drawn is longer than a sample in the legend.
std::vector<std::vector<PixelPoint>> drawn_lines(const std::string& svg,
                                                 const std::string& colour)
{
    std::vector<std::vector<PixelPoint>> lines;
    for (const auto& line : lines_of(svg, colour))
        if (line.size() > 2)
            lines.push_back(line);
    return lines;
}

struct Disc {
    PixelPoint centre;
    double radius;
};

Disc rim_of(const std::string& svg)
{
    const auto rim = lines_of(svg, rim_colour).at(0);
    PixelPoint sum{0, 0};
    for (const PixelPoint& point : rim)
        sum += point;
    const PixelPoint centre = sum / static_cast<double>(rim.size());
    return {centre, (rim[0] - centre).norm()};
}

class SphereOfGrid : public testing::TestWithParam<const char*> {};

// The cells in front tile the disc that the sphere is seen as.
TEST_P(SphereOfGrid, CellsTileTheDisc)
{
    const SphereGrid grid = sphere_grid(GetParam());
    const std::string svg = sphere_svg(grid, stepped_map(grid), {});
    const Disc disc = rim_of(svg);
    double area = 0;
    for (const auto& cell : lines_of(svg, cell_sides)) {
        area += polygon_area(cell);
        for (const PixelPoint& corner : cell)
            EXPECT_LE((corner - disc.centre).norm(), disc.radius + 0.1);
    }
    EXPECT_NEAR(area / (pi * disc.radius * disc.radius), 1, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Grids, SphereOfGrid,
                         testing::Values("hex:10", "cube:4", "latlong:12x6", "ico:1"));

// Seen from the spindle, all cells of the north half are in front, each in the colour of
// its share: hex has them first, so that none reaches fewer than half of the facets.
TEST(SphereSvg, ShadesCellsByTheFacetsThatTheyReach)
{
    const SphereGrid grid = sphere_grid("hex:6");
    const VisibilityMap map = stepped_map(grid);
    const std::string svg = sphere_svg(grid, map, {.elevation = Angle::degrees(90)});
    std::map<std::string, int> drawn;
    for (const XmlElement& element : SmallXml::parse(svg))
        if (element.name == "path" && element.attributes.at("stroke") == cell_sides)
            ++drawn[element.attributes.at("fill")];
    std::map<std::string, int> expected;
    for (std::size_t i = 0; i < grid.cells.size(); ++i) {
        if (grid.centres[i].z() < 0)
            continue;
        int reached = 0;
        for (std::size_t j = 0; j < 10; ++j)
            reached += map.is_accessible(j, i) ? 1 : 0;
        ++expected[reached <= 6 ? "#b3d3ea" : reached <= 8 ? "#90bfe0" : "#68a8d3"];
    }
    EXPECT_EQ(drawn, expected);
}

// Compares the numbers in the legend with the colours of cells that have so many facets.
TEST(SphereSvg, NamesTheNumbersOfEachShade)
{
    const SphereGrid grid = sphere_grid("hex:4");
    for (const std::size_t facets : {1U, 2U, 3U, 5U, 7U, 23U, 60U}) {
        VisibilityMap map{facets, grid.cells.size()};
        for (std::size_t i = 0; i < grid.cells.size(); ++i)
            for (std::size_t j = 0; j < i % (facets + 1); ++j)
                map.column(i)[0] |= std::uint64_t{1} << j;
        std::map<std::string, std::string> names;  // by colour
        std::map<std::string, std::set<int>> reached;
        std::string sample;
        const std::string svg = sphere_svg(grid, map, {.elevation = Angle::degrees(90)});
        std::size_t cell = 0;
        for (const XmlElement& element : SmallXml::parse(svg)) {
            if (element.name == "path" && element.attributes.at("stroke") == cell_sides)
                reached[element.attributes.at("fill")].insert(
                    static_cast<int>(cell++ % (facets + 1)));
            else if (element.name == "path")
                sample = element.attributes.at("stroke");
            else if (element.text.find("facet") != std::string::npos)
                names[sample] = element.text;
        }
        EXPECT_EQ(cell, grid.cells.size() / 2);  // the north half, in order
        for (const auto& [colour, counts] : reached) {
            const int low = *counts.begin();
            const int high = *counts.rbegin();
            std::string name =
                std::to_string(low) + " to " + std::to_string(high) + " facets";
            if (low == high)
                name = low == 0   ? "no facet"
                       : low == 1 ? "1 facet"
                                  : std::to_string(low) + " facets";
            EXPECT_EQ(names[colour], name) << facets;
        }
        EXPECT_EQ(names.size(), reached.size());
    }
}

// A tilt of 40 degrees with C turning all around is a disc of radius sin 40 from above.
TEST(SphereSvg, DrawsTheNeededMotionWhereItIs)
{
    const SphereGrid grid = sphere_grid("hex:4");
    SphereFigure figure{.elevation = Angle::degrees(90)};
    figure.setup = setup_turned(RotaryFamily::CA, test::some_turn(),
                                {range_deg(0, 40), range_deg(-180, 180)});
    const std::string svg = sphere_svg(grid, stepped_map(grid), figure);
    const Disc disc = rim_of(svg);
    const auto lines = drawn_lines(svg, needed_colour);
    ASSERT_EQ(lines.size(), 1U);
    for (const PixelPoint& point : lines[0])
        EXPECT_NEAR((point - disc.centre).norm() / disc.radius, std::sin(test::rad(40)),
                    1e-3);
}

TEST(SphereSvg, DashesLinesBehindTheSphere)
{
    const SphereGrid grid = sphere_grid("hex:4");
    SphereFigure figure{.elevation = Angle::degrees(90)};
    figure.setup = setup_turned(RotaryFamily::CA, test::some_turn(),
                                {range_deg(0, 120), range_deg(-180, 180)});
    int dashed = 0;
    for (const XmlElement& element :
         SmallXml::parse(sphere_svg(grid, stepped_map(grid), figure)))
        if (element.name == "path" && element.attributes.at("stroke") == needed_colour &&
            points_of(element.attributes.at("d")).size() > 2) {
            EXPECT_TRUE(element.attributes.contains("stroke-dasharray"));
            ++dashed;
        }
    EXPECT_GT(dashed, 0);
}

// The part's direction that becomes the machine's Z is seen in the middle from above.
TEST(SphereSvg, MarksDirectionsOfThePart)
{
    const SphereGrid grid = sphere_grid("hex:4");
    SphereFigure figure{.elevation = Angle::degrees(90)};
    const ShownSetup setup = setup_turned(RotaryFamily::AB, test::some_turn(), {});
    figure.setup = setup;
    figure.marked = {setup.frame.tool_axis, -setup.frame.tool_axis};
    const std::string svg = sphere_svg(grid, stepped_map(grid), figure);
    const Disc disc = rim_of(svg);
    std::vector<PixelPoint> marks;
    for (const XmlElement& element : SmallXml::parse(svg))
        if (element.name == "circle" && element.attributes.at("fill") == "#222222")
            marks.emplace_back(std::stod(element.attributes.at("cx")),
                               std::stod(element.attributes.at("cy")));
    ASSERT_EQ(marks.size(), 2U);  // the second in the legend
    EXPECT_LT((marks[0] - disc.centre).norm(), 0.15);
    EXPECT_GT(marks[1].y(), disc.centre.y() + disc.radius);
}

TEST(SphereSvg, LeavesOutCellsThatAreTooSmallToSee)
{
    const SphereGrid grid = sphere_grid("hex:100");
    const std::string svg = sphere_svg(grid, VisibilityMap{3, grid.centres.size()}, {});
    EXPECT_TRUE(lines_of(svg, cell_sides).empty());
    EXPECT_NE(svg.find("cells too fine to draw"), std::string::npos);
}

TEST(SphereSvg, RefusesAMapOfOtherCells)
{
    const SphereGrid grid = sphere_grid("hex:2");
    EXPECT_THROW(sphere_svg(grid, VisibilityMap{3, 47}, {}), DomainError);
    EXPECT_THROW(sphere_svg(grid, VisibilityMap{0, 48}, {}), DomainError);
}

}  // namespace
}  // namespace endmill
