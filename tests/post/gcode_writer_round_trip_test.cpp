// SPDX-License-Identifier: GPL-3.0-or-later

// Written programs are read back by the reader
// of the library, and by a few lines here that know only modal words.
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <sstream>

#include <gtest/gtest.h>

#include "endmill/post/apt.h"
#include "endmill/post/gcode_reader.h"
#include "endmill/post/gcode_writer.h"
#include "random_path.h"

namespace endmill {
namespace {

struct ModalWords {
    Vec3 tip;
    char motion;  // '0' for G0, '1' for G1
    double feed;
    double speed;
};

// The moves between the safe start and the safe end.
std::vector<ModalWords> replayed(const std::string& text)
{
    std::vector<ModalWords> moves;
    ModalWords modal{Vec3::Zero(), '0', 0, 0};
    std::istringstream lines{text};
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words{line};
        bool has_moved = false;
        for (std::string word; words >> word;) {
            const double value = std::atof(word.c_str() + 1);
            if (word == "G0" || word == "G1")
                modal.motion = word[1];
            if (word[0] == 'F')
                modal.feed = value;
            if (word[0] == 'S')
                modal.speed = value;
            for (const int c : {0, 1, 2})
                if (word[0] == "XYZ"[c]) {
                    modal.tip[c] = value;
                    has_moved = true;
                }
        }
        if (has_moved)
            moves.push_back(modal);
    }
    return {moves.begin() + 2, moves.end() - 1};
}

class GcodeRoundTrip : public testing::TestWithParam<int> {};

TEST_P(GcodeRoundTrip, IsReadBackByAnIndependentReader)
{
    const int decimals = GetParam();
    const double decimal_rounding = 0.5 * std::pow(10, -decimals) * (1 + 1e-6);
    const ToolPath path = test::random_path(11, 2000);
    const WrittenProgram program = gcode(path, {.decimals = decimals});
    const std::vector<ModalWords> moves = replayed(program.text);
    ASSERT_EQ(moves.size(), path.points.size());
    double largest = 0;
    for (std::size_t k = 0; k < moves.size(); ++k) {
        const Vec3 off = moves[k].tip - path.points[k].location.tip;
        largest = std::max(largest, off.lpNorm<Eigen::Infinity>());
        const CuttingConditions& conditions = path.points[k].conditions;
        EXPECT_EQ(moves[k].motion, path.points[k].move == Move::Rapid ? '0' : '1');
        EXPECT_NEAR(moves[k].speed, *conditions.spindle_rpm, decimal_rounding);
        if (conditions.feed_mm_per_min) {
            EXPECT_NEAR(moves[k].feed, *conditions.feed_mm_per_min, decimal_rounding);
        }
    }
    EXPECT_LE(largest, decimal_rounding);
    EXPECT_EQ(program.max_rounding_error_mm, largest);
}

TEST_P(GcodeRoundTrip, IsReadBack)
{
    const int decimals = GetParam();
    const double decimal_rounding = 0.5 * std::pow(10, -decimals) * (1 + 1e-6);
    const ToolPath path = test::random_path(12, 2000);
    const GcodeOptions options{.decimals = decimals, .line_numbers = decimals % 2 == 0};
    const Program program = parse_gcode(gcode(path, options).text, "f.ngc");
    const auto& points = program.path.points;
    // The program adds the position over the first point and the safe height at the end.
    ASSERT_EQ(points.size(), path.points.size() + 2);
    for (std::size_t k = 0; k < path.points.size(); ++k) {
        const PathPoint& read = points[k + 1];
        const CuttingConditions& conditions = read.conditions;
        const PathPoint& point = path.points[k];
        EXPECT_LE((read.location.tip - point.location.tip).lpNorm<Eigen::Infinity>(),
                  decimal_rounding);
        EXPECT_EQ(read.move, point.move) << k;
        EXPECT_EQ(conditions.tool, 3);
        EXPECT_NEAR(*conditions.spindle_rpm, *path.points[k].conditions.spindle_rpm,
                    decimal_rounding);
        ASSERT_EQ(conditions.feed_mm_per_min.has_value(), point.move != Move::Rapid);
        if (conditions.feed_mm_per_min) {
            EXPECT_NEAR(*conditions.feed_mm_per_min,
                        *path.points[k].conditions.feed_mm_per_min, decimal_rounding);
        }
    }
}

// Rounding is idempotent, so the second program equals the first.
TEST_P(GcodeRoundTrip, IsWrittenAgainAsTheSameMoves)
{
    const GcodeOptions options{.decimals = GetParam()};
    const std::string once = gcode(test::random_path(13, 500), options).text;
    const Program read = parse_gcode(once, "f.ngc");
    const WrittenProgram again = gcode(read.path, options);
    EXPECT_EQ(again.max_rounding_error_mm, 0);
    EXPECT_EQ(again.text, once);
}

TEST_P(GcodeRoundTrip, KeepsItsStartHeightThroughApt)
{
    const GcodeOptions options{.tool = 3, .decimals = GetParam()};
    const std::string once = gcode(test::random_path(14, 500), options).text;
    std::string text = once;
    for (int times = 0; times < 2; ++times) {
        const ToolPath read = parse_gcode(text, "f.ngc").path;
        const std::string statements = apt(read, {.decimals = GetParam()}).text;
        text = gcode(parse_apt(statements, "f.apt", {}).path, options).text;
        EXPECT_EQ(text, once);
    }
}

INSTANTIATE_TEST_SUITE_P(Decimals, GcodeRoundTrip, testing::Values(1, 3, 4, 9));

// The reader knows neither ramps nor links: to it, all slanted moves at feed are cuts.
void expect_totals_read_back(const WrittenProgram& program)
{
    const PathTotals found = path_totals(parse_gcode(program.text, "f.ngc").path);
    const PathTotals& written = program.totals;
    const double tolerance = 2e-4 * written.cut_mm;  // rounding, and chords of arcs
    EXPECT_NEAR(written.cut_mm + written.plunge_mm + written.link_mm,
                found.cut_mm + found.plunge_mm + found.link_mm, tolerance);
    EXPECT_NEAR(written.rapid_mm, found.rapid_mm, 1e-6 * written.rapid_mm);
    ASSERT_TRUE(written.time_min && found.time_min);
    EXPECT_NEAR(*written.time_min, *found.time_min, 2e-4 * *written.time_min);
    EXPECT_EQ(written.tools, found.tools);
    EXPECT_LE((written.extent->low - found.extent->low).norm(), 0.01);
    EXPECT_LE((written.extent->high - found.extent->high).norm(), 0.01);
    if (program.ramps == 0) {
        EXPECT_NEAR(written.plunge_mm, found.plunge_mm, 1e-6);
    }
}

TEST(WrittenTotals, AreThoseOfTheProgramThatIsReadBack)
{
    const ToolPath path = test::random_path(5, 500);
    for (const auto& approach : {std::optional<double>{}, std::optional{3.0}})
        for (const auto& ramp :
             {std::optional<Angle>{}, std::optional{Angle::degrees(5)}})
            for (const FirstAxes first_axes : {FirstAxes::Z, FirstAxes::Xy})
                expect_totals_read_back(
                    gcode(path, {.control = {.first_axes = first_axes},
                                 .approach_distance = approach,
                                 .ramp = ramp}));
}

// Two half circles of radius 10 about the origin in chords of one degree.
TEST(WrittenTotals, CountArcsWithTheirLength)
{
    ToolPath path;
    for (int degree = 0; degree <= 360; ++degree) {
        const double angle = Angle::degrees(degree).radians();
        path.points.push_back(
            {.pass = 0,
             .point = degree,
             .move = degree == 0 ? Move::Plunge : Move::Cut,
             .location = {{10 * std::cos(angle), 10 * std::sin(angle), 0}, Vec3::UnitZ()},
             .conditions = {100, 1000, 1}});
    }
    const WrittenProgram program = gcode(path, {.arc_tolerance = 0.01});
    ASSERT_GT(program.arcs, 1U);
    EXPECT_NEAR(program.totals.cut_mm, 20 * std::numbers::pi, 1e-3);
    EXPECT_NEAR(program.totals.extent->low.x(), -10, 1e-4);
    expect_totals_read_back(program);
}

TEST(WrittenTotals, OfAptAreThoseOfThePath)
{
    const ToolPath path = test::random_path(6, 300);
    const PathTotals given = path_totals(path);
    const PathTotals written = apt(path).totals;
    EXPECT_NEAR(written.cut_mm, given.cut_mm, 300 * 2e-4);
    EXPECT_NEAR(written.rapid_mm, given.rapid_mm, 300 * 2e-4);
    EXPECT_NEAR(*written.time_min, *given.time_min, 1e-5 * *given.time_min);
    EXPECT_EQ(written.tools, given.tools);
}

}  // namespace
}  // namespace endmill
