// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/machine/configuration.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

using testing::HasSubstr;

// The machines of figure 4 of the paper. The place of the bed corrects the captions of
// (b) and (c).
TEST(Configuration, OfThePapersFourMachines)
{
    struct Row {
        const char* word;
        RotaryFamily family;
        RotaryAxis r1;
        RotaryAxis r2;
    };
    constexpr MachineSide table = MachineSide::Table;
    constexpr MachineSide head = MachineSide::Head;
    for (const Row& row :
         {Row{"W/xyBzca/T", RotaryFamily::CA, {'c', head}, {'a', head}},
          Row{"W/cxyBza/T", RotaryFamily::CA, {'c', table}, {'a', head}},
          Row{"W/caxyBz/T", RotaryFamily::CA, {'c', table}, {'a', table}},
          Row{"W/baxzBy/T", RotaryFamily::AB, {'b', table}, {'a', table}}}) {
        const MachineConfiguration machine = configuration_from_word(row.word);
        EXPECT_EQ(machine.word, row.word);
        EXPECT_EQ(machine.axes(), 5);
        EXPECT_TRUE(machine.is_valid()) << row.word;
        EXPECT_EQ(machine.family, row.family) << row.word;
        ASSERT_EQ(machine.rotary.size(), 2U);
        EXPECT_EQ(machine.rotary[0], row.r1) << row.word;
        EXPECT_EQ(machine.rotary[1], row.r2) << row.word;
        EXPECT_EQ(why_not_valid(machine), "");
    }
}

TEST(Configuration, WhoseCTurnsTheToolAboutItselfIsNotValid)
{
    for (const char* word : {"W/acxyBz/T", "W/xyzBbc/T", "W/axyBzc/T"}) {
        const MachineConfiguration machine = configuration_from_word(word);
        EXPECT_FALSE(machine.is_valid());
        EXPECT_EQ(machine.rank, 1);
        EXPECT_EQ(machine.family, std::nullopt);
        EXPECT_THAT(why_not_valid(machine), HasSubstr("turns it about itself"));
    }
    const MachineConfiguration alone = configuration_from_word("W/cxyBz/T");
    EXPECT_EQ(alone.rank, 0);
    EXPECT_EQ(alone.axes(), 4);
    EXPECT_THAT(why_not_valid(alone), HasSubstr("3-axis"));
}

TEST(Configuration, OfFewerAxes)
{
    const MachineConfiguration three = configuration_from_word("W/xyBz/T");
    EXPECT_TRUE(three.is_valid());
    EXPECT_EQ(three.axes(), 3);
    EXPECT_EQ(three.rank, 0);
    for (const char* word : {"W/axyBz/T", "W/xyBzb/T"}) {
        const MachineConfiguration four = configuration_from_word(word);
        EXPECT_TRUE(four.is_valid());
        EXPECT_EQ(four.axes(), 4);
        EXPECT_EQ(four.rank, 1);
        EXPECT_EQ(four.family, std::nullopt);
    }
    EXPECT_EQ(configuration_from_word(MachineConfiguration{}.word).rank,
              MachineConfiguration{}.rank);
}

TEST(Configuration, ReportsTheFirstErrorOfAWord)
{
    struct Row {
        const char* word;
        const char* fault;
    };
    for (const Row& row :
         {Row{"W/caxyz/T", "B, the bed, is missing"},
          Row{"W/caxbyz/T", "B, the bed, is missing"}, Row{"caxyBz/T", "W/ is missing"},
          Row{"w/caxyBz/T", "W/ is missing"}, Row{"W/caxyBz", "/T is missing"},
          Row{"W/caxyBz/t", "/T is missing"}, Row{"W/T", "/T is missing"},
          Row{"", "W/ is missing"}, Row{"W/", "/T is missing"},
          Row{"W//T", "B, the bed, is missing"},
          Row{"W/ccxyBz/T", "two equal rotary axes c"},
          Row{"W/cxxyBz/T", "two letters x"}, Row{"W/cxyBzB/T", "two letters B"},
          Row{"W/cqxyBz/T", "\"q\" is no axis"}, Row{"W/AxyBz/T", "lower case"},
          Row{"W/c axyBz/T", "\" \" is no axis"}, Row{"W/c\naxyBz/T", "unprintable"},
          Row{"W/caxBz/T", "y is missing"}, Row{"W/cabxyBz/T", "three rotary axes"}}) {
        EXPECT_THAT(configuration_fault(row.word).value_or("none"), HasSubstr(row.fault))
            << row.word;
        EXPECT_THROW(configuration_from_word(row.word), DomainError) << row.word;
    }
    EXPECT_EQ(configuration_fault("W/zBbayx/T"), std::nullopt);
}

}  // namespace
}  // namespace endmill
