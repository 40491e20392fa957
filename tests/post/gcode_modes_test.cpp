// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/gcode_modes.h"

#include <gtest/gtest.h>

#include "read_program.h"

namespace endmill {
namespace {

GcodeModes modes_after(const std::string& text)
{
    TextLines lines{text, {"f", "E_GCODE"}};
    GcodeModes modes;
    while (lines.next())
        modes.apply(parse_block(lines.line(), lines), lines);
    return modes;
}

std::string refusal(const std::string& text)
{
    return refusal_of([&] { modes_after(text); });
}

std::string m_refusal(const std::string& text)
{
    return refusal_of([&] {
        TextLines lines{text, {"f", "E_GCODE"}};
        lines.next();
        check_m_codes(parse_block(lines.line(), lines), lines);
    });
}

TEST(GcodeModes, BeginWithTheDefaultsOfTheLanguage)
{
    const GcodeModes modes;
    EXPECT_EQ(modes.motion, GcodeMotion::None);
    EXPECT_EQ(modes.plane, ArcPlane::Xy);
    EXPECT_EQ(modes.distance, DistanceMode::Absolute);
    EXPECT_EQ(modes.mm_per_unit(), 1);
}

TEST(GcodeModes, StayInForceUntilTheNextOfTheirGroup)
{
    const GcodeModes modes =
        modes_after("G1 G18 G20 G91 G90.1 G93 G55 G43 G64\nG61\nG40");
    EXPECT_EQ(modes.motion, GcodeMotion::Straight);
    EXPECT_EQ(modes.plane, ArcPlane::Zx);
    EXPECT_EQ(modes.mm_per_unit(), 25.4);
    EXPECT_EQ(modes.distance, DistanceMode::Incremental);
    EXPECT_EQ(modes.centres, DistanceMode::Absolute);
    EXPECT_EQ(modes.feed, FeedRateMode::InverseTime);
    EXPECT_EQ(modes.coordinate_system, 550);

    const GcodeModes later = modes_after(
        "G1 G18 G20 G91 G90.1 G93\nG80 G17 G21 G90\n"
        "G91.1 G94 G49 G61.1 G59.3\nG59.3");
    EXPECT_EQ(later.motion, GcodeMotion::None);
    EXPECT_EQ(later.plane, ArcPlane::Xy);
    EXPECT_EQ(later.unit, ProgramUnit::Mm);
    EXPECT_EQ(later.distance, DistanceMode::Absolute);
    EXPECT_EQ(later.centres, DistanceMode::Incremental);
    EXPECT_EQ(later.feed, FeedRateMode::PerMinute);
    EXPECT_EQ(later.coordinate_system, 593);
}

TEST(GcodeModes, RefuseTwoOfOneGroupInABlock)
{
    for (const std::string codes :
         {"G0 G1", "G2 G81", "G17 G18", "G20 G21", "G43 G49", "G54 G55", "G61 G64",
          "G61.1 G61", "G90 G91", "G90.1 G91.1", "G93 G94", "G98 G99", "G96 G97",
          "G28 G53"}) {
        const std::string second = codes.substr(codes.find(' ') + 1);
        EXPECT_EQ(refusal(codes),
                  "E_GCODE f:1: " + second +
                      " together with another code of its modal group; expected one "
                      "code of each modal group");
    }
}

TEST(GcodeModes, SupportOneCoordinateSystem)
{
    EXPECT_EQ(refusal("G54\nG54\nG59.1"),
              "E_GCODE f:3: G59.1 after G54; expected one coordinate system");
}

TEST(GcodeModes, LetAMotionCodeWinOverG80)
{
    EXPECT_EQ(modes_after("G0 G17 G21 G40 G49 G80 G90").motion, GcodeMotion::Rapid);
    EXPECT_EQ(modes_after("G80 G3").motion, GcodeMotion::CounterclockwiseArc);
    EXPECT_EQ(modes_after("G81\nG80").motion, GcodeMotion::None);
    EXPECT_EQ(refusal("G80 G81"),
              "E_GCODE f:1: G80 beside a canned cycle; expected two separate blocks");
}

TEST(GcodeModes, KeepTheCycleAndItsRetractLevel)
{
    for (const int code : {73, 74, 81, 82, 83, 84, 85, 86, 88, 89}) {
        const GcodeModes modes = modes_after("G98 G" + std::to_string(code));
        EXPECT_EQ(modes.motion, GcodeMotion::Cycle);
        EXPECT_EQ(modes.cycle, code);
        EXPECT_EQ(modes.retract, RetractLevel::Initial);
    }
    EXPECT_EQ(modes_after("G98\nG99").retract, RetractLevel::R);
    EXPECT_EQ(modes_after("G21").retract, RetractLevel::Unstated);
}

TEST(GcodeModes, KnowTheMeaningOfS)
{
    EXPECT_TRUE(modes_after("G96").has_surface_speed);
    EXPECT_FALSE(modes_after("G96\nG97").has_surface_speed);
}

TEST(GcodeModes, AcceptCodesThatMoveNothing)
{
    for (const std::string code : {"G8", "G15", "G28.1", "G30.1", "G50", "G50.1", "G67",
                                   "G69", "G92.1", "G92.2", "G96", "G97", "G98", "G99"})
        EXPECT_EQ(refusal(code), "accepted") << code;
    EXPECT_TRUE(is_idle_g_code(690));
    EXPECT_FALSE(is_idle_g_code(170));
}

TEST(GcodeModes, KnowReferenceMoves)
{
    const auto of = [](const std::string& codes) {
        const TextLines lines{codes, {"f", "E_GCODE"}};
        return reference_move(parse_block(codes, lines));
    };
    EXPECT_EQ(of("G0 X1"), ReferenceMove::None);
    EXPECT_EQ(of("G91 G28 Z0"), ReferenceMove::ReferencePoint);
    EXPECT_EQ(of("G30"), ReferenceMove::ReferencePoint);
    EXPECT_EQ(of("G0 G53 Z0"), ReferenceMove::MachineCoordinates);
    EXPECT_EQ(refusal("G0 G28 Z0"), "accepted");
    for (const std::string codes : {"G2 G28", "G81 G53"})
        EXPECT_EQ(
            refusal(codes),
            "E_GCODE f:1: two codes that both use X, Y and Z; expected two separate "
            "blocks");
}

TEST(GcodeModes, RefuseUnsupportedCodes)
{
    const std::string frame =
        "; expected coordinates in one coordinate system of the part";
    const std::string offsets = frame + ": --interpreter linuxcnc applies offsets";
    const std::string expand =
        "; expected moves written out: --interpreter linuxcnc expands them";
    const std::string tip =
        "; expected a path of the cutter's tip (G40): only the control knows the radius";
    const std::string cycles = "; expected G73, G74, G81 to G86, G88 or G89";
    for (const std::string code : {"G76", "G84.2", "G88.1"})
        EXPECT_EQ(refusal(code), "E_GCODE f:1: canned cycle " + code + cycles);
    EXPECT_EQ(refusal("G87"),
              "E_GCODE f:1: back boring, which cuts from below G87" + cycles);
    for (const std::string code : {"G41", "G42", "G41.1", "G42.1"})
        EXPECT_EQ(refusal(code), "E_GCODE f:1: cutter compensation " + code + tip);
    for (const std::string code : {"G5", "G5.1", "G5.2", "G5.3"})
        EXPECT_EQ(refusal(code), "E_GCODE f:1: spline " + code + expand);
    EXPECT_EQ(refusal("G7"),
              "E_GCODE f:1: diameters of a lathe G7; expected coordinates "
              "of a milling machine (G8)");
    EXPECT_EQ(refusal("G10"), "E_GCODE f:1: setting of offsets G10" + offsets);
    for (const std::string code : {"G33", "G33.1"})
        EXPECT_EQ(refusal(code), "E_GCODE f:1: motion in step with the spindle " + code +
                                     "; expected G1 with a feed F");
    for (const std::string code : {"G38.2", "G38.3", "G38.4", "G38.5"})
        EXPECT_EQ(refusal(code),
                  "E_GCODE f:1: probing " + code + "; expected a program that cuts");
    for (const std::string code : {"G51", "G51.1"})
        EXPECT_EQ(refusal(code), "E_GCODE f:1: scaling or mirroring " + code + frame);
    for (const std::string code : {"G52", "G92", "G92.3"})
        EXPECT_EQ(refusal(code), "E_GCODE f:1: coordinate offset " + code + offsets);
    EXPECT_EQ(refusal("G68"), "E_GCODE f:1: rotation or tilted plane G68" + frame);
    EXPECT_EQ(refusal("G95"),
              "E_GCODE f:1: feed per revolution G95; expected G93 or G94");
    for (const std::string code : {"G43.4", "G43.5", "G234"})
        EXPECT_EQ(refusal(code), "E_GCODE f:1: tool-centre-point code " + code +
                                     "; expected positions of the axes, or tips with "
                                     "rotary words (--frame part)");
    EXPECT_EQ(refusal("G68.2"), "E_GCODE f:1: rotation or tilted plane G68.2" + frame);
    EXPECT_EQ(refusal("G53.1"), "E_GCODE f:1: turn into a tilted plane G53.1" + frame);
}

TEST(GcodeModes, RefuseUnknownCodes)
{
    for (const std::string code :
         {"G6", "G43.1", "G43.2", "G54.1", "G59.4", "G64.1", "G0.1", "G999"})
        EXPECT_EQ(refusal(code), "E_GCODE f:1: unknown code " + code + "; expected " +
                                     std::string{known_g_codes});
}

TEST(CheckMCodes, AcceptsCodesThatDoNotMove)
{
    for (const std::string codes :
         {"M0", "M1", "M3 M7 M8", "M6", "M19", "M48", "M62", "M100"})
        EXPECT_EQ(m_refusal(codes), "accepted");
}

TEST(CheckMCodes, RefusesSubprogramsAndCentrePointCodes)
{
    const std::string expand =
        "; expected moves written out: --interpreter linuxcnc expands them";
    for (const std::string code : {"M96", "M97", "M98", "M99"})
        EXPECT_EQ(m_refusal(code), "E_GCODE f:1: branch or subprogram " + code + expand);
    EXPECT_EQ(m_refusal("M198"), "E_GCODE f:1: subprogram M198" + expand);
    EXPECT_EQ(m_refusal("M47"), "E_GCODE f:1: repetition of the program M47" + expand);
    EXPECT_EQ(m_refusal("M200"), "E_GCODE f:1: unknown code M200; expected M0 to M199");
    EXPECT_EQ(m_refusal("M128"),
              "E_GCODE f:1: tool-centre-point code M128; expected positions of the "
              "axes, or tips with rotary words (--frame part)");
    for (const std::string code : {"M70", "M71", "M72", "M73"})
        EXPECT_EQ(m_refusal(code), "E_GCODE f:1: saved modal state " + code + expand);
}

TEST(CheckMCodes, RefusesTwoThatExcludeEachOther)
{
    EXPECT_EQ(m_refusal("M3 M5"),
              "E_GCODE f:1: M5 together with another code of its modal group; "
              "expected one code of each modal group");
    EXPECT_EQ(m_refusal("M0 M30"),
              "E_GCODE f:1: M30 together with another code of its modal group; "
              "expected one code of each modal group");
}

}  // namespace
}  // namespace endmill
