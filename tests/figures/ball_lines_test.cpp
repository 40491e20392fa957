// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/detail/ball_lines.h"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "small_xml.h"

namespace endmill {
namespace {

using std::numbers::pi;

TEST(BallPoint, CountsFromTheTipAndFromYTowardsX)
{
    EXPECT_LT((ball_point(0, 1) - Vec3{0, 0, -1}).norm(), 1e-15);
    EXPECT_LT((ball_point(pi / 2, 0) - Vec3{0, 1, 0}).norm(), 1e-15);
    EXPECT_LT((ball_point(pi / 2, pi / 2) - Vec3{1, 0, 0}).norm(), 1e-15);
}

TEST(HighestLatitude, IsThatOfTheStocksTop)
{
    for (const double depth : {0.1, 0.5, 0.9})
        EXPECT_NEAR(ball_point(highest_latitude({0, 0, 0.4, depth}), 0.3).z(), depth - 1,
                    1e-15);
    EXPECT_NEAR(highest_latitude({0, 0, 0.4, 2}), pi / 2, 1e-15);
}

TEST(ArcBetween, StaysOnItsCircleFromEndToEnd)
{
    const Vec3 centre{1, 2, 3};
    const Vec3 from = Vec3{1, 0, 1}.normalized();
    const Vec3 to = Vec3{-1, 2, 0}.normalized();
    const std::vector<Vec3> arc = arc_between(centre, from, to, 2);
    EXPECT_LT((arc.front() - (centre + 2 * from)).norm(), 1e-14);
    EXPECT_LT((arc.back() - (centre + 2 * to)).norm(), 1e-14);
    double length = 0;
    for (std::size_t k = 0; k < arc.size(); ++k) {
        EXPECT_NEAR((arc[k] - centre).norm(), 2, 1e-14);
        EXPECT_NEAR(from.cross(to).dot(arc[k] - centre), 0, 1e-14);
        if (k > 0)
            length += (arc[k] - arc[k - 1]).norm();
    }
    // Chords of at most 2 degrees are shorter than the arc by 5e-5 of it.
    const double exact = 2 * std::acos(from.dot(to));
    EXPECT_LT(length, exact);
    EXPECT_GT(length, (1 - 6e-5) * exact);
}

TEST(LatitudeLine, HasOneHeight)
{
    const std::vector<Vec3> line = latitude_line(0.7, -0.5, 4);
    EXPECT_LT((line.front() - ball_point(0.7, -0.5)).norm(), 1e-15);
    EXPECT_LT((line.back() - ball_point(0.7, 4)).norm(), 1e-15);
    for (const Vec3& point : line)
        EXPECT_NEAR(point.z(), -std::cos(0.7), 1e-15);
}

TEST(NamedArrow, HasItsNameBeyondTheHead)
{
    AxonometricFigure figure{
        {.azimuth = Angle::degrees(-90), .elevation = Angle::degrees(0)},
        std::array<Vec3, 2>{Vec3{-2, 0, 0}, {2, 0, 2}}};
    add_named_arrow(figure, {Milling::Up, 1},
                    std::array<Vec3, 2>{Vec3{0, 0, 0}, {1, 0, 0}}, "arrow",
                    {"#010203", 1, ""});
    double name = 0;
    double zero = 0;
    figure.add_label({1, 0, 0}, {0, 0}, "head", "#010203");
    for (const XmlElement& element : SmallXml::parse(figure.text())) {
        if (element.text == "arrow")
            name = std::stod(element.attributes.at("x"));
        if (element.text == "head")
            zero = std::stod(element.attributes.at("x"));
    }
    EXPECT_GT(name, zero);
}

}  // namespace
}  // namespace endmill
