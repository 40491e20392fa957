// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/deviation_svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/core/tolerance.h"
#include "made_deviation.h"
#include "small_xml.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr DeviationLimits limits{0.01, 0.1};

struct Box {
    int x;
    int y;
    int width;
    int height;
};

// The boxes of each colour, swatches of the scale last.
std::map<std::string, std::vector<Box>> boxes_of(const std::string& svg)
{
    std::map<std::string, std::vector<Box>> boxes;
    for (const XmlElement& element : SmallXml::parse(svg)) {
        if (element.name != "path" || !element.attributes.contains("shape-rendering"))
            continue;
        const std::string& data = element.attributes.at("d");
        int back = 0;
        Box box{};
        for (std::size_t at = 0; at != std::string::npos && at < data.size();
             at = data.find('M', at + 1)) {
            EXPECT_EQ(std::sscanf(data.c_str() + at, "M%d %dh%dv%dh%dz", &box.x, &box.y,
                                  &box.width, &box.height, &back),
                      5);
            EXPECT_EQ(back, -box.width);
            boxes[element.attributes.at("fill")].push_back(box);
        }
    }
    return boxes;
}

std::vector<std::string> texts_of(const std::string& svg)
{
    std::vector<std::string> texts;
    for (const XmlElement& element : SmallXml::parse(svg))
        if (element.name == "text")
            texts.push_back(element.text);
    return texts;
}

bool holds(const std::vector<std::string>& texts, const std::string& what)
{
    return std::ranges::any_of(texts, [&](const std::string& text) {
        return text.find(what) != std::string::npos;
    });
}

// Red, green and blue of "#rrggbb".
std::array<int, 3> channels(std::string_view colour)
{
    std::array<int, 3> values{};
    std::sscanf(std::string{colour}.c_str(), "#%2x%2x%2x",
                reinterpret_cast<unsigned*>(&values[0]),
                reinterpret_cast<unsigned*>(&values[1]),
                reinterpret_cast<unsigned*>(&values[2]));
    return values;
}

TEST(DeviationColour, AgreesWithTheVerdict)
{
    const std::string_view within = deviation_colour(0.1, limits);
    EXPECT_EQ(deviation_colour(0.1 + verdict_slack, limits), within);
    EXPECT_NE(deviation_colour(0.1 + verdict_slack + 1e-9, limits), within);
    const std::string_view gouge = deviation_colour(-0.01, limits);
    EXPECT_EQ(deviation_colour(-0.01 - verdict_slack, limits), gouge);
    EXPECT_NE(deviation_colour(-0.01 - verdict_slack - 1e-9, limits), gouge);
}

TEST(DeviationColour, DivergesFromGreyOverTheColoursOfItsName)
{
    const auto [grey_r, grey_g, grey_b] = channels(deviation_colour(0, limits));
    EXPECT_EQ(grey_r, grey_g);
    EXPECT_EQ(grey_g, grey_b);
    for (const double gouge : {-0.002, -0.005, -0.009}) {
        const auto [r, g, b] = channels(deviation_colour(gouge, limits));
        EXPECT_GT(b, g);
        EXPECT_GT(g, r);
    }
    const auto [mild_r, mild_g, mild_b] = channels(deviation_colour(0.05, limits));
    EXPECT_GT(mild_g, std::max(mild_r, mild_b));
    const auto [much_r, much_g, much_b] = channels(deviation_colour(0.095, limits));
    EXPECT_GT(much_r, much_g);
    EXPECT_GT(much_g, much_b);
    const auto [over_r, over_g, over_b] = channels(deviation_colour(0.2, limits));
    EXPECT_GT(over_r, 4 * std::max(over_g, over_b));
}

// A quarter of the part each: a gouge, nothing, a rest and too much.
TEST(DeviationMap, PaintsTheSquaresOfThePart)
{
    const Part part = std::vector<Surface>{test::plane(40, 20)};
    const PartCharts charts = part_charts(part);
    const std::array<double, 4> quarters{-0.015, 0, 0.05, 0.15};
    const Deviation deviation = made_deviation(charts, 0.25, [&](const Vec3& p) {
        return quarters[static_cast<std::size_t>(p.x() / 10)];
    });
    DeviationFigure figure;
    figure.limits = limits;
    figure.squares = 80;
    const auto boxes = boxes_of(deviation_svg(charts, deviation, figure));
    std::set<std::pair<int, int>> corners;
    for (std::size_t k = 0; k < 4; ++k) {
        auto painted = boxes.at(std::string{deviation_colour(quarters[k], limits)});
        ASSERT_EQ(painted.size(), 41U);  // a box a row, and the scale's
        painted.pop_back();
        const int square = painted[0].height;
        for (const Box& box : painted) {
            EXPECT_EQ(box.width, 20 * square);
            EXPECT_EQ(box.height, square);
            EXPECT_EQ(box.x, painted[0].x);
            corners.emplace(box.x, box.y);
        }
        EXPECT_EQ(painted[0].x, 68 + static_cast<int>(k) * 20 * square);
    }
    EXPECT_EQ(corners.size(), 160U);  // no two in one place
}

// A part of 40 x 20.3 mm in squares of 0.5 mm has 41 rows; the last one is cut, so that
// the frame and the squares end where the part ends.
TEST(DeviationMap, IsNoWiderThanThePart)
{
    const Part part = std::vector<Surface>{test::plane(40, 20.3)};
    const PartCharts charts = part_charts(part);
    const Deviation deviation =
        made_deviation(charts, 0.1, [](const Vec3&) { return 0.05; });
    DeviationFigure figure;
    figure.limits = limits;
    figure.squares = 80;
    const std::string svg = deviation_svg(charts, deviation, figure);
    auto painted = boxes_of(svg).at(std::string{deviation_colour(0.05, limits)});
    painted.pop_back();  // of the scale
    int top = painted[0].y;
    int bottom = 0;
    for (const Box& box : painted) {
        top = std::min(top, box.y);
        bottom = std::max(bottom, box.y + box.height);
    }
    EXPECT_EQ(painted.size(), 41U);
    EXPECT_NEAR(static_cast<double>(bottom - top) / painted[0].width, 20.3 / 40, 0.002);
    for (const char* label : {"x, mm", "y, mm", "remaining stock", "excessive gouge"})
        EXPECT_TRUE(holds(texts_of(svg), label)) << label;
}

TEST(DeviationMap, ExplainsTheAreaThatIsNotJudged)
{
    const Part part = std::vector<Surface>{test::plane(4, 2)};
    const PartCharts charts = part_charts(part);
    Deviation deviation = made_deviation(charts, 1, [](const Vec3&) { return 0.0; });
    for (const double area : {0.0, 3.5}) {
        deviation.inaccessible_area_mm2 = area;
        EXPECT_EQ(holds(texts_of(deviation_svg(charts, deviation, {.limits = limits})),
                        "not judged: the cutter"),
                  area > 0);
    }
}

TEST(DeviationMap, HasEveryColourOnItsScaleInOrder)
{
    const Part part = std::vector<Surface>{test::plane(4, 2)};
    const PartCharts charts = part_charts(part);
    const Deviation deviation =
        made_deviation(charts, 1, [](const Vec3&) { return 0.0; });
    const auto boxes = boxes_of(deviation_svg(charts, deviation, {.limits = limits}));
    int before = 0;
    std::set<std::string> seen;
    for (double left = 0.3; left > -0.03; left -= 0.0005) {
        const std::string colour{deviation_colour(left, limits)};
        const int y = boxes.at(colour).back().y;
        EXPECT_GE(y, before);
        before = y;
        seen.insert(colour);
    }
    EXPECT_EQ(seen.size(), boxes.size());
}

DeviationPlace place_of(double left, const Vec3& point)
{
    DeviationPlace place;
    place.left = left;
    place.ray.point = point;
    return place;
}

TEST(DeviationMap, NamesVerdictAndExtremesWhereTheyAre)
{
    const Part part = std::vector<Surface>{test::plane(40, 20)};
    const PartCharts charts = part_charts(part);
    Deviation deviation = made_deviation(charts, 1, [](const Vec3&) { return 0.0; });
    deviation.max_gouge_mm = 0.02;
    deviation.max_scallop_mm = 0.08;
    deviation.deepest = place_of(-0.02, {10, 5, 0});
    deviation.highest = place_of(0.08, {30, 15, 0});
    DeviationFigure figure;
    figure.limits = limits;
    figure.title = "A <part>";
    figure.captions = {"ball:10 & more"};
    const std::string svg = deviation_svg(charts, deviation, figure);
    const auto texts = texts_of(svg);
    EXPECT_TRUE(holds(texts, "gouged: gouge 0.02 mm"));
    EXPECT_TRUE(holds(texts, "gouge 0.02 mm"));
    EXPECT_TRUE(holds(texts, "remaining 0.08 mm"));
    EXPECT_TRUE(holds(texts, "A <part>"));
    EXPECT_TRUE(holds(texts, "ball:10 & more"));

    deviation.max_gouge_mm = 1e-9;  // rounding is not named
    deviation.deepest->left = -1e-9;
    const auto clean = texts_of(deviation_svg(charts, deviation, figure));
    EXPECT_TRUE(holds(clean, "clean: gouge 0 mm"));
    EXPECT_TRUE(std::ranges::none_of(
        clean, [](const std::string& text) { return text.starts_with("gouge "); }));
}

// A letter is about 8 px wide, and the picture 900 px.
TEST(DeviationMap, BreaksLongCaptionsAtBlanksAndCutsALongTitle)
{
    const Part part = std::vector<Surface>{test::plane(40, 20)};
    const PartCharts charts = part_charts(part);
    const Deviation deviation =
        made_deviation(charts, 1, [](const Vec3&) { return 0.0; });
    DeviationFigure figure;
    figure.width_px = 900;
    figure.title = std::string(300, 'T');
    std::string whole;
    for (int number = 100; number < 135; ++number)
        whole += (whole.empty() ? "" : " ") + std::to_string(number);
    figure.captions = {whole};
    std::string joined;
    for (const std::string& text : texts_of(deviation_svg(charts, deviation, figure))) {
        EXPECT_LE(text.size(), 110U);
        if (text.starts_with("1"))
            joined += (joined.empty() ? "" : " ") + text;
    }
    EXPECT_EQ(joined.substr(0, whole.size()), whole);
}

TEST(DeviationMap, StaysSmallForEveryPart)
{
    const Part part = std::vector<Surface>{test::plane(40, 40)};
    const PartCharts charts = part_charts(part);
    const Deviation rough = made_deviation(charts, 0.1, [](const Vec3& p) {
        return std::sin(911 * p.x()) * std::cos(733 * p.y()) * 0.1;
    });
    EXPECT_LT(deviation_svg(charts, rough, {.limits = limits}).size(), 1'500'000U);
}

TEST(DeviationMap, IsDrawnForAnEmptyPartAndAWall)
{
    const Part none = std::vector<Surface>{};
    EXPECT_NO_THROW(SmallXml::parse(deviation_svg(part_charts(none), {}, {})));
    const Part wall = std::vector<Surface>{test::parallelogram({0, 9, 0}, {0, 0, 5})};
    const PartCharts charts = part_charts(wall);
    const Deviation deviation =
        made_deviation(charts, 0.5, [](const Vec3&) { return 0.2; });
    const auto boxes = boxes_of(deviation_svg(charts, deviation, {.limits = limits}));
    EXPECT_GT(boxes.at(std::string{deviation_colour(0.2, limits)}).size(), 100U);
}

TEST(DeviationMap, RefusesSizesOutOfRange)
{
    const Part part = std::vector<Surface>{test::plane(1, 1)};
    const PartCharts charts = part_charts(part);
    EXPECT_THROW(deviation_svg(charts, {}, {.width_px = 399}), DomainError);
    EXPECT_THROW(deviation_svg(charts, {}, {.width_px = std::nan("")}), DomainError);
    EXPECT_THROW(deviation_svg(charts, {}, {.squares = 0}), DomainError);
    EXPECT_THROW(deviation_svg(charts, {}, {.squares = 1001}), DomainError);
}

}  // namespace
}  // namespace endmill
