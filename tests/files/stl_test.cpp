// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/stl.h"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"

namespace endmill {
namespace {

using Corners = std::array<Vec3, 3>;
using std::string_literals::operator""s;

// A binary STL built byte by byte; all triangles have the given corners.
std::string binary(std::uint32_t claimed, int triangles, std::array<float, 9> corners,
                   const std::string& header = "made by a test")
{
    std::string text = header;
    text.resize(80, ' ');
    for (int shift = 0; shift < 32; shift += 8)
        text += static_cast<char>(claimed >> shift & 0xffU);
    for (int i = 0; i < triangles; ++i) {
        std::array<char, 48> numbers{};
        std::memcpy(numbers.data() + 12, corners.data(), 36);
        text.append(numbers.data(), numbers.size());
        text += "\x12\x34";
    }
    return text;
}

constexpr std::array<float, 9> some_corners{0, 0, 0, 1.5, 0, 0, 0, -2.25, 1e-3F};

const std::string facet =
    "  facet normal 0 0 1\n"
    "    outer loop\n"
    "      vertex 0 0 0\n"
    "      vertex 1.5 0 0\n"
    "      vertex 0 -2.25 1e-3\n"
    "    endloop\n"
    "  endfacet\n";
const std::string ascii = "solid a part\n" + facet + "endsolid a part\n";

std::vector<Corners> read(const std::string& text)
{
    return parse_stl({text, "f.stl"});
}

std::string stl_complaint(const std::string& text)
{
    return complaint_of([&] { read(text); });
}

TEST(ParseStl, ReadsBinary)
{
    const std::vector<Corners> soup = read(binary(3, 3, some_corners));
    EXPECT_THAT(soup, testing::Each(Corners{Vec3{0, 0, 0}, Vec3{1.5, 0, 0},
                                            Vec3{0, -2.25, double{1e-3F}}}));
    EXPECT_EQ(soup.size(), 3U);
    EXPECT_TRUE(read(binary(0, 0, {})).empty());
}

TEST(ParseStl, ReadsAsciiWithAnyLineBreaks)
{
    const Corners expected{Vec3{0, 0, 0}, Vec3{1.5, 0, 0}, Vec3{0, -2.25, 1e-3}};
    EXPECT_THAT(read(ascii), testing::ElementsAre(expected));
    std::string on_few_lines = facet;
    for (char& letter : on_few_lines)
        letter = letter == '\n' ? '\t' : letter;
    EXPECT_THAT(read("solid\r\n" + on_few_lines + on_few_lines + "endsolid"),
                testing::ElementsAre(expected, expected));
    EXPECT_THAT(read("\xef\xbb\xbf\n\n" + ascii + ascii),
                testing::ElementsAre(expected, expected));
    std::string capitals = ascii;
    for (char& letter : capitals)
        letter = letter == 'e' ? letter : static_cast<char>(std::toupper(letter));
    EXPECT_THAT(read(capitals), testing::ElementsAre(expected));
    EXPECT_TRUE(read("solid\nendsolid\n").empty());
}

// A valid file with an unusual header.
TEST(ParseStl, RecognisesBinaryFilesByTheirLengthEvenIfTheyBeginWithSolid)
{
    const std::string text = binary(2, 2, some_corners, "solid facet normal");
    EXPECT_TRUE(is_binary_stl(text));
    EXPECT_EQ(read(text).size(), 2U);
    EXPECT_FALSE(is_binary_stl(ascii));
    EXPECT_FALSE(is_binary_stl(text + ' '));
    EXPECT_FALSE(is_binary_stl(""));
}

TEST(ParseStl, RefusesABinaryFileWhoseLengthContradictsItsHeader)
{
    EXPECT_EQ(stl_complaint("binary"s + std::string(44, '\0')),
              "E_STL_SIZE f.stl: file has 50 bytes and does not begin with \"solid\"; "
              "expected at least 84 bytes of a binary STL");
    EXPECT_EQ(stl_complaint(binary(0xffffffff, 2, some_corners)),
              "E_STL_SIZE f.stl@80: header says 4294967295 triangles (214748364834 "
              "bytes), file has 184");
    EXPECT_EQ(stl_complaint(binary(1, 2, some_corners)),
              "E_STL_SIZE f.stl@80: header says 1 triangles (134 bytes), file has 184");
    EXPECT_EQ(stl_complaint(binary(2, 2, some_corners).substr(0, 170)),
              "E_STL_SIZE f.stl@80: header says 2 triangles (184 bytes), file has 170");
    EXPECT_EQ(stl_complaint(binary(2, 2, some_corners) + "\n"),
              "E_STL_SIZE f.stl@80: header says 2 triangles (184 bytes), file has 185");
    EXPECT_EQ(stl_complaint(binary(2, 2, some_corners, "solid a").substr(0, 183)),
              "E_STL_SIZE f.stl@80: header says 2 triangles (184 bytes), file has 183; "
              "expected a binary STL of that size, or text without zero bytes");
}

// The first word is that of a text, which has no zero bytes, and no binary file is so short.
TEST(ParseStl, NamesAZeroByteAfterTheFirstWord)
{
    EXPECT_EQ(stl_complaint("solid \0"s),
              "E_STL_SIZE f.stl@6: a zero byte after \"solid\", in a file of 7 bytes; "
              "expected text without zero bytes, or at least 84 bytes of a binary STL");
}

TEST(ParseStl, RefusesAsciiThatIsNotStl)
{
    EXPECT_EQ(stl_complaint(replaced(ascii, "  endfacet\n", "")),
              "E_STL_SYNTAX f.stl:8: \"endsolid\"; expected \"endfacet\"");
    EXPECT_EQ(stl_complaint("solid a\n" + facet),
              "E_STL_SYNTAX f.stl:8: end of file; expected \"facet\" or \"endsolid\"");
    EXPECT_EQ(stl_complaint(replaced(ascii, "      vertex 1.5 0 0\n", "")),
              "E_STL_SYNTAX f.stl:6: \"endloop\"; expected \"vertex\"");
    EXPECT_EQ(stl_complaint(replaced(ascii, "endloop", "vertex 1 2 3\nendloop")),
              "E_STL_SYNTAX f.stl:7: \"vertex\"; expected \"endloop\"");
    EXPECT_EQ(stl_complaint(replaced(ascii, "1.5", "one")),
              "E_STL_SYNTAX f.stl:5: \"one\"; expected a number");
    EXPECT_EQ(stl_complaint(replaced(ascii, "1.5", "1,5")),
              "E_STL_SYNTAX f.stl:5: \"1,5\"; expected a number, with \".\" as decimal "
              "sign");
    EXPECT_EQ(stl_complaint(replaced(ascii, "1.5 0 0", "1.5 0")),
              "E_STL_SYNTAX f.stl:5: end of line; expected a number");
    EXPECT_EQ(
        stl_complaint(ascii + "more"),
        "E_STL_SYNTAX f.stl:10: \"more\"; expected \"solid\" or the end of the file");
    EXPECT_EQ(stl_complaint("solid"),
              "E_STL_SYNTAX f.stl:1: end of file; expected \"facet\" or \"endsolid\"");
    EXPECT_EQ(stl_complaint(replaced(ascii, "outer", "inner")),
              "E_STL_SYNTAX f.stl:3: \"inner\"; expected \"outer\"");
}

TEST(ParseStl, RefusesInvalidCoordinates)
{
    const auto with = [](float z) {
        std::array<float, 9> corners = some_corners;
        corners[5] = z;
        return stl_complaint(binary(1, 1, corners));
    };
    EXPECT_EQ(with(std::nanf("")),
              "E_NONFINITE f.stl@108: coordinate NaN; expected a finite number");
    EXPECT_EQ(with(-INFINITY),
              "E_NONFINITE f.stl@108: coordinate -infinity; expected a finite number");
    EXPECT_EQ(with(2e6F),
              "E_RANGE f.stl@108: coordinate 2e+06; expected at most 1e+06 mm "
              "(--max-extent)");
    const auto spelled = [](const std::string& number) {
        return stl_complaint(replaced(ascii, "1.5", number));
    };
    EXPECT_EQ(spelled("nan"),
              "E_NONFINITE f.stl:5: coordinate NaN; expected a finite number");
    EXPECT_EQ(spelled("-inf"),
              "E_NONFINITE f.stl:5: coordinate -infinity; expected a finite number");
    EXPECT_EQ(spelled("1e39"),
              "E_RANGE f.stl:5: coordinate 1e+39; expected at most 1e+06 mm "
              "(--max-extent)");
    EXPECT_EQ(spelled("1e999"),
              "E_RANGE f.stl:5: \"1e999\"; expected a number that a double can hold");
    const std::string far = replaced(ascii, "1.5", "2e6");
    EXPECT_NO_THROW(parse_stl({far, "f", {.max_extent_mm = 2e6}}));
}

TEST(ParseStl, IgnoresNormals)
{
    EXPECT_EQ(stl_complaint(replaced(ascii, "normal 0 0 1", "normal nan 0 -inf")),
              "accepted");
}

TEST(ParseStl, RefusesWhatNeedsMoreMemoryThanTheLimit)
{
    const std::string text = binary(1000, 1000, some_corners);
    EXPECT_NO_THROW(parse_stl({text, "f", {.max_memory_gib = 2e-4}}));
    EXPECT_THROW(parse_stl({text, "f", {.max_memory_gib = 1e-4}}), LimitError);
    std::string long_line = ascii;
    long_line.insert(20, std::string(1U << 20U, ' '));
    EXPECT_EQ(stl_complaint(long_line),
              "E_LIMIT f.stl:2: line is longer than 1 MiB; expected lines of at most "
              "1048576 bytes");
}

TEST(StlText, HasTheSizeAndTheNormalsOfTheFormat)
{
    const TriangleMesh mesh{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {5, 0, 0}},
                            {{0, 1, 2}, {0, 1, 3}}};
    const std::string text = stl_text(mesh);
    EXPECT_EQ(text.size(), 84U + 2 * 50);
    EXPECT_FALSE(text.starts_with("solid"));
    std::array<float, 3> normal{};
    std::memcpy(normal.data(), text.data() + 84, 12);
    EXPECT_THAT(normal, testing::ElementsAre(0, 0, 1));
    std::memcpy(normal.data(), text.data() + 134, 12);
    EXPECT_THAT(normal, testing::ElementsAre(0, 0, 0));
    EXPECT_THAT(stl_ascii_text(mesh),
                testing::StartsWith("solid endmill\nfacet normal 0 0 1\nouter loop\n"
                                    "vertex 0 0 0\nvertex 2 0 0\nvertex 0 2 0\n"
                                    "endloop\nendfacet\nfacet normal 0 0 0\n"));
}

TEST(StlText, RefusesCoordinatesOutsideTheRangeOfFloat)
{
    const TriangleMesh far{{{0, 0, 0}, {1e39, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}};
    EXPECT_THROW(stl_text(far), DomainError);
    EXPECT_THAT(stl_ascii_text(far), testing::HasSubstr("vertex 1e+39 0 0"));
    const double most = std::numeric_limits<double>::max();
    const TriangleMesh farthest{{{-most, 0, 0}, {most, 0, 0}, {0, most, 0}}, {{0, 1, 2}}};
    EXPECT_THAT(stl_ascii_text(farthest), testing::Not(testing::HasSubstr("nan")));
}

}  // namespace
}  // namespace endmill
