// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/result_csv.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/files/csv.h"
#include "wavy_path.h"

namespace endmill {
namespace {

PathPoint point_at(const Vec3& tip, Move move = Move::Cut)
{
    return {0, 0, move, 0, {tip, Vec3::UnitZ()}};
}

Removal removal_of(std::vector<double> removed)
{
    Removal removal;
    removal.removed = std::move(removed);
    return removal;
}

TEST(RemovalCsv, HasLengthVolumeAndRateOfEachMove)
{
    ToolPath path;
    path.points = {point_at({0, 0, 0}, Move::Plunge), point_at({3, 4, 0}),
                   point_at({3, 4, 0}), point_at({3, 4, 2}, Move::Retract),
                   point_at({0, 0, 2}, Move::Rapid)};
    for (const std::size_t i : {0, 1, 2, 4})
        path.points[i].conditions = {.feed_mm_per_min = 600};
    EXPECT_EQ(removal_csv(removal_of({0.5, 2, 0, 0, 0}), path),
              "point,length_mm,removed_mm3,rate_mm3_per_min\n"
              "0,0,0.5,\n"
              "1,5,2,240\n"  // 2 mm^3 in 5 mm at 600 mm/min: half a second
              "2,0,0,\n"     // takes no time
              "3,2,0,\n"     // the feed is unknown
              "4,5,0,\n");   // a rapid goes at no feed
}

TEST(RemovalCsv, SumsToTheVolumeAndTheLengthOfAPath)
{
    const ToolPath path = wavy_path(40, 300);
    std::vector<double> removed(path.points.size());
    double volume = 0;
    double length = 0;
    for (std::size_t i = 0; i < removed.size(); ++i) {
        removed[i] = 1.0 / static_cast<double>(i + 3);
        volume += removed[i];
        if (i > 0)
            length +=
                (path.points[i].location.tip - path.points[i - 1].location.tip).norm();
    }
    const CsvTable table = parse_csv(removal_csv(removal_of(removed), path), "r");
    ASSERT_EQ(table.rows(), path.points.size());
    double volume_read = 0;
    double length_read = 0;
    for (std::size_t i = 0; i < table.rows(); ++i) {
        EXPECT_EQ(*table.number(i, "point"), static_cast<double>(i));
        EXPECT_FALSE(table.number(i, "rate_mm3_per_min"));
        volume_read += *table.number(i, "removed_mm3");
        length_read += *table.number(i, "length_mm");
    }
    EXPECT_EQ(volume_read, volume);
    EXPECT_EQ(length_read, length);
}

TEST(RemovalCsv, HasNoRateForANegligibleLength)
{
    ToolPath path;
    path.points = {point_at({0, 0, 0}), point_at({1e-160, 0, 0})};
    for (PathPoint& point : path.points)
        point.conditions = {.feed_mm_per_min = 1e300};
    const CsvTable table = parse_csv(removal_csv(removal_of({0, 1}), path), "r");
    EXPECT_FALSE(table.number(1, "rate_mm3_per_min"));
}

TEST(RemovalCsv, OfAnEmptyPathIsTheHeader)
{
    EXPECT_EQ(removal_csv({}, {}), "point,length_mm,removed_mm3,rate_mm3_per_min\n");
}

TEST(RemovalCsv, RefusesMismatchedOrNonFiniteData)
{
    ToolPath path;
    path.points = {point_at({0, 0, 0}), point_at({1, 0, 0})};
    EXPECT_THROW(removal_csv(removal_of({1}), path), DomainError);
    EXPECT_THROW(
        removal_csv(removal_of({1, std::numeric_limits<double>::quiet_NaN()}), path),
        DomainError);
}

TEST(EngagementCsv, HasARowForEachIntervalInDegrees)
{
    using std::numbers::pi;
    std::string text;
    EngagementCsv csv{[&](std::string_view piece) { text += piece; }};
    csv.add(3, {});
    csv.add(7, {{{pi / 6, 2.5, 0.75, 0.1, {{-pi / 2, -pi / 36}, {pi / 36, pi / 2}}},
                 {pi / 2, 5, 6, 0.2, {{-pi / 3, pi}}}}});
    csv.add(8, {{{0, 0.5, 0, 0.1, {}}}});
    csv.finish();
    EXPECT_EQ(text,
              "point,latitude_deg,radius_mm,above_tip_mm,from_deg,to_deg\n"
              "7,30,2.5,0.75,-90,-5\n"
              "7,30,2.5,0.75,5,90\n"
              "7,90,5,6,-60,180\n");
}

TEST(EngagementCsv, IsHandedOutInPiecesThatDoNotGrowWithThePath)
{
    std::size_t rows = 0;
    std::size_t largest = 0;
    EngagementCsv csv{[&](std::string_view piece) {
        rows += static_cast<std::size_t>(std::ranges::count(piece, '\n'));
        largest = std::max(largest, piece.size());
    }};
    const Engagement slot{{{0.1, 2.5, 0.75, 0.1, {{-1, -0.5}, {0.5, 1}}}}};
    for (std::size_t move = 0; move < 100000; ++move)
        csv.add(move, slot);
    csv.finish();
    EXPECT_EQ(rows, 1 + 2 * 100000U);
    EXPECT_LT(largest, 2U << 20U);
}

TEST(EngagementCsv, RefusesANumberThatIsNotFinite)
{
    EngagementCsv csv{[](std::string_view) {}};
    constexpr double infinite = std::numeric_limits<double>::infinity();
    EXPECT_THROW(csv.add(0, {{{0, infinite, 0, 0.1, {{0, 1}}}}}), DomainError);
    EXPECT_THROW(csv.add(0, {{{0, 1, 0, 0.1, {{0, infinite}}}}}), DomainError);
}

}  // namespace
}  // namespace endmill
