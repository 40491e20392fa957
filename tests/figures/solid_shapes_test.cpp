// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/detail/solid_shapes.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "drawn_svg.h"

namespace endmill {
namespace {

constexpr SolidColours colours{"#010101", "#020202", "#030303"};

AxonometricFigure figure_from(double azimuth_deg, double elevation_deg)
{
    return {{.azimuth = Angle::degrees(azimuth_deg),
             .elevation = Angle::degrees(elevation_deg)},
            std::array<Vec3, 2>{Vec3{-10, -10, -10}, {10, 10, 10}}};
}

std::size_t faces_of(const std::string& svg, std::string_view colour)
{
    return lines_of(svg, std::string{colour}).size();
}

double area_of(const std::vector<PixelPoint>& polygon)
{
    double twice = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const PixelPoint& a = polygon[k];
        const PixelPoint& b = polygon[(k + 1) % polygon.size()];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return std::abs(twice) / 2;
}

TEST(AddBox, ShowsItsTopAndTwoSides)
{
    AxonometricFigure figure = figure_from(-60, 30);
    add_box(figure, {0, 0, 0}, {2, 3, 4}, colours);
    const std::string svg = figure.text();
    EXPECT_EQ(faces_of(svg, colours.light), 1U);
    EXPECT_EQ(faces_of(svg, colours.middle) + faces_of(svg, colours.dark), 2U);
}

// From above, a cylinder is a disc of its radius: compared with a box of a known area.
TEST(AddCylinder, IsADiscFromAbove)
{
    AxonometricFigure figure = figure_from(-90, 90);
    add_box(figure, {0, 0, -5}, {4, 4, 1}, colours);
    add_cylinder(figure, {0, 0, 0}, {0, 0, 5}, 4, colours);
    const auto faces = lines_of(figure.text(), std::string{colours.light});
    ASSERT_EQ(faces.size(), 2U);
    const double disc =
        18 * std::sin(std::numbers::pi / 18);  // polygon of 36 sides, over r^2
    EXPECT_NEAR(area_of(faces[1]) / area_of(faces[0]), disc / 4, 1e-3);
}

TEST(AddCylinder, ShowsHalfOfItsSide)
{
    AxonometricFigure figure = figure_from(-90, 0);
    add_cylinder(figure, {0, 0, 0}, {0, 0, 5}, 4, colours);
    const std::string svg = figure.text();
    EXPECT_EQ(faces_of(svg, colours.light), 0U);
    const std::size_t sides = faces_of(svg, colours.middle) + faces_of(svg, colours.dark);
    EXPECT_GE(sides, 17U);
    EXPECT_LE(sides, 19U);
}

// Seen along its axis, the arrow goes counter-clockwise around it by three quarters of a
// turn.
TEST(AddTurnArrow, FollowsTheRightHandRule)
{
    AxonometricFigure figure = figure_from(-90, 90);
    add_turn_arrow(figure, {{0, 0, 0}, Vec3::UnitZ(), 5}, {"#040404", 1, ""});
    const auto arc = lines_of(figure.text(), "#040404").at(0);
    double turn = 0;
    PixelPoint centre{0, 0};
    for (const PixelPoint& corner : arc)
        centre += corner / static_cast<double>(arc.size());
    for (std::size_t k = 1; k < arc.size(); ++k)
        turn += arc[k - 1].y() * (arc[k].x() - arc[k - 1].x()) -
                arc[k - 1].x() * (arc[k].y() - arc[k - 1].y());
    // Twice the signed area between the arc and the picture's origin, closed by its
    // chord.
    turn += arc.back().y() * (arc.front().x() - arc.back().x()) -
            arc.back().x() * (arc.front().y() - arc.back().y());
    EXPECT_GT(turn, 0);  // counter-clockwise where y counts downwards
}

TEST(AddDoubleArrow, HasTwoHeads)
{
    AxonometricFigure figure = figure_from(-90, 0);
    add_double_arrow(figure, {-5, 0, 0}, {5, 0, 0}, {"#050505", 1, ""});
    EXPECT_EQ(faces_of(figure.text(), "#050505"), 4U);  // two halves and two heads
}

}  // namespace
}  // namespace endmill
