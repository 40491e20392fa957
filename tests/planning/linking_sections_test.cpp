// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/linking.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

TrimmedCurve curve(std::vector<SectionPoint> points)
{
    TrimmedCurve made;
    for (const SectionPoint& at : points)
        made.points.push_back({at, {0, 0}, {0, 0}, TrimmedKind::Vertex});
    return made;
}

std::string moves(const ToolPath& path)
{
    std::string letters;
    for (const PathPoint& point : path.points)
        letters += move_name(point.move)[0];
    return letters;
}

const std::vector<TrimmedCurve> two{curve({{0, 1}, {1, 2}}),
                                    curve({{3, 4}, {5, 6}, {7, 8}})};
const std::vector<TrimmedCurve> one{curve({{0, 0}, {2, 0}})};

TEST(SectionLinking, LiftsBetweenAllCurves)
{
    const std::vector<PlaneCurves> planes{{-1, two}, {1, one}};
    const ToolPath path = link_sections(planes, DriveFrame{Angle::degrees(0)},
                                        Cutter{5, 2}, {.safe_height = 10});
    EXPECT_EQ(moves(path), "pcrrpccrrpc");
    const auto& points = path.points;
    EXPECT_EQ(points[0].location.tip, Vec3(0, -1, -1));  // two below the reference point
    EXPECT_EQ(points[2].location.tip, Vec3(1, -1, 10));
    EXPECT_EQ(points[3].location.tip, Vec3(3, -1, 10));
    EXPECT_EQ(points[3].pass, 1);
    EXPECT_EQ(points.back().pass, 2);
    EXPECT_EQ(points.back().point, 3);
}

TEST(SectionLinking, CutsEveryOtherPlaneBackwardsInZigzagOnly)
{
    const std::vector<PlaneCurves> planes{{0, one}, {1, two}};
    const auto tip = [&](PassOrder order, std::size_t k) {
        LinkOptions options{.order = order, .safe_height = 10};
        return link_sections(planes, DriveFrame{Angle::degrees(0)}, Cutter::flat(5),
                             options)
            .points[k]
            .location.tip;
    };
    EXPECT_EQ(tip(PassOrder::ZigZag, 4), Vec3(7, 1, 8));
    EXPECT_EQ(tip(PassOrder::OneWay, 4), Vec3(0, 1, 1));
}

TEST(SectionLinking, TurnsByTheAngleOfTheFeed)
{
    const std::vector<PlaneCurves> planes{{3, one}};
    const ToolPath path = link_sections(planes, DriveFrame{Angle::degrees(90)},
                                        Cutter::ball(1), {.safe_height = 10});
    EXPECT_TRUE(path.points[1].location.tip.isApprox(Vec3(-3, 2, -1), 1e-15));
}

TEST(SectionLinking, OfNoCurvesIsAnEmptyPath)
{
    const std::vector<PlaneCurves> planes{{0, {}}, {1, {}}};
    EXPECT_TRUE(link_sections(planes, DriveFrame{Angle::degrees(0)}, Cutter::ball(1), {})
                    .points.empty());
}

TEST(SectionLinking, RefusesASafeHeightBelowTheTipsAndAnotherAxis)
{
    const std::vector<PlaneCurves> planes{{0, two}};
    EXPECT_THROW(link_sections(planes, DriveFrame{Angle::degrees(0)}, Cutter::flat(1),
                               {.safe_height = 7.9}),
                 GeometryError);
    EXPECT_NO_THROW(link_sections(planes, DriveFrame{Angle::degrees(0)}, Cutter::flat(1),
                                  {.safe_height = 8}));
    EXPECT_THROW(link_sections(planes, DriveFrame{Angle::degrees(0)}, Cutter::flat(1),
                               {.axis = Vec3::UnitX(), .safe_height = 9}),
                 DomainError);
}

TEST(SectionLinking, TakesTheSectionsOfDrivePlanesInTheirOrder)
{
    const DrivePlanes planes{DriveFrame{Angle::degrees(30)}, {-1, 1}};
    std::vector<Trimmed> trimmed(2);
    trimmed[0].curves = two;
    trimmed[1].curves = one;
    const LinkOptions options{.safe_height = 10};
    const ToolPath path = link_sections(trimmed, planes, Cutter{5, 2}, options);
    const std::vector<PlaneCurves> curves{{-1, two}, {1, one}};
    const ToolPath expected = link_sections(curves, planes.frame, Cutter{5, 2}, options);
    ASSERT_EQ(moves(path), moves(expected));
    for (std::size_t k = 0; k < path.points.size(); ++k)
        EXPECT_EQ(path.points[k].location.tip, expected.points[k].location.tip) << k;
    trimmed.pop_back();
    EXPECT_THROW(link_sections(trimmed, planes, Cutter{5, 2}, options), DomainError);
}

}  // namespace
}  // namespace endmill
