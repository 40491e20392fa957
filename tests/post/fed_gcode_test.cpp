// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/fed_gcode.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/post/gcode_reader.h"

namespace endmill {
namespace {

// `text` with the feed and the speed that `conditions_at(number, point)` returns for every point
// with a feed.
template <typename ConditionsAt>
std::string fed(const std::string& text, const ConditionsAt& conditions_at,
                ToolPath* path = nullptr, const GcodeReadOptions& options = {})
{
    ToolPath read = parse_gcode(text, "p.ngc", options).path;
    for (std::size_t i = 0; i < read.points.size(); ++i) {
        auto& conditions = read.points[i].conditions;
        const CuttingConditions wanted = conditions_at(i, read.points[i].location.tip);
        conditions.spindle_rpm = wanted.spindle_rpm;
        conditions.feed_mm_per_min =
            read.points[i].move == Move::Rapid ? std::nullopt : wanted.feed_mm_per_min;
    }
    if (path != nullptr)
        *path = read;
    return fed_gcode(text, "p.ngc", options, read);
}

CuttingConditions constant(std::size_t, const Vec3&)
{
    return {812.5, 3000, {}};
}

TEST(FedGcode, ChangesOnlyFeedsAndSpeeds)
{
    const std::string text =
        "%\r\n(part, F300)\nN10 G21 G90 G17 ; S7\nT3 M6\nS1000 M3\nG0 X0 Y0 Z30\n"
        "G1 Z0 F50\nX30 F300 (first)\nY5\nG0 Z30 M9\nM5\nM30\n%\nS9 F9 what follows\n";
    const auto conditions_at = [](std::size_t i, const Vec3&) {
        return i < 2 ? CuttingConditions{50, 2500, {}}
                     : CuttingConditions{100.0 + static_cast<double>(i), 2500.5, {}};
    };
    EXPECT_EQ(fed(text, conditions_at),
              "%\r\n(part, F300)\nN10 G21 G90 G17 ; S7\nT3 M6\nS2500 M3\nG0 X0 Y0 Z30\n"
              "G1 Z0 F50\nX30 F102 S2500.5 (first)\nY5 F103\nG0 Z30 M9\nM5\nM30\n%\n"
              "S9 F9 what follows\n");
}

TEST(FedGcode, ReadAgainHasTheFeedsOfThePath)
{
    const std::string text =
        "G21 G90\nS100 M3\nG0 X0 Y0 Z5\nG1 Z-1 F10\nX1\nG91 X1 Y1 F20\nF30\nX1\nG90\n"
        "G93\nX10 F2\nY7 F1\nG94\nX0 F5\nG20\nX1 F3\nG21\nX2 F7\nM2\n";
    const auto conditions_at = [](std::size_t i, const Vec3&) {
        return CuttingConditions{100 + 10 * std::sin(static_cast<double>(i)),
                                 1000 + static_cast<double>(i / 3),
                                 {}};
    };
    ToolPath path;
    const ToolPath again = parse_gcode(fed(text, conditions_at, &path), "q.ngc").path;
    ASSERT_EQ(again.points.size(), path.points.size());
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        EXPECT_EQ(again.points[i].location.tip, path.points[i].location.tip);
        EXPECT_EQ(again.points[i].conditions.spindle_rpm,
                  path.points[i].conditions.spindle_rpm);
        EXPECT_EQ(again.points[i].move, path.points[i].move);
        if (path.points[i].conditions.feed_mm_per_min) {
            EXPECT_NEAR(*again.points[i].conditions.feed_mm_per_min,
                        *path.points[i].conditions.feed_mm_per_min, 1e-4);
        }
    }
}

// With a single feed the line of an arc stays, in every spelling.
TEST(FedGcode, KeepsAnArcOfOneFeed)
{
    const std::string text =
        "G21 G90 G17 S1 M3\nG0 X10 Y0 Z0\nG1 Z-1 F5\nG3 X-10 Y0 I-10 J0 F80 (half)\n"
        "G2 X10 R10\nG3 I-10 P2\nG90.1 G2 X0 Y-10 I0 J0 Z-2\nM2\n";
    const std::string expected =
        "G21 G90 G17 S3000 M3\nG0 X10 Y0 Z0\nG1 Z-1 F812.5\n"
        "G3 X-10 Y0 I-10 J0 F812.5 (half)\nG2 X10 R10\nG3 I-10 P2\n"
        "G90.1 G2 X0 Y-10 I0 J0 Z-2\nM2\n";
    EXPECT_EQ(fed(text, constant), expected);
    // Feeds that differ by 0.1 %: the smallest one is written, so that no feed is
    // exceeded.
    const auto conditions_at = [](std::size_t i, const Vec3&) {
        return CuttingConditions{i % 2 == 1 ? 812.5 : 812.6, 3000, {}};
    };
    EXPECT_EQ(fed(text, conditions_at), expected);
}

// At the ends of the parts lie ends of chords, and the parts have the feeds of the path.
void expect_split(const std::string& text, double least_parts,
                  const GcodeReadOptions& options = {})
{
    const auto conditions_at = [](std::size_t, const Vec3& tip) {
        return CuttingConditions{tip.x() > 0 ? 100.0 : 200.0, 3000, {}};
    };
    ToolPath path;
    const std::string written = fed(text, conditions_at, &path, options);
    const ToolPath again = parse_gcode(written, "q.ngc", options).path;
    EXPECT_NEAR(
        (again.points.back().location.tip - path.points.back().location.tip).norm(), 0,
        1e-9)
        << written;
    double length = 0;
    double again_length = 0;
    for (std::size_t i = 1; i < path.points.size(); ++i)
        length += (path.points[i].location.tip - path.points[i - 1].location.tip).norm();
    for (std::size_t i = 1; i < again.points.size(); ++i) {
        const Vec3& tip = again.points[i].location.tip;
        again_length += (tip - again.points[i - 1].location.tip).norm();
        // All points lie on the circle of radius 10.
        if (again.points[i].move == Move::Cut) {
            EXPECT_NEAR(std::hypot(tip.x(), tip.y()), 10, 1e-5) << written;
            const Vec3 middle = (tip + again.points[i - 1].location.tip) / 2;
            if (std::abs(middle.x()) > 0.5) {
                EXPECT_NEAR(again.points[i].conditions.feed_mm_per_min.value(),
                            middle.x() > 0 ? 100 : 200, 1e-3);
            }
        }
    }
    EXPECT_NEAR(again_length, length, 1e-3) << written;
    EXPECT_GE(std::ranges::count(written, '\n'),
              std::ranges::count(text, '\n') + least_parts - 1);
}

TEST(FedGcode, SplitsAnArcWhereTheFeedChanges)
{
    const std::string start = "G21 G90 S1 M3\nG0 X10 Y0 Z0\nG1 Z-1 F5\n";
    expect_split(start + "G3 X-10 Y0 I-10 J0 F80 (half)\nM2\n", 2);
    expect_split(start + "G2 X-10 R10 F80\nM2\n", 2);
    expect_split(start + "N5 G3 I-10 F80\nM2\n", 3);      // full circle
    expect_split(start + "G3 I-10 P3 Z-7 F80\nM2\n", 7);  // helix
    expect_split(start + "G91 G3 X-20 I-10 F80 S4\nM2\n", 2);
    expect_split(start + "G90.1 G2 X-10 Y0 I0 J0 F80\nM2\n", 2);
    expect_split(start + "G93 G2 X-10 Y0 I-10 F2\nM2\n", 2);
    expect_split(start + "G20 G2 X-.393700787 Y0 I-.393700787 F2\nM2\n", 2);
    GcodeReadOptions of_centres;
    of_centres.programmed_point_height_mm = 5;
    expect_split(start + "G3 X-10 Y0 I-10 J0 F80 (half)\nM2\n", 2, of_centres);
}

TEST(FedGcode, SplitsInTheOtherPlanes)
{
    const auto conditions_at = [](std::size_t, const Vec3& tip) {
        return CuttingConditions{tip.z() > 5 ? 100.0 : 200.0, 3000, {}};
    };
    for (const char* arc : {"G18 G3 X-10 Z0 I-10 K0", "G18 G2 X-10 Z0 I-10 K0",
                            "G19 G2 Y-20 Z0 J-10 K0 X12"}) {
        ToolPath path;
        const std::string written =
            fed(std::string{"G21 G90 S1 M3\nG0 X10 Y0 Z0\n"} + arc + " F9\nM2\n",
                conditions_at, &path);
        const ToolPath again = parse_gcode(written, "q.ngc").path;
        double highest = 0;
        double lowest = 0;
        for (const PathPoint& point : again.points) {
            highest = std::max(highest, point.location.tip.z());
            lowest = std::min(lowest, point.location.tip.z());
        }
        double was_highest = 0;
        for (const PathPoint& point : path.points)
            was_highest = std::max(was_highest, point.location.tip.z());
        EXPECT_NEAR(highest, was_highest, 2e-3) << written;
        EXPECT_EQ(
            (again.points.back().location.tip - path.points.back().location.tip).norm(),
            0)
            << written;
    }
}

// M1 after the motion may stop the program, so the arc is not split and gets its smallest
// feed.
TEST(FedGcode, LeavesAnArcWholeBesideMCodes)
{
    const auto conditions_at = [](std::size_t, const Vec3& tip) {
        return CuttingConditions{
            tip.x() > 0 ? 100.0 : 200.0, tip.x() > 0 ? 900.0 : 600.0, {}};
    };
    const std::string start = "G21 G90\nG0 X10 Y0 Z0\n";
    // 100 at 900 rpm is the smallest feed per revolution; at 600 rpm it is 66.6667.
    EXPECT_EQ(fed(start + "G3 X-10 Y0 I-10 J0 F80 M1\nM2\n", conditions_at),
              "G21 G90\nG0 X10 Y0 Z0 S900\nG3 X-10 Y0 I-10 J0 F66.6667 M1 S600\nM2\n");
}

// The line of a cycle gets the smallest feed of its moves; its rapids have none.
TEST(FedGcode, KeepsCyclesAndReferenceMoves)
{
    const std::string text =
        "G21 G90 G97 S100 M3\nG0 X0 Y0 Z5\nG99 G83 X1 Z-2 R1 Q1 F50\nX2 F60\nG80\n"
        "G91 G28 Z0\nG90 G0 X3\nZ1\nG1 Z0 F70\nM2\n";
    const auto conditions_at = [](std::size_t i, const Vec3& tip) {
        return CuttingConditions{
            tip.x() < 1.5 ? 200 - static_cast<double>(i) : 80, 900, {}};
    };
    ToolPath path;
    const std::string written = fed(text, conditions_at, &path);
    // Pecks of the first hole end at points 3, 6 and 9 of the path.
    EXPECT_EQ(written,
              "G21 G90 G97 S900 M3\nG0 X0 Y0 Z5\nG99 G83 X1 Z-2 R1 Q1 F191\nX2 F80\nG80\n"
              "G91 G28 Z0\nG90 G0 X3\nZ1\nG1 Z0 F80\nM2\n");
    const ToolPath again = parse_gcode(written, "q.ngc").path;
    ASSERT_EQ(again.points.size(), path.points.size());
    for (std::size_t i = 0; i < path.points.size(); ++i)
        EXPECT_EQ(again.points[i].location.tip, path.points[i].location.tip);
}

TEST(FedGcode, KeepsCuttingSpeeds)
{
    const std::string text =
        "G21 G90 G96 S100 M3\nG0 X0 Y0 Z5\nG1 Z0 S120 F50\nG97 S800\nX1\nM2\n";
    EXPECT_EQ(fed(text, constant),
              "G21 G90 G96 S100 M3\nG0 X0 Y0 Z5\nG1 Z0 S120 F812.5\nG97 S3000\nX1\nM2\n");
}

TEST(FedGcode, RefusesAnotherPathAndFeedsThatVanish)
{
    const std::string text = "G21 G90\nG0 X1 Y0 Z0\nG1 X0 F1\nM2\n";
    ToolPath path = parse_gcode(text, "p.ngc").path;
    path.points[1].conditions.feed_mm_per_min = 1e-6;
    EXPECT_THROW(fed_gcode(text, "p.ngc", {}, path), DomainError);
    path.points.pop_back();
    EXPECT_THROW(fed_gcode(text, "p.ngc", {}, path), DomainError);
    EXPECT_THROW(fed_gcode("G1 X", "p.ngc", {}, path), FormatError);
}

// A long program is passed on in several pieces, each of whole lines.
TEST(FedGcode, OfALongProgramComesInPieces)
{
    std::string text = "G21 G90\nG0 X0 Y0 Z5\nG1 Z0 F10\n";
    for (int i = 1; i <= 60'000; ++i)
        text += "X" + std::to_string(i) + "." + std::to_string(i % 10) + " (a comment)\n";
    text += "M2\n";
    ToolPath path;
    const std::string whole = fed(text, constant, &path);
    std::string joined;
    std::size_t pieces = 0;
    write_fed_gcode(text, "p.ngc", {}, path, [&](std::string_view piece) {
        EXPECT_TRUE(piece.ends_with('\n'));
        joined += piece;
        ++pieces;
    });
    EXPECT_GT(pieces, 1U);
    EXPECT_TRUE(joined == whole);  // not EXPECT_EQ, which would print both
    ToolPath again = parse_gcode(joined, "p.ngc").path;
    ASSERT_EQ(again.points.size(), path.points.size());
    EXPECT_EQ(again.points.back().conditions.feed_mm_per_min, 812.5);
    EXPECT_EQ(again.points.back().location.tip, path.points.back().location.tip);
}

}  // namespace
}  // namespace endmill
