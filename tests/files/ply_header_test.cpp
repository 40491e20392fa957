// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/ply_header.h"

#include <gtest/gtest.h>

#include "complaint.h"
#include "ply_samples.h"

namespace endmill {
namespace {

std::string ply_header_complaint(const std::string& text)
{
    return complaint_of([&] { parse_ply_header({text, "f.ply"}); });
}

std::string complaint_with(const std::string& from, const std::string& to)
{
    return ply_header_complaint(replaced(ascii_ply, from, to));
}

TEST(PlyHeader, NamesElementsAndPropertiesInOrder)
{
    const PlyHeader header = parse_ply_header({ascii_ply, "f"});
    EXPECT_EQ(header.encoding, PlyEncoding::Ascii);
    EXPECT_EQ(header.lines, 17U);
    EXPECT_EQ(ascii_ply.substr(header.bytes, 4), "45.5");
    ASSERT_EQ(header.elements.size(), 4U);
    EXPECT_EQ(header.elements[0].name, "camera");
    const PlyElement& points = header.elements[1];
    EXPECT_EQ(points.name, "vertex");
    EXPECT_EQ(points.count, 4U);
    EXPECT_EQ(points.line, 6U);
    ASSERT_EQ(points.properties.size(), 5U);
    EXPECT_EQ(points.properties[1].name, "z");
    EXPECT_EQ(points.properties[1].type, PlyType::Float64);
    EXPECT_FALSE(points.properties[1].count_type);
    EXPECT_EQ(points.properties[2].type, PlyType::Int16);
    EXPECT_EQ(points.properties[2].count_type, PlyType::Uint8);
}

TEST(PlyHeader, KnowsTheTypesByBothNames)
{
    const std::pair<const char*, std::size_t> names[] = {
        {"char", 1},  {"int8", 1},    {"uchar", 1},  {"uint8", 1},
        {"short", 2}, {"int16", 2},   {"ushort", 2}, {"uint16", 2},
        {"int", 4},   {"int32", 4},   {"uint", 4},   {"uint32", 4},
        {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
    for (const auto& [name, bytes] : names) {
        const std::string text =
            replaced(ascii_ply, "float fov", std::string{name} + " fov");
        const PlyType type = parse_ply_header({text, "f"}).elements[0].properties[0].type;
        EXPECT_EQ(size_of(type), bytes) << name;
        const bool is_real = std::string_view{name}.starts_with("float") ||
                             std::string_view{name}.starts_with("double");
        EXPECT_NE(is_whole(type), is_real) << name;
    }
}

TEST(PlyHeader, TakesCommentsAndCarriageReturns)
{
    std::string text =
        "ply\r\nobj_info x\r\nformat binary_big_endian 1.0\r\ncomment\r\n"
        "element vertex 0\r\nproperty float x\r\nend_header\r\n\n";
    const PlyHeader header = parse_ply_header({text, "f"});
    EXPECT_EQ(header.encoding, PlyEncoding::BigEndian);
    EXPECT_EQ(text.size() - header.bytes, 1U);
}

TEST(PlyHeader, RefusesInvalidHeaders)
{
    EXPECT_EQ(ply_header_complaint("plyx\n"),
              "E_PLY_SYNTAX f.ply:1: \"plyx\"; expected \"ply\"");
    EXPECT_EQ(ply_header_complaint("ply\n"),
              "E_PLY_SYNTAX f.ply:1: end of file; expected \"format\"");
    EXPECT_EQ(complaint_with("ascii", "text"),
              "E_PLY_SYNTAX f.ply:2: \"text\"; expected \"ascii\", "
              "\"binary_little_endian\" or \"binary_big_endian\"");
    EXPECT_EQ(complaint_with("ascii 1.0", "ascii 2.0"),
              "E_PLY_SYNTAX f.ply:2: \"2.0\"; expected \"1.0\"");
    EXPECT_EQ(complaint_with("element camera", "elements camera"),
              "E_PLY_SYNTAX f.ply:4: \"elements\"; expected \"element\", \"property\" or "
              "\"end_header\"");
    EXPECT_EQ(ply_header_complaint(ascii_ply.substr(0, ascii_ply.find("end_header"))),
              "E_PLY_SYNTAX f.ply:16: end of file; expected \"element\", \"property\" or "
              "\"end_header\"");
    EXPECT_EQ(complaint_with("element camera 1\n", ""),
              "E_PLY_SYNTAX f.ply:4: a property before any element; expected an element "
              "before it");
    EXPECT_EQ(complaint_with("property float fov\n", ""),
              "E_PLY_SYNTAX f.ply:4: an element without properties; "
              "expected at least one");
    EXPECT_EQ(complaint_with("vertex 4", "camera 4"),
              "E_PLY_SYNTAX f.ply:6: \"camera\"; expected every element once");
    EXPECT_EQ(complaint_with("float x", "float z"),
              "E_PLY_SYNTAX f.ply:10: \"z\"; expected every property of an element once");
    EXPECT_EQ(complaint_with("float x", "float"),
              "E_PLY_SYNTAX f.ply:10: end of line; expected the name of a property");
    EXPECT_EQ(complaint_with("vertex 4", "vertex 4.0"),
              "E_PLY_SYNTAX f.ply:6: \"4.0\"; expected a whole number");
}

TEST(PlyHeader, RefusesTypesThatDoNotExist)
{
    const std::string expected =
        "; expected a type: char, uchar, short, ushort, int, uint, float or double";
    EXPECT_EQ(complaint_with("float x", "half x"),
              "E_PLY_SYNTAX f.ply:10: \"half\"" + expected);
    EXPECT_EQ(complaint_with("list uchar int", "list int64 int"),
              "E_PLY_SYNTAX f.ply:13: \"int64\"" + expected);
    EXPECT_EQ(complaint_with("list uchar int", "list float int"),
              "E_PLY_SYNTAX f.ply:13: the length of a list is not a whole number; "
              "expected a type of whole numbers");
}

TEST(PlyHeader, RefusesCountsThatTheFileCannotHold)
{
    EXPECT_EQ(
        complaint_with("vertex 4", "vertex 4000000000"),
        "E_COUNT f.ply:6: header claims 4000000000 items, file of 425 bytes can hold "
        "at most 9");
    EXPECT_EQ(complaint_with("vertex 4", "vertex -4"),
              "E_COUNT f.ply:6: header claims -4 items; expected 0 or more");
    const std::string binary = replaced(binary_ply(false), "face 2", "face 10");
    EXPECT_EQ(ply_header_complaint(binary),
              "E_COUNT f.ply:12: header claims 10 items, file of " +
                  std::to_string(binary.size()) + " bytes can hold at most 8");
}

TEST(PlyHeader, HasAtMostAThousandProperties)
{
    std::string text = "ply\nformat ascii 1.0\nelement a 0\n";
    for (int i = 0; i < 999; ++i)
        text += "property int x" + std::to_string(i) + "\n";
    EXPECT_EQ(ply_header_complaint(text + "end_header\n"), "accepted");
    EXPECT_EQ(ply_header_complaint(text + "property int y\nend_header\n"),
              "E_LIMIT f.ply:1003: over 1000 elements and properties; "
              "expected at most 1000");
}

}  // namespace
}  // namespace endmill
