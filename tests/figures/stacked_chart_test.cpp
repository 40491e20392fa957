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

TEST(RoundTicks, CoverTheRangeByRoundSteps)
{
    EXPECT_EQ(round_ticks(0, 10, 5), (std::vector<double>{0, 2, 4, 6, 8, 10}));
    EXPECT_EQ(round_ticks(-3, 7, 4), (std::vector<double>{-5, 0, 5, 10}));
    for (const auto& [low, high] :
         {std::pair{3.3, 3.3}, std::pair{-1e6, 1e6}, std::pair{1e-7, 3e-7},
          std::pair{0.0, 0.0}, std::pair{1e9, 1e9 + 1}}) {
        const std::vector<double> ticks = round_ticks(low, high, 4);
        ASSERT_GE(ticks.size(), 2u);
        EXPECT_LE(ticks.front(), low);
        EXPECT_GE(ticks.back(), high);
        EXPECT_LE(ticks.size(), 8u);
    }
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
    ChartLine line{"wave", red, {}};
    for (int i = 0; i < 200'000; ++i) {
        places.push_back(i);
        line.values.emplace_back(i == 77'777 ? 50.0 : i % 2);
    }
    const std::vector<ChartPanel> panels{{"y", {line}}};
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

}  // namespace
}  // namespace endmill
