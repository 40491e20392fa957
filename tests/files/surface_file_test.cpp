// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/surface_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "random.h"
#include "surface_json.h"
#include "temporary_folder.h"

namespace endmill {
namespace {

using testing::HasSubstr;

// The control point in column i and row j of every net below.
Vec3 net_point(int i, int j)
{
    return {10.0 * i, 7.5 * j, 0.1 * i * j - 1.0 / (1 + i + j)};
}

std::string number(double value)
{
    std::array<char, 32> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.17g", value);
    return buffer.data();
}

std::string point_text(int i, int j)
{
    const Vec3 p = net_point(i, j);
    return "[" + number(p.x()) + ", " + number(p.y()) + ", " + number(p.z()) + "]";
}

std::string net_text(int columns, int rows)
{
    std::string text = "[";
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            text += (i == 0 ? (j == 0 ? "[" : "], [") : ", ") + point_text(i, j);
    return text + "]]";
}

std::string surface_text(const std::string& more_keys = "", int columns = 7, int rows = 4)
{
    return R"({"format": "endmill-surface/1", "type": "bezier", )" + more_keys +
           R"("patches_u": 2, "patches_v": 1, "control_points": )" +
           net_text(columns, rows) + "}";
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

// "CODE message" of the error in `text`; "accepted" if there is none.
std::string surface_file_complaint(const std::string& text)
{
    try {
        parse_surface(text, "f.json");
        return "accepted";
    } catch (const FormatError& error) {
        return error.code() + " " + error.what();
    }
}

TEST(ReadSurface, PlacesEveryControlPointByTheRuleOfTheFormat)
{
    const TemporaryFolder folder;
    const auto path = folder.put("wave.json", surface_text());
    const SurfaceFile file = read_surface(path);
    EXPECT_EQ(file.name, "wave");
    EXPECT_EQ(file.source, "");
    EXPECT_TRUE(file.notes.empty());
    EXPECT_EQ(file.surfaces.front().tool_side(), ToolSide::Up);
    ASSERT_EQ(file.surfaces.front().patches(Parameter::U), 2);
    ASSERT_EQ(file.surfaces.front().patches(Parameter::V), 1);
    EXPECT_THAT(file.surfaces.front().breaks(Parameter::U),
                testing::ElementsAre(0, 1, 2));
    for (int patch = 0; patch < 2; ++patch)
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i)
                EXPECT_EQ(file.surfaces.front().patch(patch, 0).control_point(i, j),
                          net_point(3 * patch + i, j));
}

TEST(ReadSurface, TakesNameSourceAndToolSide)
{
    const SurfaceFile file = parse_surface(
        surface_text(
            R"("name": "a\u001b[1mb", "source": "s", "tool_side": "dv_cross_du", )"),
        "f");
    EXPECT_EQ(file.name, "a[1mb");
    EXPECT_EQ(file.source, "s");
    EXPECT_EQ(file.surfaces.front().tool_side(), ToolSide::DvCrossDu);
}

TEST(ReadSurface, ConvertsInchesAndAddsANote)
{
    const SurfaceFile inch = parse_surface(surface_text("\"units\": \"inch\", "), "f");
    EXPECT_EQ(inch.surfaces.front().patch(1, 0).control_point(3, 3),
              25.4 * net_point(6, 3));
    EXPECT_THAT(inch.notes, testing::ElementsAre(HasSubstr("inch")));
    EXPECT_TRUE(parse_surface(surface_text("\"units\": \"mm\", "), "f").notes.empty());
}

TEST(ReadSurface, RefusesRowsOfTheWrongNumberOrLength)
{
    EXPECT_THAT(surface_file_complaint(surface_text("", 6, 4)),
                testing::AllOf(testing::StartsWith("E_SURFACE f.json:/control_points/0:"),
                               HasSubstr("row has 6 points; expected 7")));
    EXPECT_THAT(surface_file_complaint(surface_text("", 7, 5)),
                testing::AllOf(testing::StartsWith("E_SURFACE f.json:/control_points:"),
                               HasSubstr("5 rows; expected 4")));
    EXPECT_THAT(surface_file_complaint(
                    replaced(surface_text(), point_text(6, 2), point_text(6, 2) + ", 1")),
                HasSubstr("/control_points/2: row has 8 points"));
}

TEST(ReadSurface, ReportsAHugeDeclaredSizeWithoutAllocatingMemory)
{
    const std::string big =
        replaced(surface_text(), "\"patches_u\": 2", "\"patches_u\": 10000");
    EXPECT_THAT(
        surface_file_complaint(replaced(big, "\"patches_v\": 1", "\"patches_v\": 10000")),
        HasSubstr("expected 30001"));
    for (const std::string count : {"0", "-1", "10001", "4294967298", "2.0", "1e1"})
        EXPECT_THAT(surface_file_complaint(replaced(surface_text(), "\"patches_u\": 2",
                                                    "\"patches_u\": " + count)),
                    testing::AllOf(testing::StartsWith("E_JSON f.json:/patches_u:"),
                                   HasSubstr("whole number from 1 to 10000")))
            << count;
}

TEST(ReadSurface, NamesThePlaceOfABadCoordinate)
{
    const auto with = [](const std::string& text) {
        return surface_file_complaint(replaced(surface_text(), point_text(2, 3), text));
    };
    EXPECT_THAT(with("[1, 2, 1e7]"),
                testing::StartsWith("E_RANGE f.json:/control_points/3/2/2:"));
    EXPECT_THAT(
        with("[1, \"2\", 3]"),
        testing::StartsWith("E_JSON f.json:/control_points/3/2/1: \"2\"; expected a"));
    EXPECT_THAT(
        with("[1, 2]"),
        testing::StartsWith("E_JSON f.json:/control_points/3/2: a point of 2 numbers;"));
    EXPECT_THAT(with("7"), testing::StartsWith("E_JSON f.json:/control_points/3/2: 7;"));
    EXPECT_THAT(with("[1, NaN, 3]"),
                testing::AllOf(testing::StartsWith("E_JSON f.json:1:"),
                               HasSubstr(": NaN is not")));
    EXPECT_THAT(
        with("[1, 1e-999, 3]"),
        testing::StartsWith("E_JSON f.json:/control_points/3/2/1: 1e-999 underflows"));
    EXPECT_EQ(with("[1e6, -1e6, 1e6]"), "accepted");
}

TEST(ReadSurface, MeasuresTheExtentInMmAndAgainstTheLimitGiven)
{
    const std::string text = replaced(surface_text("\"units\": \"inch\", "),
                                      point_text(0, 0), "[50000, 0, 0]");
    EXPECT_THAT(
        surface_file_complaint(text),
        testing::AllOf(testing::StartsWith("E_RANGE f.json:/control_points/0/0/0"),
                       HasSubstr("--max-extent")));
    EXPECT_NO_THROW(parse_surface(text, "f", {.max_extent_mm = 2e6}));
    EXPECT_THAT([] { parse_surface(surface_text(), "f", {.max_extent_mm = 59}); },
                testing::ThrowsMessage<FormatError>(HasSubstr("at most 59 mm")));
}

TEST(ReadSurface, RefusesOtherFiles)
{
    EXPECT_THAT(surface_file_complaint("solid a\n"), HasSubstr("content looks like STL"));
    EXPECT_THAT(surface_file_complaint("v 0 0 0\n"), HasSubstr("content looks like OBJ"));
    EXPECT_THAT(
        surface_file_complaint("hello"),
        testing::AllOf(testing::StartsWith("E_FORMAT"), HasSubstr("expected JSON")));
    EXPECT_THAT(surface_file_complaint("[1]"), HasSubstr("expected an object"));
    EXPECT_THAT(surface_file_complaint("{}"), HasSubstr("\"format\" is missing"));
}

TEST(ReadSurface, DistinguishesANewerFormatFromAnother)
{
    const auto with = [](const std::string& format) {
        return surface_file_complaint(
            replaced(surface_text(), "endmill-surface/1", format));
    };
    EXPECT_THAT(with("endmill-surface/2"),
                testing::AllOf(testing::StartsWith("E_JSON f.json:/format:"),
                               HasSubstr("made by a newer version")));
    for (const std::string format :
         {"endmill-machine/1", "endmill-surface/0", "endmill-surface/"})
        EXPECT_THAT(with(format), testing::StartsWith("E_FORMAT f.json:/format: \"" +
                                                      format + "\"; expected "));
}

TEST(ReadSurface, SuggestsAKindForAnUnknownOne)
{
    EXPECT_THAT(
        surface_file_complaint(replaced(surface_text(), "\"bezier\"", "\"beizer\"")),
        HasSubstr("did you mean \"bezier\"?"));
}

TEST(ReadSurface, RefusesUnknownAndReservedKeys)
{
    EXPECT_THAT(surface_file_complaint(surface_text("\"patch_u\": 2, ")),
                testing::AllOf(testing::StartsWith("E_JSON f.json:/patch_u: unknown key"),
                               HasSubstr("did you mean \"patches_u\"?")));
    EXPECT_THAT(
        surface_file_complaint(surface_text("\"trim_loops\": [], ")),
        testing::AllOf(testing::StartsWith("E_SURFACE"), HasSubstr("trim_loops")));
}

TEST(ReadSurface, RefusesANetThatIsOnePoint)
{
    std::string net = "[";
    for (int j = 0; j < 4; ++j)
        net += std::string{j == 0 ? "" : ", "} + "[[1,2,3], [1,2,3], [1,2,3], [1,2,3]]";
    EXPECT_THAT(
        surface_file_complaint(R"({"format": "endmill-surface/1", "type": "bezier",
                                   "patches_u": 1, "patches_v": 1, "control_points": )" +
                               net + "]}"),
        testing::AllOf(testing::StartsWith("E_SURFACE"),
                       HasSubstr("all control points are equal")));
}

TEST(ReadSurface, AcceptsAPoleWithANote)
{
    std::string row_is_point = surface_text();
    for (int i = 1; i < 7; ++i)
        row_is_point = replaced(row_is_point, point_text(i, 0), point_text(0, 0));
    EXPECT_THAT(parse_surface(row_is_point, "f").notes,
                testing::ElementsAre(HasSubstr("border v = 0 is a single point")));

    std::string column_is_point = surface_text();
    for (int j = 1; j < 4; ++j)
        column_is_point = replaced(column_is_point, point_text(6, j), point_text(6, 0));
    EXPECT_THAT(parse_surface(column_is_point, "f").notes,
                testing::ElementsAre(HasSubstr("border u = 2 is a single point")));
}

TEST(ReadSurface, ReadsOrRefusesEveryMutatedFile)
{
    const std::string sound = surface_text("\"units\": \"inch\", \"name\": \"n\", ");
    std::mt19937 random{20};
    const std::string bytes = "{}[]\",:0123456789eE.-+ \\u\n\xff\x80tfn";
    for (int trial = 0; trial < 3000; ++trial) {
        std::string text = sound;
        for (int edits = 1 + static_cast<int>(random() % 3); edits > 0; --edits)
            text[random() % text.size()] = bytes[random() % bytes.size()];
        if (trial % 10 == 0)
            text.resize(random() % text.size());
        try {
            const SurfaceFile file = parse_surface(text, "f");
            EXPECT_TRUE(std::isfinite(file.surfaces.front().diagonal()));
        } catch (const FormatError& error) {
            EXPECT_FALSE(error.code().empty());
        }
    }
}

TEST(SurfaceFile, KeepsEveryDoubleOfItsText)
{
    test::Random random{3};
    std::vector<Vec3> net(16);
    for (Vec3& point : net)
        point = {random.uniform(-1e6, 1e6), random.uniform(-1e-3, 1e-3),
                 random.uniform(-1e6, 1e6)};
    const SurfaceFile written{"a \"name\"",
                              "by hand\\",
                              {composite_bezier(1, 1, net, ToolSide::DuCrossDv)},
                              {}};
    const SurfaceFile read = parse_surface(test::surface_json(written), "f");
    EXPECT_EQ(read.name, written.name);
    EXPECT_EQ(read.source, written.source);
    EXPECT_EQ(read.surfaces.front().tool_side(), ToolSide::DuCrossDv);
    for (int k = 0; k < 16; ++k)
        EXPECT_EQ(read.surfaces.front().patch(0, 0).control_point(k % 4, k / 4), net[k]);
}

}  // namespace
}  // namespace endmill
