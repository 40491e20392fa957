// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/detail/stacked_chart.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

std::size_t count_of(const std::string& text, const std::string& part)
{
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos;
         at = text.find(part, at + 1))
        ++count;
    return count;
}

const LineStyle red{"#ff0000", 1, ""};

TEST(StackedChart, HasGapsWhereThereIsNoValue)
{
    const std::vector<double> places{0, 1, 2, 3, 4};
    const std::vector<ChartPanel> panels{
        {"y", {{"line", red, {1.0, 2.0, std::nullopt, 1.0, 3.0}}}}};
    const std::string text =
        stacked_chart({"title <&>", {"caption"}, "x"}, places, panels);
    EXPECT_EQ(count_of(text, "#ff0000"), 3u);  // two pieces and the legend
    EXPECT_THAT(text, testing::HasSubstr("title &lt;&amp;&gt;"));
    EXPECT_THAT(text, testing::HasSubstr("caption"));
    EXPECT_THAT(text, testing::Not(testing::HasSubstr("nan")));
}

// The size of the file is bounded by the columns of pixels; a wave of many points keeps
// its height.
TEST(StackedChart, OfVeryManyPointsStaysSmallAndKeepsExtremes)
{
    std::vector<double> places;
    std::vector<std::optional<double>> values;
    for (int i = 0; i < 200'000; ++i) {
        places.push_back(i);
        values.emplace_back(i == 77'777 ? 50.0 : i % 2);
    }
    const std::vector<ChartPanel> panels{{"y", {{"wave", red, values}}}};
    const std::string text = stacked_chart({"many", {}, "x"}, places, panels);
    EXPECT_LT(text.size(), 100'000u);
    // The value 50 on a scale from 0 to 60 over 150 px.
    EXPECT_NE(text.find("-125 "), std::string::npos);
}

TEST(StackedChart, OfAConstantDoesNotShowItsRounding)
{
    const auto text_of = [](double value) {
        const std::vector<ChartPanel> panels{
            {"y", {{"line", red, {value, value * (1 + 1e-15), value}}}}};
        return stacked_chart({"constant", {}, "x"}, std::vector<double>{0, 1, 2}, panels);
    };
    for (const char* tick : {">1800<", ">2000<", ">2200<"})
        EXPECT_THAT(text_of(2000), testing::HasSubstr(tick));
    EXPECT_THAT(text_of(2000), testing::Not(testing::HasSubstr("2000.0")));
    EXPECT_THAT(text_of(0), testing::HasSubstr(">-1<"));
    EXPECT_THAT(text_of(-4), testing::HasSubstr(">-4.5<"));
}

// A feed at its cap of 1500 must not lie on the frame.
TEST(StackedChart, HasRoomBeyondAValueOnATick)
{
    const auto text_of = [](double low, double high) {
        const std::vector<ChartPanel> panels{{"y", {{"line", red, {low, high, high}}}}};
        return stacked_chart({"capped", {}, "x"}, std::vector<double>{0, 1, 2}, panels);
    };
    EXPECT_THAT(text_of(10, 1500), testing::HasSubstr(">2000<"));
    EXPECT_THAT(text_of(1, 1500), testing::Not(testing::HasSubstr(">-500<")));
    EXPECT_THAT(text_of(10, 1400), testing::Not(testing::HasSubstr(">2000<")));
    EXPECT_THAT(text_of(-1000, 400), testing::HasSubstr(">-1500<"));
    EXPECT_THAT(text_of(0, 1400), testing::Not(testing::HasSubstr(">-500<")))
        << "0 is the natural end of a scale";
}

TEST(StackedChart, WithoutValuesIsAFrame)
{
    const std::vector<ChartPanel> panels{{"y", {{"line", red, {}}}}};
    EXPECT_THAT(stacked_chart({"empty", {}, "x"}, {}, panels),
                testing::HasSubstr("</svg>"));
}

TEST(StackedChart, RefusesInvalidCurves)
{
    const std::vector<double> places{0, 1};
    const auto chart = [&](std::vector<std::optional<double>> values,
                           std::vector<double> x) {
        const std::vector<ChartPanel> panels{{"y", {{"line", red, std::move(values)}}}};
        return stacked_chart({"t", {}, "x"}, x, panels);
    };
    EXPECT_NO_THROW(chart({1.0, 2.0}, places));
    EXPECT_THROW(chart({1.0}, places), DomainError);
    EXPECT_THROW(chart({1.0, std::nan("")}, places), DomainError);
    EXPECT_THROW(chart({1.0, 2.0}, {1, 0}), DomainError);
    EXPECT_THROW(chart({1.0, 2.0}, {0, std::numeric_limits<double>::infinity()}),
                 DomainError);
    EXPECT_THROW(stacked_chart({"t", {}, "x"}, places, {}), DomainError);
}

// Two causes over 0 to 4 and 4 to 16: the boundary is at a quarter of the abscissa, which
// goes from 80 to 880 px.
TEST(StackedChart, HasAStripWhoseColoursChangeWithTheCause)
{
    const std::vector<double> places{2, 4, 16};
    const std::vector<ChartPanel> panels{{"y", {{"line", red, {1.0, 2.0, 3.0}}}}};
    const std::vector<ChartStrip> strips{
        {"limited by",
         {{"one", "#00ff00"}, {"two", "#0000ff"}, {"none", "#ff00ff"}},
         {0, 0, 1}}};
    const std::string text = stacked_chart({"t", {}, "x"}, places, panels, strips);
    EXPECT_EQ(count_of(text, "#00ff00"), 2u);  // the strip and its legend
    EXPECT_EQ(count_of(text, "#0000ff"), 2u);
    EXPECT_EQ(count_of(text, "#ff00ff"), 0u);  // a cause that does not occur
    EXPECT_EQ(count_of(text, "h200v14"), 1u);
    EXPECT_EQ(count_of(text, "h600v14"), 1u);
    const std::vector<ChartStrip> wrong{{"limited by", {{"one", "#00ff00"}}, {0, 1, 0}}};
    EXPECT_THROW(stacked_chart({"t", {}, "x"}, places, panels, wrong), DomainError);
}

}  // namespace
}  // namespace endmill
