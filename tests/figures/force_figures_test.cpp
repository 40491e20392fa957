// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/force_figures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/process/detail/engaged_region.h"
#include "small_xml.h"

namespace endmill {
namespace {

using std::numbers::pi;
constexpr double rad = pi / 180;

const BallEngagement inclined{20 * rad, 10 * rad, 0.4, 0.5};
const EdgeElement element{{0, 0, 0.3, 0.6}, 55 * rad, 70 * rad};

std::set<std::string> texts_of(const std::string& svg)
{
    std::set<std::string> texts;
    for (const XmlElement& drawn : SmallXml::parse(svg))
        texts.insert(drawn.text);
    return texts;
}

// Least distance, in rad, of an azimuth from the ends of the engaged ranges at its latitude.
// The latitude is raised a little, because nothing is engaged at the lowest point itself.
double distance_from_ends(const BallEngagement& engagement, const Vec3& point)
{
    constexpr double raise = 1e-7;
    const double latitude =
        std::atan2(std::hypot(point.x(), point.y()), -point.z()) + raise;
    const double azimuth = std::atan2(point.x(), point.y());
    double least = std::numeric_limits<double>::infinity();
    for (const AzimuthRange& range : engaged_ranges(engagement, latitude))
        for (const double end : {range.from, range.to})
            least = std::min(least, std::abs(std::remainder(azimuth - end, 2 * pi)));
    return least;
}

TEST(BallFrame, HasYOnTheSideOfTheMillingSense)
{
    const Vec3 place{1, 2, 3};
    EXPECT_EQ((BallFrame{Milling::Up, 2}.in_room(place)), Vec3(2, 4, 6));
    EXPECT_EQ((BallFrame{Milling::Down, 2}.in_room(place)), Vec3(2, -4, 6));
    EXPECT_EQ((BallFrame{Milling::Down, 2}.turned(place)), Vec3(1, -2, 3));
}

// The borders come from arcs of circles, the ranges from roots of quartics.
TEST(EngagementBorders, LieAtTheEndsOfTheEngagedRanges)
{
    const double top_z = inclined.depth_ratio - 1;
    int points = 0;
    for (const EngagementBorder& border : engagement_borders(inclined))
        for (const Vec3& point : border.points) {
            EXPECT_NEAR(point.norm(), 1, 1e-12);
            EXPECT_LE(point.z(), top_z + 1e-9);
            if (point.z() > top_z - 1e-6)
                continue;  // the stock's top, and its corners
            EXPECT_LT(distance_from_ends(inclined, point), 1e-4) << border.name;
            ++points;
        }
    EXPECT_GT(points, 100);
}

TEST(EngagementBorders, EndWithTheStocksTop)
{
    const auto borders = engagement_borders(inclined);
    ASSERT_FALSE(borders.empty());
    EXPECT_EQ(borders.front().name, "front");
    EXPECT_EQ(borders.back().name, "stock's top");
    for (const Vec3& point : borders.back().points)
        EXPECT_NEAR(point.z(), inclined.depth_ratio - 1, 1e-12);
}

TEST(EngagementBorders, RefuseAir)
{
    EXPECT_THROW(engagement_borders({0, 0, 0.4, -0.1}), DomainError);
    EXPECT_THROW(engagement_borders({2, 0, 0.4, 0.1}), DomainError);
}

TEST(EngagementSvg, NamesTheVectorsOfTheFigure)
{
    for (const Milling milling : {Milling::Down, Milling::Up}) {
        const std::set<std::string> texts =
            texts_of(engagement_svg(inclined, {milling, 5}, {"a caption"}));
        for (const char* name :
             {"X", "Y", "Z", "T", "N", "F_p", "E", "λ", "μ", "a caption"})
            EXPECT_TRUE(texts.contains(name)) << name;
    }
}

// A spindle that turns clockwise seen from above moves the element along radius x Z. The
// edge pushes the work along that motion and away from the axis; the thrust points up the
// axis.
TEST(ForceDirections, FollowTheMotionTheRadiusAndTheAxis)
{
    for (const Milling milling : {Milling::Down, Milling::Up}) {
        const BallFrame frame{milling, 3};
        const ForceDirections forces = force_directions(element, frame);
        const Vec3 radius =
            frame.turned({std::sin(element.azimuth), std::cos(element.azimuth), 0});
        EXPECT_LT((forces.tangential - radius.cross(Vec3::UnitZ())).norm(), 1e-12);
        EXPECT_LT((forces.radial - radius).norm(), 1e-12);
        EXPECT_LT((forces.axial - Vec3::UnitZ()).norm(), 1e-12);
    }
}

TEST(ForceDirections, RefuseAnElementThatDoesNotCut)
{
    EdgeElement idle = element;
    idle.azimuth = -80 * rad;
    EXPECT_THROW(force_directions(idle, {}), DomainError);
}

TEST(ForceFrameSvg, NamesTheForcesAndAngles)
{
    const std::set<std::string> texts =
        texts_of(force_frame_svg(element, {Milling::Up, 3}, "a title"));
    for (const char* name :
         {"X", "Y", "Z", "dF_T", "dF_R", "dF_z", "θ", "δ", "φ1", "φ2", "a title",
          "δ = 55°, θ = 70°, f_p = 0.3 r0, l = 0.6 r0, μ = λ = 0; r0 = 3 mm"})
        EXPECT_TRUE(texts.contains(name)) << name;
}

}  // namespace
}  // namespace endmill
