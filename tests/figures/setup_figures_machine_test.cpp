// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/setup_figures.h"

#include <map>

#include <gtest/gtest.h>

#include "small_xml.h"

namespace endmill {
namespace {

std::map<std::string, std::vector<double>> heights_of_texts(const std::string& svg)
{
    std::map<std::string, std::vector<double>> heights;
    for (const XmlElement& element : SmallXml::parse(svg))
        if (element.name == "text")
            heights[element.text].push_back(std::stod(element.attributes.at("y")));
    return heights;
}

class SketchOfAMachine : public testing::TestWithParam<const char*> {};

// Every axis of the word has its letter once. Axes that carry the part are below it, axes
// that carry the tool above it (y counts downwards).
TEST_P(SketchOfAMachine, StacksTheAxesOfItsWord)
{
    const std::string word = GetParam();
    const MachineConfiguration machine = configuration_from_word(word);
    const auto heights = heights_of_texts(machine_svg(machine, "t", {"caption"}));
    const double part = heights.at("part").front();
    const std::size_t bed = word.find('B');
    for (std::size_t k = 2; k + 2 < word.size(); ++k) {
        if (k == bed)
            continue;
        const auto& found = heights.at(std::string{word[k]});
        ASSERT_EQ(found.size(), 1U) << word[k];
        EXPECT_EQ(found.front() > part, k < bed) << word[k];
    }
    EXPECT_TRUE(heights.contains("caption"));
    EXPECT_EQ(heights.contains("R1 = C, turns the part"), word.starts_with("W/c"));
}

INSTANTIATE_TEST_SUITE_P(Words, SketchOfAMachine,
                         testing::Values("W/xyBz/T", "W/caxyBz/T", "W/cxyBza/T",
                                         "W/xyBzca/T", "W/Bxyzab/T", "W/axyzB/T"));

TEST(MachineAxes, HasThreeLinearAndThreeRotaryAxes)
{
    const auto heights = heights_of_texts(machine_axes_svg("Axes"));
    for (const char* name : {"A", "B", "C", "Axes"})
        EXPECT_TRUE(heights.contains(name)) << name;
    for (const char* name :
         {"X", "Y", "Z"})  // at the axis and at the figure's own arrows
        EXPECT_EQ(heights.at(name).size(), 2U) << name;
}

}  // namespace
}  // namespace endmill
