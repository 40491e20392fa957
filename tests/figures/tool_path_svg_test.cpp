// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/tool_path_svg.h"

#include <limits>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drawn_svg.h"
#include "endmill/core/error.h"
#include "test_meshes.h"
#include "wavy_path.h"

namespace endmill {
namespace {

std::set<std::string> texts_of(const std::string& svg)
{
    std::set<std::string> texts;
    for (const XmlElement& element : SmallXml::parse(svg))
        if (element.name == "text")
            texts.insert(element.text);
    return texts;
}

// The drawing is seen from above, where a px is as long in x as in y.
TEST(ToolPathSvg, JoinsTheContactsInTheOrderTheCutterPasses)
{
    const ToolPath path = wavy_path(3, 40);
    FigureOptions from_above;
    from_above.azimuth = Angle::degrees(-90);
    from_above.elevation = Angle::degrees(90);
    const std::string svg = tool_path_svg(path, from_above);
    const auto cuts = lines_of(svg, "#1d4f91");
    ASSERT_EQ(cuts.size(), 3U + 1);  // and the legend's sample
    const double scale = (cuts[0].back() - cuts[0].front()).norm() / 200;
    const PixelPoint origin = cuts[0].front();
    for (int pass = 0; pass < 3; ++pass)
        for (int i = 0; i < 40; ++i) {
            const Vec3 contact = path.points[40 * pass + i].contact()->contact.point;
            const PixelPoint place =
                origin + scale * PixelPoint{contact.x(), -contact.y()};
            EXPECT_LT(distance(place, cuts[pass]), 0.15);
        }
    EXPECT_GT(cuts[0].back().x(), cuts[0].front().x());
    EXPECT_LT(cuts[1].back().x(), cuts[1].front().x());  // zig-zag
}

TEST(ToolPathSvg, ShowsLinksApartAndMovesClearOfThePartDashed)
{
    const std::string svg = tool_path_svg(wavy_path(3, 40));
    EXPECT_EQ(lines_of(svg, "#d1402f").size(), 2U + 1);
    int dashed = 0;
    for (const XmlElement& element : SmallXml::parse(svg))
        dashed += element.attributes.contains("stroke-dasharray") ? 1 : 0;
    EXPECT_EQ(dashed, 1 + 1);  // retract and rapid in one line, and the legend's sample
}

TEST(ToolPathSvg, LegendNamesTheDrawnMoves)
{
    const std::set<std::string> whole = texts_of(tool_path_svg(wavy_path(2, 5)));
    for (const char* label : {"cut", "link", "rapid, plunge, retract", "x, mm", "y, mm",
                              "z, mm", "start", "direction"})
        EXPECT_TRUE(whole.contains(label)) << label;
    ToolPath only_cuts = wavy_path(2, 5);
    only_cuts.points.resize(5);
    const std::set<std::string> part = texts_of(tool_path_svg(only_cuts));
    EXPECT_TRUE(part.contains("cut"));
    EXPECT_FALSE(part.contains("link"));
    EXPECT_FALSE(part.contains("rapid, plunge, retract"));
}

TEST(ToolPathSvg, ShowsTheToolAxisWhereItTurns)
{
    ToolPath path = wavy_path(2, 20);
    EXPECT_FALSE(texts_of(tool_path_svg(path)).contains("tool axis"));
    for (PathPoint& point : path.points)
        if (point.pass == 1)
            point.location.axis = Vec3{0.6, 0, 0.8};
    const std::string svg = tool_path_svg(path);
    EXPECT_TRUE(texts_of(svg).contains("tool axis"));
    // one line for each cut, and the legend's sample
    std::size_t cuts = 0;
    for (const PathPoint& point : path.points)
        cuts += point.move == Move::Cut ? 1 : 0;
    const auto lines = lines_of(svg, "#b8860b");
    ASSERT_EQ(lines.size(), cuts + 1);
    // upright ones and leaning ones have two directions in the drawing
    const PixelPoint first = lines.front().back() - lines.front().front();
    const PixelPoint last = lines[cuts - 1].back() - lines[cuts - 1].front();
    EXPECT_NEAR(first.x(), 0, 0.2);
    EXPECT_GT(std::abs(last.x()), 1);
}

TEST(ToolPathSvg, ShowsTitleAndCaptions)
{
    const std::string caption =
        "tolerance 0.5 mm, ball diameter 15 mm, 1061 points, travel 20809 mm";
    const auto texts = texts_of(
        tool_path_svg(wavy_path(2, 5), {.title = "u & v", .captions = {caption}}));
    EXPECT_TRUE(texts.contains("u & v"));
    EXPECT_TRUE(texts.contains(caption));
}

TEST(ToolPathSvg, StaysSmallWithAMillionPoints)
{
    EXPECT_LT(tool_path_svg(wavy_path(1000, 1000)).size(), 4000000U);
}

TEST(ToolPathSvg, DrawsAPathOfOnePointAndRefusesNone)
{
    ToolPath path = wavy_path(1, 2);
    path.points.resize(1);
    EXPECT_NO_THROW(SmallXml::parse(tool_path_svg(path)));
    EXPECT_THROW(tool_path_svg({}), DomainError);
}

// One cut in each class, and a link.
TEST(ToolPathSvg, ColoursCutsByTheUseOfTheirStrips)
{
    ToolPath path = wavy_path(1, 7);
    path.points.resize(7);
    path.points.back().move = Move::Link;
    const std::vector<double> use{0, 0, 0.3, 0.6, 0.9, 1.2, 0};
    const std::string svg = tool_path_svg(path, {}, PathDrawing{nullptr, use});
    for (const char* colour : {"#d7301f", "#f08a3c", "#5aae61", "#3690c0", "#173f7a"})
        EXPECT_EQ(lines_of(svg, colour).size(), 1U + 1) << colour;  // and the legend's
    EXPECT_TRUE(texts_of(svg).contains("cut, use below 25 %"));
    EXPECT_TRUE(lines_of(svg, "#1d4f91").empty());
    EXPECT_THROW(tool_path_svg(path, {}, PathDrawing{nullptr, std::span{use}.first(3)}),
                 DomainError);
}

TEST(ToolPathSvg, DrawsAMeshUnderThePath)
{
    const Part part = test::grid_mesh(3, 2, [](int i, int j) {
        return Vec3{20.0 * i, 20.0 * j, 0};
    });
    const std::string svg = tool_path_svg(wavy_path(2, 5), {}, PathDrawing{&part});
    int triangles = 0;
    for (const XmlElement& element : SmallXml::parse(svg))
        triangles += element.name == "path" && element.attributes.at("fill") != "none" &&
                             points_of(element.attributes.at("d")).size() == 3
                         ? 1
                         : 0;
    EXPECT_GE(triangles, 12);
    EXPECT_TRUE(texts_of(svg).contains("part"));
    EXPECT_FALSE(texts_of(tool_path_svg(wavy_path(2, 5))).contains("part"));
}

TEST(DensitySvg, ColoursAFifthOfTheCellsInEachColour)
{
    std::vector<DensityPiece> pieces;
    for (int k = 0; k < 10; ++k)
        pieces.push_back(
            {{Vec3(k, 0, 0), Vec3(k + 1, 0, 0), Vec3(k + 1, 1, 0), Vec3(k, 1, 0)},
             0.01 * ((7 * k) % 10 + 0.5)});
    const std::string text = density_svg(pieces, {"Part A"});
    EXPECT_THAT(text, testing::HasSubstr("Part A"));
    EXPECT_THAT(text, testing::HasSubstr("0.005 to 0.025 per mm"));
    for (const char* colour :
         {"#fcb171", "#e9776a", "#ab467b"})  // and the legend's sample
        EXPECT_EQ(lines_of(text, colour).size(), 2U + 1);
    EXPECT_EQ(lines_of(text, "#ffe9a8").size(), 3U + 1);
    EXPECT_EQ(lines_of(text, "#5f2a74").size(), 1U + 1);
}

TEST(DensitySvg, HasOneClassIfTheDensityIsConstant)
{
    const DensityPiece piece{{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 0}},
                             0.25};
    DensityPiece other = piece;
    other.density_per_mm = 0.2501;  // the same in three digits
    const std::string text = density_svg(std::vector{piece, other});
    EXPECT_THAT(text, testing::HasSubstr(">0.25 per mm<"));
    EXPECT_EQ(lines_of(text, "#ffe9a8").size(), 2U + 1);
}

TEST(DensitySvg, RefusesNoCellsAndADensityThatIsNotFinite)
{
    EXPECT_THROW(density_svg({}), DomainError);
    const DensityPiece piece{{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 0}},
                             std::numeric_limits<double>::quiet_NaN()};
    EXPECT_THROW(density_svg(std::vector{piece}), DomainError);
}

}  // namespace
}  // namespace endmill
