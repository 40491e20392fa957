// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/detail/setup_styles.h"

#include <array>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "posed_setups.h"
#include "small_xml.h"

namespace endmill {
namespace {

TEST(SetupStyles, ShowEachLineOnce)
{
    const auto ca = setup_axes(test::axes_of_machine(RotaryFamily::CA));
    ASSERT_EQ(ca.size(), 2U);
    EXPECT_TRUE(ca[0].is_half_line);
    EXPECT_EQ(ca[1].object, SetupObject::SecondAxis);
    const auto ab = setup_axes(test::axes_of_machine(RotaryFamily::AB));
    ASSERT_EQ(ab.size(), 3U);
    EXPECT_EQ(ab[1].axis, Vec3(1, 0, 0));
    EXPECT_EQ(ab[2].axis, Vec3(0, 1, 0));
}

TEST(SetupStyles, DistinguishObjects)
{
    std::set<std::string_view> colours;
    for (const SetupObject object :
         {SetupObject::ToolAxis, SetupObject::FirstAxis, SetupObject::SecondAxis,
          SetupObject::NeededMotion, SetupObject::MachineMotion}) {
        EXPECT_TRUE(colours.insert(setup_style(object).colour).second);
        EXPECT_EQ(hidden_style(object).colour, setup_style(object).colour);
        EXPECT_FALSE(hidden_style(object).dashes.empty());
    }
}

TEST(SetupStyles, LegendNamesTheToolAxisAndCTogether)
{
    AxonometricFigure figure{{}, std::array<Vec3, 2>{Vec3{0, 0, 0}, {1, 1, 1}}};
    add_setup_legend(figure, test::axes_of_machine(RotaryFamily::CA));
    ShownSetup setup;
    setup.limits = RotaryLimits{};
    add_border_legend(figure, setup);
    std::set<std::string> texts;
    for (const XmlElement& element : SmallXml::parse(figure.text()))
        texts.insert(element.text);
    for (const char* text :
         {"tool axis, R1 = C", "R2 = A", "motion needed", "machine's limits"})
        EXPECT_TRUE(texts.contains(text)) << text;
}

}  // namespace
}  // namespace endmill
