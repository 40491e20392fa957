// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/canonical_tapping.h"

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "read_program.h"

namespace endmill {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::vector<std::string> into_the_hole{"DISABLE_FEED_OVERRIDE",
                                             "DISABLE_SPEED_OVERRIDE", "STRAIGHT_FEED",
                                             "STOP_SPINDLE_TURNING"};
constexpr std::string_view reversal = "START_SPINDLE_COUNTERCLOCKWISE";

bool is_tapping(const std::string& rest,
                const std::vector<std::string>& before = into_the_hole)
{
    TappedHole hole;
    for (const std::string& name : before)
        hole.note(name);
    return reverses_for_tapping(hole, reversal, rest);
}

TEST(CanonicalTapping, IsTheWholeSequenceOnly)
{
    const std::string out = "1 N..... DWELL(0.0)\n2 N..... STRAIGHT_FEED(1.0)\n";
    const std::string stop = "3 N..... STOP_SPINDLE_TURNING(0)\n";
    const std::string start = "4 N..... START_SPINDLE_CLOCKWISE(0)\n";
    const auto joined = [](std::initializer_list<std::string_view> parts) {
        std::string text;
        for (const std::string_view part : parts)
            text += part;
        return text;
    };
    const std::string whole = joined({out, stop, start});
    const std::string other_sense = "4 N..... START_SPINDLE_COUNTERCLOCKWISE(0)";
    EXPECT_TRUE(is_tapping(whole));
    EXPECT_TRUE(is_tapping(joined({whole, "5 N..... MORE()"})));
    for (const std::string& other :
         {std::string{}, out, joined({out, stop}), joined({out, start}),
          joined({out, whole}), joined({out, stop, other_sense}),
          joined({"\n", out, stop})})
        EXPECT_FALSE(is_tapping(other)) << other;
    for (std::size_t k = 0; k < into_the_hole.size(); ++k) {
        std::vector<std::string> before = into_the_hole;
        before.at(k) = "COMMENT";
        EXPECT_FALSE(is_tapping(whole, before));
    }
    std::vector<std::string> twice{into_the_hole.front(), into_the_hole[1]};
    twice.insert(twice.end(), into_the_hole.begin(), into_the_hole.end());
    EXPECT_TRUE(is_tapping(whole, twice));
    twice.emplace_back("COMMENT");
    EXPECT_FALSE(is_tapping(whole, twice));
}

// Output of rs274 for the blocks of `taps`, from the tool change on.
constexpr const char* output_of_taps = R"(  9 N..... USE_LENGTH_UNITS(CANON_UNITS_MM)
   10 N..... SET_FEED_RATE(100.0000)
   11 N..... SET_SPINDLE_SPEED(0, 500.0000)
   12 N..... START_SPINDLE_CLOCKWISE(0)
   13 N..... STRAIGHT_TRAVERSE(0.0000, 0.0000, 5.0000, 0.0000, 0.0000, 0.0000)
   14 N..... STRAIGHT_TRAVERSE(1.0000, 1.0000, 5.0000, 0.0000, 0.0000, 0.0000)
   15 N..... STRAIGHT_TRAVERSE(1.0000, 1.0000, 2.0000, 0.0000, 0.0000, 0.0000)
   16 N..... DISABLE_FEED_OVERRIDE()
   17 N..... DISABLE_SPEED_OVERRIDE(0)
   18 N..... STRAIGHT_FEED(1.0000, 1.0000, -3.0000, 0.0000, 0.0000, 0.0000)
   19 N..... STOP_SPINDLE_TURNING(0)
   20 N..... START_SPINDLE_COUNTERCLOCKWISE(0)
   21 N..... DWELL(0.0000)
   22 N..... STRAIGHT_FEED(1.0000, 1.0000, 5.0000, 0.0000, 0.0000, 0.0000)
   23 N..... STOP_SPINDLE_TURNING(0)
   24 N..... START_SPINDLE_CLOCKWISE(0)
   25 N..... ENABLE_FEED_OVERRIDE()
   26 N..... ENABLE_SPEED_OVERRIDE(0)
   30 N..... STRAIGHT_FEED(5.0000, 1.0000, 5.0000, 0.0000, 0.0000, 0.0000)
   31 N..... STOP_SPINDLE_TURNING(0)
   32 N..... PROGRAM_END()
)";

TEST(CanonicalTapping, IsReadAsTheCycleIs)
{
    const Program canonical = parse_canonical(output_of_taps, "f.txt");
    const Program taps = read_gcode(
        "G21 G98 F100 S500 M3\nG0 X0 Y0 Z5\nG84 X1 Y1 Z-3 R2\nG80\nG1 X5\nM5\nM2\n");
    EXPECT_THAT(tips(canonical),
                ElementsAre(Vec3(0, 0, 5), Vec3(1, 1, 5), Vec3(1, 1, 2), Vec3(1, 1, -3),
                            Vec3(1, 1, 5), Vec3(5, 1, 5)));
    for (const Program* program : {&canonical, &taps}) {
        EXPECT_EQ(tips(*program), tips(taps));
        EXPECT_EQ(moves(*program), moves(taps));
        EXPECT_EQ(feeds(*program), feeds(taps));
        for (const PathPoint& point : program->path.points)
            EXPECT_EQ(point.conditions.spindle_rpm, 500);
        EXPECT_FALSE(program->counterclockwise_from);
        EXPECT_EQ(program->tapping_from, 4U);
        EXPECT_THAT(program->remarks, ElementsAre());
    }
}

// Without the dwell of the cycle the spindle was reversed by hand.
TEST(CanonicalTapping, IsNotAReversalByHand)
{
    std::string text = output_of_taps;
    text.erase(text.find("   21"), text.find("   22") - text.find("   21"));
    const Program canonical = parse_canonical(text, "f.txt");
    EXPECT_EQ(canonical.counterclockwise_from, 4U);
    EXPECT_FALSE(canonical.tapping_from);
    EXPECT_THAT(canonical.remarks,
                ElementsAre(HasSubstr("(M4) from the move to point 4")));
}

TEST(CanonicalTapping, OfALeftHandTapTurnsCounterclockwiseIntoTheHole)
{
    const Program taps =
        read_gcode("G21 G98 F100 S500 M4\nG0 X0 Y0 Z5\nG74 X1 Y1 Z-3 R2\nG80\nM5\nM2\n");
    EXPECT_EQ(taps.counterclockwise_from, 3U);
    EXPECT_EQ(taps.tapping_from, 4U);
}

}  // namespace
}  // namespace endmill
