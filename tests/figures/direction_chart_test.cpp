// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/detail/direction_chart.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "drawn_svg.h"
#include "endmill/core/error.h"

namespace endmill {
namespace {

constexpr double rad = std::numbers::pi / 180;
const DirectionChart::Frame frame{Vec3::UnitZ(), Vec3::UnitX()};
const std::string mark_colour = "#010203";

Vec3 direction(double azimuth_deg, double polar_deg)
{
    return {std::sin(polar_deg * rad) * std::cos(azimuth_deg * rad),
            std::sin(polar_deg * rad) * std::sin(azimuth_deg * rad),
            std::cos(polar_deg * rad)};
}

// The places of the marks, without the one of the legend.
std::vector<PixelPoint> marks(ChartProjection projection, double reach_deg,
                              const std::vector<Vec3>& directions)
{
    DirectionChart chart{"t", frame, projection, Angle::degrees(reach_deg)};
    chart.add_marks(directions, mark_colour, "directions");
    std::vector<PixelPoint> places;
    for (const XmlElement& element : SmallXml::parse(chart.text()))
        if (element.name == "circle" && element.attributes.at("fill") == mark_colour)
            places.emplace_back(std::stod(element.attributes.at("cx")),
                                std::stod(element.attributes.at("cy")));
    places.pop_back();
    return places;
}

struct Projection {
    ChartProjection projection;
    double reach_deg;
    double (*radius)(double polar);
};

class ChartOfDirections : public testing::TestWithParam<Projection> {};

TEST_P(ChartOfDirections, HasTheRadiiOfItsProjection)
{
    const auto& [projection, reach_deg, radius] = GetParam();
    const auto places =
        marks(projection, reach_deg,
              {direction(0, 0), direction(0, reach_deg), direction(90, 0.4 * reach_deg)});
    ASSERT_EQ(places.size(), 3U);
    const PixelPoint right = places[1] - places[0];
    EXPECT_NEAR(right.y(), 0, 0.02);
    EXPECT_GT(right.x(), 0);
    const PixelPoint up = places[2] - places[0];  // azimuth 90: upwards
    EXPECT_NEAR(up.x(), 0, 0.02);
    EXPECT_NEAR(-up.y() / right.x(),
                radius(0.4 * reach_deg * rad) / radius(reach_deg * rad), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(
    All, ChartOfDirections,
    testing::Values(Projection{ChartProjection::Equidistant, 180,
                               [](double polar) { return polar; }},
                    Projection{ChartProjection::Gnomonic, 80,
                               [](double polar) { return std::tan(polar); }},
                    Projection{ChartProjection::Orthographic, 90,
                               [](double polar) { return std::sin(polar); }}));

// A great circle becomes a straight line in the gnomonic projection.
TEST(DirectionChart, DrawsGreatCirclesStraightInTheGnomonicProjection)
{
    const Vec3 a = direction(20, 50);
    const Vec3 b = direction(130, 60);
    const auto places =
        marks(ChartProjection::Gnomonic, 80, {a, b, (a + b).normalized()});
    ASSERT_EQ(places.size(), 3U);
    EXPECT_LT(distance(places[2], {places[0], places[1]}), 0.05);
}

TEST(DirectionChart, LeavesOutDirectionsBeyondItsReach)
{
    EXPECT_EQ(marks(ChartProjection::Equidistant, 40,
                    {direction(0, 39.9), direction(0, 40), direction(0, 40.1)})
                  .size(),
              2U);
    DirectionChart chart{"t", frame, ChartProjection::Equidistant, Angle::degrees(40)};
    std::vector<Vec3> meridian;
    for (int polar = -60; polar <= 60; ++polar)
        meridian.push_back(direction(0, polar));
    const std::size_t before = lines_of(chart.text()).size();
    chart.add_curve(meridian, {mark_colour, 1, ""});
    EXPECT_EQ(lines_of(chart.text()).size(), before + 1);
}

TEST(DirectionChart, RefusesAReachBeyondItsProjection)
{
    const auto chart = [](ChartProjection projection, double reach_deg) {
        return DirectionChart{"t", frame, projection, Angle::degrees(reach_deg)}.text();
    };
    EXPECT_THROW(chart(ChartProjection::Gnomonic, 90), DomainError);
    EXPECT_THROW(chart(ChartProjection::Orthographic, 91), DomainError);
    EXPECT_THROW(chart(ChartProjection::Equidistant, 181), DomainError);
    EXPECT_THROW(chart(ChartProjection::Equidistant, 0), DomainError);
    EXPECT_NO_THROW(chart(ChartProjection::Orthographic, 90));
}

}  // namespace
}  // namespace endmill
