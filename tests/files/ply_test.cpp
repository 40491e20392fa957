// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/ply.h"

#include <cmath>
#include <cstdint>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"
#include "endmill/files/detail/ply_header.h"
#include "ply_samples.h"

namespace endmill {
namespace {

using testing::ElementsAre;
using testing::StartsWith;

RawMesh read(const std::string& text)
{
    return parse_ply({text, "f.ply"});
}

std::string ply_complaint(const std::string& text)
{
    return complaint_of([&] { read(text); });
}

std::string complaint_with(const std::string& from, const std::string& to)
{
    return ply_complaint(replaced(ascii_ply, from, to));
}

// A binary file with three points whose only face has the bytes `face`.
std::string binary_with_face(const std::string& list, const std::string& face)
{
    std::string text =
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty char x\n"
        "property char y\nproperty char z\nelement face 1\nproperty list " +
        list + " vertex_index\nend_header\n";
    return text + std::string{"\0\0\0\1\0\0\0\1\0", 9} + face;
}

// Both byte orders are accepted.
TEST(ParsePly, ReadsAllEncodingsAndSkipsTheRest)
{
    for (const std::string& text : {ascii_ply, binary_ply(false), binary_ply(true)}) {
        const RawMesh raw = read(text);
        EXPECT_THAT(raw.mesh.points(), ElementsAre(Vec3{0, 0, 0}, Vec3{1.5, 0, 0},
                                                   Vec3{1.5, 1, 0}, Vec3{0, 1, 0.5}));
        EXPECT_THAT(raw.mesh.triangles(),
                    ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
    }
}

TEST(ParsePly, ReadsIndicesOfEveryWholeType)
{
    for (const std::string type : {"char", "uchar"})
        EXPECT_EQ(read(binary_with_face("uchar " + type, "\3\2\1" + std::string(1, '\0')))
                      .mesh.triangles()[0],
                  (Triangle{2, 1, 0}));
    const std::string of_two_bytes{"\3\0\2\0\1\0\0\0", 8};
    for (const std::string type : {"short", "ushort"})
        EXPECT_EQ(
            read(binary_with_face("ushort " + type, of_two_bytes)).mesh.triangles()[0],
            (Triangle{2, 1, 0}));
    const std::string of_four_bytes{"\3\0\0\0\2\0\0\0\1\0\0\0\0\0\0\0", 16};
    for (const std::string type : {"int", "uint"})
        EXPECT_EQ(
            read(binary_with_face("int " + type, of_four_bytes)).mesh.triangles()[0],
            (Triangle{2, 1, 0}));
}

TEST(ParsePly, SplitsFacesOfMoreCorners)
{
    const RawMesh raw = read(replaced(replaced(ascii_ply, "face 2", "face 1"),
                                      "3 0 1 2 0.9\n3 0 2 3 0.8\n", "4 0 1 2 3 0.9\n"));
    EXPECT_THAT(raw.mesh.triangles(), ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
    EXPECT_EQ(raw.split_faces, 1U);
}

TEST(ParsePly, RefusesAHeaderWithoutAMesh)
{
    EXPECT_EQ(complaint_with("element vertex", "element point"),
              "E_PLY_SYNTAX f.ply:17: no element vertex; expected vertex and face");
    EXPECT_EQ(complaint_with("element face", "element tristrips"),
              "E_PLY_SYNTAX f.ply:17: no element face; expected vertex and face");
    EXPECT_EQ(complaint_with("float x", "float u"),
              "E_PLY_SYNTAX f.ply:6: a property is missing; expected x, y and z");
    EXPECT_EQ(complaint_with("double z", "list uchar int z"),
              "E_PLY_SYNTAX f.ply:6: a coordinate is a list; expected a number");
    EXPECT_EQ(complaint_with("vertex_indices", "corners"),
              "E_PLY_SYNTAX f.ply:12: a property is missing; expected vertex_indices");
    EXPECT_EQ(complaint_with("list uchar int vertex_indices", "int vertex_indices"),
              "E_PLY_SYNTAX f.ply:12: the corners are not a list of whole numbers; "
              "expected such as property list uchar int vertex_indices");
    EXPECT_EQ(complaint_with("list uchar int vertex_indices",
                             "list uchar float vertex_indices"),
              "E_PLY_SYNTAX f.ply:12: the corners are not a list of whole numbers; "
              "expected such as property list uchar int vertex_indices");
    EXPECT_EQ(complaint_with("float quality", "list uchar int vertex_index"),
              "E_PLY_SYNTAX f.ply:12: two lists of corners; expected one");
    EXPECT_EQ(complaint_with("element camera 1\nproperty float fov\n",
                             "element face 0\nproperty list uchar int vertex_index\n"),
              "E_PLY_SYNTAX f.ply:12: \"face\"; expected every element once");
    EXPECT_EQ(
        ply_complaint("ply\nformat ascii 1.0\nelement face 0\nproperty list uchar int "
                      "vertex_index\nelement vertex 0\nproperty int x\nproperty int y\n"
                      "property int z\nend_header\n"),
        "E_PLY_SYNTAX f.ply:3: the faces come before the points; "
        "expected element vertex, then element face");
}

TEST(ParsePly, RefusesMoreOrFewerItemsThanClaimed)
{
    EXPECT_EQ(complaint_with("7\n", ""),
              "E_COUNT f.ply:24: header claims 1 items \"edge\", file ends after 0");
    EXPECT_EQ(complaint_with("7\n", "7\n\n8\n"),
              "E_COUNT f.ply:27: file goes on after all items that the header claims");
    for (const bool is_big_endian : {false, true}) {
        const std::string text = binary_ply(is_big_endian);
        const std::string end = "E_COUNT f.ply@" + std::to_string(text.size());
        EXPECT_EQ(ply_complaint(text + '\n'),
                  end + ": file goes on after all items that the header claims");
        EXPECT_EQ(ply_complaint(text.substr(0, text.size() - 1)),
                  "E_COUNT f.ply@" + std::to_string(text.size() - 4) +
                      ": end of file within an item; expected 4 bytes of a number");
        EXPECT_EQ(ply_complaint(text.substr(0, text.size() - 4)),
                  "E_COUNT f.ply@" + std::to_string(text.size() - 4) +
                      ": header claims 1 items \"edge\", file ends after 0");
    }
}

TEST(ParsePly, RefusesListsBeyondTheEnd)
{
    const std::string text =
        binary_with_face("uchar int", "\xff" + std::string(12, '\0'));
    EXPECT_EQ(ply_complaint(text),
              "E_COUNT f.ply@" + std::to_string(text.size() - 13) +
                  ": a list of 255 numbers where 12 bytes can hold at most 3");
    EXPECT_EQ(ply_complaint(binary_with_face("char int", "\xff" + std::string(12, '\0'))),
              "E_COUNT f.ply@" + std::to_string(text.size() - 14) +
                  ": a list of -1 numbers; expected 0 or more");
    EXPECT_EQ(ply_complaint(binary_with_face("uint char",
                                             "\xff\xff\xff\xff" + std::string(4, '\0'))),
              "E_COUNT f.ply@" + std::to_string(text.size() - 13) +
                  ": a list of 4294967295 numbers where 4 bytes can hold at most 4");
    EXPECT_EQ(
        complaint_with("3 0 2 3 0.8", "255 0 2 3 0.8"),
        "E_COUNT f.ply:24: a list of 255 numbers where 10 bytes can hold at most 5");
    EXPECT_EQ(complaint_with("3 0 2 3 0.8", "4 0 2 3 0.8"),
              "E_PLY_SYNTAX f.ply:24: \"0.8\"; expected a whole number");
    EXPECT_EQ(complaint_with("3 0 2 3 0.8", "2 0 2 3 0.8"),
              "E_DEGENERATE f.ply:24: a face of 2 corners; expected at least 3");
    EXPECT_EQ(complaint_with("3 0 2 3 0.8", "3 0 2 3"),
              "E_PLY_SYNTAX f.ply:24: end of line; expected a number");
    EXPECT_EQ(complaint_with("3 0 2 3 0.8", "3 0 2 3 0.8 0.7"),
              "E_PLY_SYNTAX f.ply:24: \"0.7\"; expected the end of the line");
}

TEST(ParsePly, RefusesIndicesOfNoPoint)
{
    EXPECT_EQ(complaint_with("3 0 2 3 0.8", "3 0 2 -5 0.8"),
              "E_INDEX f.ply:24: index -5; expected 0 to 3");
    EXPECT_EQ(complaint_with("3 0 2 3 0.8", "3 0 2 1000000 0.8"),
              "E_INDEX f.ply:24: index 1000000; expected 0 to 3");
    const std::string face{"\3\0\0\0\0\1\0\0\0\xfb\xff\xff\xff", 13};
    const std::string text = binary_with_face("uchar int", face);
    EXPECT_EQ(ply_complaint(text), "E_INDEX f.ply@" + std::to_string(text.size() - 4) +
                                       ": index -5; expected 0 to 2");
    EXPECT_EQ(ply_complaint(replaced(text, "uchar int", "uchar uint")),
              "E_INDEX f.ply@" + std::to_string(text.size() - 3) +
                  ": index 4294967291; expected 0 to 2");
    EXPECT_EQ(complaint_with("3 0 2 3 0.8", "3 0 2 2 0.8"),
              "E_DEGENERATE f.ply:24: a face names a point twice; "
              "expected different corners");
}

TEST(ParsePly, RefusesInvalidCoordinates)
{
    EXPECT_EQ(complaint_with("255 0.5 0", "255 nan 0"),
              "E_NONFINITE f.ply:22: coordinate NaN; expected a finite number");
    EXPECT_EQ(complaint_with("255 0.5 0", "255 1e39 0"),
              "E_RANGE f.ply:22: coordinate 1e+39; expected at most 1e+06 mm "
              "(--max-extent)");
    std::string text =
        "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty "
        "float x\nproperty float y\nproperty float z\nelement face 0\n"
        "property list int int vertex_index\nend_header\n";
    const std::string place = std::to_string(text.size());
    append_number(text, 1.0F, true);
    append_number(text, INFINITY, true);
    append_number(text, 0.0F, true);
    EXPECT_EQ(ply_complaint(text), "E_NONFINITE f.ply@" + place +
                                       ": coordinate infinity; expected a finite number");
}

TEST(ParsePly, RefusesWhatNeedsMoreMemoryThanTheLimit)
{
    const std::string text = binary_ply(false);
    EXPECT_THROW(parse_ply({text, "f", {.max_memory_gib = 3e-7}}), LimitError);
    EXPECT_NO_THROW(parse_ply({text, "f", {.max_memory_gib = 1e-6}}));
}

TEST(ParsePly, RefusesAFaceWhoseCornersNeedMoreMemoryThanTheLimit)
{
    // Each corner has one byte in the file and several numbers in memory while its face
    // is split.
    constexpr std::uint32_t corners = 1'000'000;
    std::string text =
        "ply\nformat binary_little_endian 1.0\n"
        "element vertex 1\nproperty char x\nproperty char y\nproperty char z\n"
        "element face 1\nproperty list uint uchar vertex_index\nend_header\n" +
        std::string(3, '\0');
    append_number(text, corners, false);
    text.append(corners, '\0');
    const auto complaint_within = [&](double bytes) {
        const double gib = bytes / (1024.0 * 1024 * 1024);
        return complaint_of([&] { parse_ply({text, "f", {.max_memory_gib = gib}}); });
    };
    EXPECT_THAT(complaint_within(9e6),
                testing::StartsWith("E_LIMIT f: reading it needs"));
    EXPECT_THAT(complaint_within(5e7), testing::StartsWith("E_DEGENERATE"));
}

TEST(PlyText, WritesNormalsThatReadersMaySkip)
{
    const TriangleMesh mesh{{{0, 0, 0}, {0.1, 0, 0}, {0, 1e-7, 0}}, {{0, 1, 2}}};
    const std::vector<Vec3> normals(3, Vec3{0, 0, 1});
    const std::string text = ply_text(mesh, normals);
    EXPECT_THAT(text, StartsWith("ply\nformat binary_little_endian 1.0\n"));
    const PlyHeader header = parse_ply_header({text, "f"});
    EXPECT_EQ(text.size() - header.bytes, 3U * 48 + 13);
    EXPECT_EQ(header.elements[0].properties[3].name, "nx");
    EXPECT_TRUE(std::ranges::equal(read(text).mesh.points(), mesh.points()));
    EXPECT_EQ(ply_text(mesh).size() - parse_ply_header({ply_text(mesh), "f"}).bytes,
              3U * 24 + 13);
}

TEST(PlyText, WritesFaceNumbersThatReadBack)
{
    const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
                            {{0, 1, 2}, {1, 3, 2}}};
    const std::string text = ply_text(mesh, {}, std::array{7, 2147483647});
    const RawMesh back = read(text);
    EXPECT_THAT(back.face_numbers, testing::ElementsAre(7, 2147483647));
    EXPECT_TRUE(std::ranges::equal(back.mesh.triangles(), mesh.triangles()));
    EXPECT_THAT(read(ply_text(mesh)).face_numbers, testing::IsEmpty());
    EXPECT_THROW(ply_text(mesh, {}, std::array{7}), DomainError);
}

// A face of four corners becomes two triangles of one number.
TEST(ParsePly, GivesTheFaceNumberToAllTrianglesOfAFace)
{
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\nelement face 2\nproperty uchar face_number\n"
        "property list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 4 0 1 2 3\n9 3 0 1 2\n";
    EXPECT_THAT(read(text).face_numbers, testing::ElementsAre(3, 3, 9));
    std::string zero = text;
    zero.replace(text.find("\n9 3") + 1, 1, "0");
    EXPECT_THAT(complaint_of([&] { read(zero); }), testing::StartsWith("E_INDEX"));
    std::string real = text;
    real.replace(text.find("uchar face_number"), 5, "float");
    EXPECT_THAT(complaint_of([&] { read(real); }), testing::StartsWith("E_PLY_SYNTAX"));
}

TEST(PlyText, RefusesNormalsOfNoPoint)
{
    const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    EXPECT_THROW(ply_text(mesh, std::vector<Vec3>(2, Vec3::Zero())), DomainError);
    EXPECT_THROW(ply_text(mesh, std::vector<Vec3>(3, Vec3::Constant(NAN))), DomainError);
}

}  // namespace
}  // namespace endmill
