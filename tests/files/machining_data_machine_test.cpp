// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/machining_data.h"

#include <filesystem>
#include <numbers>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"

namespace endmill {
namespace {

using testing::HasSubstr;

const std::string whole = R"({"format": "endmill-machine/1", "name": "big",
 "configuration": "W/caxyBz/T", "limits": {"x_mm": [-300, 300], "c_deg": [-180, 90]},
 "pivot_mm": 150, "table_offset_mm": [1, 2, 3],
 "spindle": {"max_rpm": 3000, "max_power_w": 3700, "max_torque_n_m": 50},
 "max_feed_mm_per_min": 2000, "acceleration_m_per_s2": 1, "source": "a test"})";

TEST(MachineFile, HoldsAMachine)
{
    const MachineDescription machine = parse_machine(whole, "m.json");
    EXPECT_EQ(machine.name, "big");
    EXPECT_EQ(machine.source, "a test");
    EXPECT_EQ(machine.configuration, "W/caxyBz/T");
    EXPECT_EQ(machine.limits, (MachineLimits{.max_rpm = 3000,
                                             .max_power_w = 3700,
                                             .max_torque_n_m = 50,
                                             .max_feed_mm_per_min = 2000,
                                             .acceleration_m_per_s2 = 1}));
    ASSERT_EQ(machine.travels.size(), 2U);
    EXPECT_EQ(machine.travels[0], (AxisTravel{'x', -300, 300}));
    EXPECT_EQ(machine.travels[1].axis, 'c');
    EXPECT_DOUBLE_EQ(machine.travels[1].from, -std::numbers::pi);
    EXPECT_DOUBLE_EQ(machine.travels[1].to, std::numbers::pi / 2);
    EXPECT_EQ(machine.pivot_mm, 150);
    EXPECT_EQ(machine.table_offset_mm, Vec3(1, 2, 3));
}

TEST(MachineFile, NeedsItsFormatOnly)
{
    const MachineDescription machine =
        parse_machine(R"({"format": "endmill-machine/1"})", "folder/mill.json");
    EXPECT_EQ(machine.name, "mill");
    EXPECT_EQ(machine.configuration, "W/xyBz/T");
    EXPECT_EQ(machine.limits, MachineLimits{});
    EXPECT_TRUE(machine.travels.empty());
    EXPECT_FALSE(machine.pivot_mm || machine.table_offset_mm);
}

struct Fault {
    std::string from;
    std::string to;
    std::string complaint;
};

class MachineFileWith : public testing::TestWithParam<Fault> {};

TEST_P(MachineFileWith, IsRefusedWithThePlace)
{
    const Fault& fault = GetParam();
    const std::string text = replaced(whole, fault.from, fault.to);
    ASSERT_FALSE(text.empty());
    EXPECT_THAT(complaint_of([&] { parse_machine(text, "m.json"); }),
                HasSubstr(fault.complaint));
}

INSTANTIATE_TEST_SUITE_P(
    AFault, MachineFileWith,
    testing::Values(
        Fault{"machine/1", "machine/2", "made by a newer version"},
        Fault{"machine/1", "material/1", "E_FORMAT"},
        Fault{"W/caxyBz/T", "W/caxyz/T", "E_MACHINE m.json:/configuration"},
        Fault{"W/caxyBz/T", "W/T", "E_MACHINE"}, Fault{"W/caxyBz/T", "W/", "E_MACHINE"},
        Fault{"W/caxyBz/T", "W/caxyBqz/T", "E_MACHINE"},
        Fault{"W/caxyBz/T", "W/ccxyBz/T", "E_MACHINE"},
        Fault{"W/caxyBz/T", "W/xyBz/T", "E_MACHINE m.json:/limits/c_deg"},
        Fault{"W/caxyBz/T", "W/caxyBz", "/T is missing at its end"},
        Fault{"W/caxyBz/T", "W/cabxyBz/T", "three rotary axes"},
        Fault{"[-180, 90]", "[-180, -1]", "E_MACHINE m.json:/limits/c_deg: [-180, -1]"},
        Fault{"[-180, 90]", "[1, 90]", "expected limits that hold 0"},
        Fault{"[-180, 90]", "[-1000001, 0]", "E_MACHINE m.json:/limits/c_deg/0"},
        Fault{"[-180, 90]", "[90, -180]", "E_MACHINE m.json:/limits/c_deg/1"},
        Fault{"[1, 2, 3]", "[1, 2, 3], \"axis_offset_mm\": [1, 2]",
              "E_MACHINE m.json:/axis_offset_mm"},
        Fault{"[-300, 300]", "[300, -300]",
              "E_MACHINE m.json:/limits/x_mm/1: -300; expected at least the min, 300"},
        Fault{"[-300, 300]", "[300]", "E_MACHINE m.json:/limits/x_mm"},
        Fault{"[-300, 300]", "300", "E_JSON m.json:/limits/x_mm"},
        Fault{"[-300, 300]", "[-1e7, 300]", "E_MACHINE m.json:/limits/x_mm/0"},
        Fault{"\"x_mm\"", "\"x_m\"", "did you mean \"x_mm\"?"},
        Fault{"\"x_mm\"", "\"c_deg\"", "E_JSON"},
        Fault{"3000", "0", "E_MACHINE m.json:/spindle/max_rpm"},
        Fault{"3700", "-1", "E_MACHINE m.json:/spindle/max_power_w"},
        Fault{": 50", ": 0", "E_MACHINE m.json:/spindle/max_torque_n_m"},
        Fault{"2000", "0", "E_MACHINE m.json:/max_feed_mm_per_min"},
        Fault{"_s2\": 1", "_s2\": 0", "E_MACHINE m.json:/acceleration_m_per_s2"},
        Fault{"_s2\": 1", "_s2\": \"1\"", "E_JSON m.json:/acceleration_m_per_s2"},
        Fault{"max_rpm", "max_rpn", "did you mean \"max_rpm\"?"},
        Fault{"[1, 2, 3]", "[1, 2]", "E_MACHINE m.json:/table_offset_mm"},
        Fault{"\"pivot_mm\"", R"("word_sign": {"c": 2}, "pivot_mm")",
              "E_MACHINE m.json:/word_sign/c"},
        Fault{"\"pivot_mm\"", R"("word_sign": {"c": 0.5}, "pivot_mm")",
              "expected 1 or -1"},
        Fault{"\"pivot_mm\"", R"("word_sign": {"b": 1}, "pivot_mm")",
              "m.json:/word_sign/b: sign of an axis that the machine does not have; "
              "expected "
              "an axis of W/caxyBz/T"},
        Fault{"\"pivot_mm\"", R"("word_sign": {"x": 1}, "pivot_mm")",
              "m.json:/word_sign/x"},
        Fault{"\"pivot_mm\"", R"("max_rate": {"c_deg_per_min": 0}, "pivot_mm")",
              "E_MACHINE m.json:/max_rate/c_deg_per_min"},
        Fault{"\"pivot_mm\"", R"("max_rate": {"x_mm_per_min": -1}, "pivot_mm")",
              "E_MACHINE m.json:/max_rate/x_mm_per_min"},
        Fault{"\"pivot_mm\"", R"("max_rate": {"b_deg_per_min": 1}, "pivot_mm")",
              "rate of an axis that the machine does not have"},
        Fault{"\"pivot_mm\"", R"("max_rate": {"c_deg_per_mi": 1}, "pivot_mm")",
              "did you mean \"c_deg_per_min\"?"},
        Fault{"150", "1e7", "E_MACHINE m.json:/pivot_mm"},
        Fault{"\"source\"", "\"origin\"", "m.json:/origin: unknown key"},
        Fault{"{\"format\"", "solid {\"format\"", "E_FORMAT"}));

TEST(MachineFile, TheExamplesAreRead)
{
    const std::string folder = std::string{ENDMILL_SOURCE_DIR} + "/datasets/machines/";
    const MachineDescription steel = read_machine(folder + "milling-machine-steel.json");
    EXPECT_EQ(steel.limits.max_rpm, 3000);
    EXPECT_NO_THROW(require_sound(steel.limits));
    EXPECT_THAT(complaint_of([] { read_machine("no such machine.json"); }),
                HasSubstr("E_OPEN"));
}

// Positions of a table axis are turns with the opposite sign. Missing values become 0 or
// no limit.
TEST(MovingMachine, HasTheLimitsOfTheFile)
{
    const Machine machine = moving_machine(parse_machine(whole, "m.json"));
    EXPECT_EQ(machine.configuration.family, RotaryFamily::CA);
    EXPECT_DOUBLE_EQ(machine.rotary.theta.from, -std::numbers::pi / 2);
    EXPECT_DOUBLE_EQ(machine.rotary.theta.to, std::numbers::pi);
    EXPECT_EQ(machine.rotary.phi, RotaryRange{});
    EXPECT_EQ(machine.linear[0], (LinearRange{-300, 300}));
    EXPECT_EQ(machine.linear[1], LinearRange{});
    EXPECT_EQ(machine.pivot, 150);
    EXPECT_EQ(machine.table_offset, Vec3(1, 2, 3));

    const Machine plain =
        moving_machine(parse_machine(R"({"format": "endmill-machine/1"})", "m.json"));
    EXPECT_EQ(plain.rotary.phi, (RotaryRange{0, 0}));
    EXPECT_EQ(plain.pivot, 0);
    EXPECT_EQ(plain.table_offset, Vec3(0, 0, 0));
}

TEST(MovingMachine, HasTheSignsAndRatesOfTheFile)
{
    const Machine machine = moving_machine(parse_machine(
        replaced(whole, "\"pivot_mm\"",
                 R"("word_sign": {"c": -1}, "max_rate": {"y_mm_per_min": 5000,
                 "a_deg_per_min": 1800}, "pivot_mm")"),
        "m.json"));
    EXPECT_EQ(machine.word_signs, (RotaryPositions{-1, 1}));
    EXPECT_FALSE(machine.rates.linear_mm_per_min[0]);
    EXPECT_EQ(machine.rates.linear_mm_per_min[1], 5000);
    EXPECT_FALSE(machine.rates.rotary_rad_per_min[0]);
    EXPECT_DOUBLE_EQ(machine.rates.rotary_rad_per_min[1].value_or(0),
                     10 * std::numbers::pi);
    EXPECT_EQ(machine.rates.feed_mm_per_min, 2000);
}

// Limits of a full rotation are limits, although every direction is within them.
TEST(MovingMachine, KeepsLimitsOfAFullRotation)
{
    const Machine machine = moving_machine(
        parse_machine(replaced(whole, "[-180, 90]", "[-180, 180]"), "m.json"));
    EXPECT_FALSE(is_within_travel(machine, {{3.2, 0}, {0, 0, 0}}));
    EXPECT_TRUE(is_within_travel(machine, {{3.1, 0}, {0, 0, 0}}));
    EXPECT_TRUE(is_within_travel(machine, {{0, 7}, {0, 0, 0}}));
}

// Directions repeat after a rotation; positions do not.
TEST(MovingMachine, ReducesWideLimitsToOneRotationOfDirections)
{
    const Machine machine = moving_machine(
        parse_machine(replaced(whole, "[-180, 90]", "[-720, 400]"), "m.json"));
    EXPECT_EQ(machine.rotary.theta, RotaryRange{});
    ASSERT_TRUE(machine.wide_positions[0].has_value());
    EXPECT_DOUBLE_EQ(machine.wide_positions[0]->from, -4 * std::numbers::pi);
    EXPECT_FALSE(machine.wide_positions[1].has_value());
    EXPECT_FALSE(moving_machine(parse_machine(whole, "m.json")).wide_positions[0]);
}

// One file for each of the twelve configurations whose tool axis has two rotary degrees
// of freedom.
TEST(MovingMachine, OfEveryValidWordIsAmongTheExamples)
{
    const std::filesystem::path folder =
        std::filesystem::path{ENDMILL_SOURCE_DIR} / "datasets/machines";
    std::set<std::string> words;
    for (const auto& entry : std::filesystem::directory_iterator{folder}) {
        if (entry.path().extension() != ".json")
            continue;
        const Machine machine = moving_machine(read_machine(entry.path()));
        EXPECT_TRUE(machine.configuration.is_valid()) << entry.path();
        std::string word = machine.configuration.word;
        std::erase_if(word, [](char c) {
            return std::string{"xyz/WT"}.find(c) != std::string::npos;
        });
        if (machine.configuration.axes() == 5) {
            EXPECT_TRUE(words.insert(word).second) << word;
        }
    }
    EXPECT_EQ(words.size(), 12U);
    for (const char* word : {"Bca", "cBa", "caB", "baB"})
        EXPECT_TRUE(words.contains(word));  // figure 4 of the paper
}

}  // namespace
}  // namespace endmill
