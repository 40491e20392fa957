// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/axonometric_figure.h"

#include <array>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "drawn_svg.h"
#include "endmill/core/error.h"

namespace endmill {
namespace {

constexpr LineStyle test_style{"#010203", 1, ""};

std::vector<Vec3> box_corners(const Vec3& size)
{
    std::vector<Vec3> corners;
    corners.reserve(8);
    for (int k = 0; k < 8; ++k)
        corners.emplace_back(size.x() * (k & 1), size.y() * (k >> 1 & 1),
                             size.z() * (k >> 2));
    return corners;
}

TEST(AxonometricView, HasThreeUnitDirectionsAtRightAngles)
{
    for (const double azimuth : {-60.0, 0.0, 45.0, 200.0})
        for (const double elevation : {0.0, 30.0, 90.0}) {
            const AxonometricView view{Angle::degrees(azimuth),
                                       Angle::degrees(elevation)};
            Eigen::Matrix3d frame;
            frame << view.right, view.up, view.toward;
            EXPECT_TRUE((frame.transpose() * frame).isIdentity(1e-14));
            EXPECT_NEAR(frame.determinant(), 1, 1e-14);
        }
}

// The directions of the picture for views from the front, from the right and from above.
TEST(AxonometricView, FacesThePartFromTheViewer)
{
    const AxonometricView front{Angle::degrees(-90), Angle::degrees(0)};
    EXPECT_TRUE(front.right.isApprox(Vec3::UnitX(), 1e-15));
    EXPECT_TRUE(front.up.isApprox(Vec3::UnitZ(), 1e-15));
    const AxonometricView right{Angle::degrees(0), Angle::degrees(0)};
    EXPECT_TRUE(right.right.isApprox(Vec3::UnitY(), 1e-15));
    const AxonometricView above{Angle::degrees(-90), Angle::degrees(90)};
    EXPECT_TRUE(above.right.isApprox(Vec3::UnitX(), 1e-15));
    EXPECT_TRUE(above.up.isApprox(Vec3::UnitY(), 1e-15));
    EXPECT_TRUE(above.toward.isApprox(Vec3::UnitZ(), 1e-15));
}

// Compares lengths in the picture with lengths in space, seen from the front.
TEST(AxonometricFigure, KeepsOneScaleInTheWholeDrawing)
{
    const FigureOptions from_front{.azimuth = Angle::degrees(-90),
                                   .elevation = Angle::degrees(0)};
    const auto corners = box_corners({200, 120, 50});
    AxonometricFigure figure{from_front, corners};
    figure.add_curve(std::array<Vec3, 3>{Vec3{0, 0, 50}, {0, 0, 0}, {200, 0, 0}},
                     test_style);
    const auto line = lines_of(figure.text(), "#010203").at(0);
    ASSERT_EQ(line.size(), 3U);
    const double width = (line[2] - line[1]).norm();
    EXPECT_NEAR((line[1] - line[0]).norm(), width * 50 / 200, 0.02);
    EXPECT_GT(line[1].y(), line[0].y());  // z goes up
    EXPECT_GT(line[2].x(), line[1].x());  // x goes to the right
}

struct Frame {
    double width;
    double height;
};

Frame frame_of(const std::string& svg)
{
    const auto root = SmallXml::parse(svg).front();
    return {std::stod(root.attributes.at("width")),
            std::stod(root.attributes.at("height"))};
}

class FigureOfABox : public testing::TestWithParam<Vec3> {};

TEST_P(FigureOfABox, HasRoomForTheWholeDrawing)
{
    const auto corners = box_corners(GetParam());
    for (const double azimuth : {-60.0, 0.0, 90.0, 170.0}) {
        AxonometricFigure figure{{.title = "t",
                                  .captions = {"a", "b"},
                                  .width_px = 400,
                                  .azimuth = Angle::degrees(azimuth),
                                  .has_ticks = azimuth > 0},
                                 corners};
        figure.add_curve(corners, test_style);
        figure.add_legend("cut", test_style);
        const std::string svg = figure.text();
        const auto [width, height] = frame_of(svg);
        EXPECT_EQ(width, 400);
        for (const auto& line : lines_of(svg))
            for (const PixelPoint& point : line) {
                EXPECT_TRUE(0 <= point.x() && point.x() <= width) << point.x();
                EXPECT_TRUE(0 <= point.y() && point.y() <= height) << point.y();
            }
    }
}

INSTANTIATE_TEST_SUITE_P(FlatTallTinyHugeAndAPoint, FigureOfABox,
                         testing::Values(Vec3(200, 120, 220), Vec3(200, 120, 0),
                                         Vec3(1, 1, 1e6), Vec3(1e-6, 1e-6, 1e-7),
                                         Vec3(1e6, 1e6, 1e6), Vec3(0, 0, 0)));

TEST(AxonometricFigure, TextsStandBelowEachOther)
{
    AxonometricFigure figure{{.title = "title", .captions = {"one", "two"}},
                             box_corners({2, 1, 1})};
    std::vector<double> heights;
    for (const XmlElement& element : SmallXml::parse(figure.text()))
        if (element.name == "text" &&
            (element.text == "title" || element.text == "one" || element.text == "two"))
            heights.push_back(std::stod(element.attributes.at("y")));
    ASSERT_EQ(heights.size(), 3U);
    EXPECT_GE(heights[1] - heights[0], 20);
    EXPECT_GE(heights[2] - heights[1], 14);
}

// The arm of the x axis, measured in the scale of the drawing, has the stated length.
TEST(AxonometricFigure, TheAxesStateTheirLength)
{
    AxonometricFigure figure{
        {.azimuth = Angle::degrees(-90), .elevation = Angle::degrees(0)},
        box_corners({200, 120, 50})};
    figure.add_curve(std::array<Vec3, 2>{Vec3{0, 0, 0}, {200, 0, 0}}, test_style);
    const std::string svg = figure.text();
    const auto extent = lines_of(svg, "#010203").at(0);
    const double scale = (extent[1] - extent[0]).norm() / 200;
    const auto arm = lines_of(svg, "#444444").at(0);
    const double arm_mm = (arm[1] - arm[0]).norm() / scale;
    EXPECT_NEAR(arm_mm, 10, 0.01);
    EXPECT_THAT(SmallXml::parse(svg),
                testing::Contains(testing::Field(&XmlElement::text, "each arm 10 mm")));
}

// Seen from the front, the ticks of x stand below the points with their coordinates, and
// those of z beside them.
TEST(AxonometricFigure, TicksStandWhereTheirNumbersAre)
{
    AxonometricFigure figure{{.azimuth = Angle::degrees(-90),
                              .elevation = Angle::degrees(0),
                              .has_ticks = true},
                             box_corners({200, 120, 50})};
    figure.add_curve(std::array<Vec3, 3>{Vec3{100, 0, 0}, {100, 0, 20}, {0, 0, 20}},
                     test_style);
    const std::string svg = figure.text();
    const auto line = lines_of(svg, "#010203").at(0);
    int seen = 0;
    for (const XmlElement& element : SmallXml::parse(svg)) {
        if (element.text != "100" && element.text != "20")
            continue;
        const PixelPoint at{std::stod(element.attributes.at("x")),
                            std::stod(element.attributes.at("y"))};
        if (element.text == "20" && at.x() > line[2].x())
            continue;  // of x
        ++seen;
        if (element.text == "100") {
            EXPECT_NEAR(at.x(), line[0].x(), 0.02);
            EXPECT_GT(at.y(), line[0].y());
        } else {
            EXPECT_NEAR(at.y(), line[2].y(), 8);  // the base line is below the middle
        }
    }
    EXPECT_EQ(seen, 2);
    EXPECT_EQ(svg.find("each arm"), std::string::npos);
    for (const char* name : {">x, mm<", ">z, mm<"})
        EXPECT_NE(svg.find(name), std::string::npos);
    EXPECT_EQ(svg.find(">y, mm<"), std::string::npos);  // y points away
}

// The shaft of an arrow equals the curve between the same points; the tip of the head is
// its end.
TEST(AxonometricFigure, AnArrowGoesFromPointToPoint)
{
    const std::array<Vec3, 2> ends{Vec3{10, 20, 5}, {150, 80, 40}};
    AxonometricFigure figure{{}, box_corners({200, 120, 50})};
    figure.add_curve(ends, test_style);
    figure.add_arrow(ends[0], ends[1], {"#0a0b0c", 1, ""});
    const std::string svg = figure.text();
    const auto curve = lines_of(svg, "#010203").at(0);
    const auto arrow = lines_of(svg, "#0a0b0c");
    ASSERT_EQ(arrow.size(), 2U);
    EXPECT_EQ(arrow[0], curve);
    ASSERT_EQ(arrow[1].size(), 3U);
    EXPECT_LT((arrow[1][1] - curve[1]).norm(), 0.02);
    for (const PixelPoint& barb : {arrow[1][0], arrow[1][2]})
        EXPECT_LT((barb - curve[0]).norm(), (curve[1] - curve[0]).norm());
}

TEST(AxonometricFigure, AnArrowSeenFromItsEndIsNotDrawn)
{
    AxonometricFigure figure{
        {.azimuth = Angle::degrees(-90), .elevation = Angle::degrees(0)},
        box_corners({200, 120, 50})};
    figure.add_arrow({10, 0, 10}, {10, 100, 10}, {"#0a0b0c", 1, ""});
    EXPECT_TRUE(lines_of(figure.text(), "#0a0b0c").empty());
}

TEST(AxonometricFigure, ALabelStandsWhereItsPointIs)
{
    const std::array<Vec3, 2> line{Vec3{10, 20, 5}, {150, 80, 40}};
    AxonometricFigure figure{{}, box_corners({200, 120, 50})};
    figure.add_curve(line, test_style);
    figure.add_label(line[0], {0, 0}, "here & now", "#222222");
    figure.add_label(line[0], {30, -12}, "beside", "#222222");
    const std::string svg = figure.text();
    const PixelPoint point = lines_of(svg, "#010203").at(0).at(0);
    int seen = 0;
    for (const XmlElement& element : SmallXml::parse(svg)) {
        const bool is_beside = element.text == "beside";
        if (!is_beside && element.text != "here & now")
            continue;
        ++seen;
        const PixelPoint shift = is_beside ? PixelPoint{30, -12} : PixelPoint{0, 0};
        const PixelPoint at{std::stod(element.attributes.at("x")),
                            std::stod(element.attributes.at("y"))};
        EXPECT_NEAR(at.x(), (point + shift).x(), 0.02);
        EXPECT_NEAR(at.y(), (point + shift).y(), 8);  // the base line is below the middle
        EXPECT_GT(at.y(), (point + shift).y());
    }
    EXPECT_EQ(seen, 2);
}

TEST(AxonometricFigure, OmitsTheLengthIfNotRequested)
{
    const AxonometricFigure figure{{.has_length = false}, box_corners({200, 120, 50})};
    EXPECT_EQ(figure.text().find("each arm"), std::string::npos);
}

TEST(AxonometricFigure, LinesOfTheLegendStandApartAndWithinThePicture)
{
    AxonometricFigure figure{{}, box_corners({2, 1, 1})};
    for (int k = 0; k < 15; ++k)
        if (k % 2 == 0)
            figure.add_legend("entry", test_style);
        else
            figure.add_disc_legend("entry", 3, test_style.colour);
    const std::string svg = figure.text();
    const auto [width, height] = frame_of(svg);
    std::vector<PixelPoint> places;
    for (const XmlElement& element : SmallXml::parse(svg))
        if (element.text == "entry")
            places.emplace_back(std::stod(element.attributes.at("x")),
                                std::stod(element.attributes.at("y")));
    ASSERT_EQ(places.size(), 15U);
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_LT(places[i].x(), width - 100);
        EXPECT_LT(places[i].y(), height);
        for (std::size_t j = 0; j < i; ++j) {
            const PixelPoint apart = (places[i] - places[j]).cwiseAbs();
            EXPECT_TRUE(apart.x() > 150 || apart.y() > 14);
        }
    }
}

// Discs of the legend are at the middle of the samples of lines.
TEST(AxonometricFigure, DiscsOfTheLegendStandBesideTheirNames)
{
    AxonometricFigure figure{{}, box_corners({2, 1, 1})};
    figure.add_disc_legend("places", 3, test_style.colour);
    figure.add_legend("lines", test_style);
    const std::string svg = figure.text();
    PixelPoint disc{0, 0};
    for (const XmlElement& element : SmallXml::parse(svg))
        if (element.name == "circle")
            disc = {std::stod(element.attributes.at("cx")),
                    std::stod(element.attributes.at("cy"))};
    const auto sample = lines_of(svg, std::string{test_style.colour}).at(0);
    EXPECT_NEAR(disc.x(), (sample[0].x() + sample[1].x()) / 2, 0.02);
    EXPECT_GT(sample[0].y() - disc.y(), 14);
}

TEST(AxonometricFigure, RefusesAnEmptyOrNonFiniteExtent)
{
    EXPECT_THROW((AxonometricFigure{{}, {}}), DomainError);
    EXPECT_THROW((AxonometricFigure{{}, std::array<Vec3, 1>{Vec3{0, NAN, 0}}}),
                 DomainError);
    EXPECT_THROW((AxonometricFigure{{.width_px = 100}, box_corners({1, 1, 1})}),
                 DomainError);
}

}  // namespace
}  // namespace endmill
