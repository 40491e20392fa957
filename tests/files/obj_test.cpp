// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/obj.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"

namespace endmill {
namespace {

using testing::ElementsAre;
using testing::StartsWith;

const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\n";

RawMesh read(const std::string& text)
{
    return parse_obj({text, "f.obj"});
}

std::vector<Triangle> triangles_of(const std::string& text)
{
    const RawMesh raw = read(text);
    return {raw.mesh.triangles().begin(), raw.mesh.triangles().end()};
}

std::string obj_complaint(const std::string& text)
{
    return complaint_of([&] { read(text); });
}

TEST(ParseObj, ReadsPointsAndFaces)
{
    const RawMesh raw = read(points + "f 1 2 3\nf 1 3 4\n");
    EXPECT_THAT(raw.mesh.points(), ElementsAre(Vec3{0, 0, 0}, Vec3{1, 0, 0},
                                               Vec3{1, 1, 0}, Vec3{0, 1, 0.5}));
    EXPECT_THAT(raw.mesh.triangles(), ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
    EXPECT_EQ(raw.split_faces, 0U);
}

// The four notations of a corner in the document of the format.
TEST(ParseObj, TakesTextureAndNormalsOfCornersAsGiven)
{
    EXPECT_THAT(triangles_of(points + "vt 0 0\nvn 0 0 1\n"
                                      "f 1/1 2/1 3/1\nf 1//1 3//1 4//1\n"
                                      "f 2/1/1 3/1/1 4/1/1\nf 1/-1/-1 2 4//-1\n"),
                ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{1, 2, 3},
                            Triangle{0, 1, 3}));
}

TEST(ParseObj, CountsNegativeNumbersBackFromTheLine)
{
    EXPECT_THAT(triangles_of(points + "f -4 -3 -2\nv 9 9 9\nf -1 -5 2\n"),
                ElementsAre(Triangle{0, 1, 2}, Triangle{4, 0, 1}));
}

TEST(ParseObj, SplitsFacesOfMoreCorners)
{
    const RawMesh raw = read(points + "f 1 2 3 4\n");
    EXPECT_THAT(raw.mesh.triangles(), ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
    EXPECT_EQ(raw.split_faces, 1U);
    EXPECT_GT(raw.out_of_plane_mm, 0);
}

TEST(ParseObj, IgnoresStatementsThatDoNotAffectTheShape)
{
    EXPECT_THAT(
        triangles_of("# by hand\r\nmtllib a b.mtl\r\no part # one\ng side top\ns off\n"
                     "usemtl steel\nv 0 0 0 1.0\n\tv 1 0 0 0.5 0.5 0.5\nv 0 1 0\n"
                     "vn nan x y\nvt\nl 1 2\np 1\nbevel on\nf 1 2 3 # the only one"),
        ElementsAre(Triangle{0, 1, 2}));
}

TEST(ParseObj, SkipsAndCountsLinesWithUnknownWords)
{
    const RawMesh raw =
        read("c made by hand\nc 17\n" + points + "vertex_color 1 0 0\nf 1 2 3\nc end\n");
    EXPECT_THAT(raw.mesh.triangles(), ElementsAre(Triangle{0, 1, 2}));
    EXPECT_THAT(raw.notes, ElementsAre("4 lines with unknown words were skipped: c (3), "
                                       "vertex_color (1)"));
    std::string many = points;
    for (int k = 0; k < 20; ++k)
        many += "w" + std::to_string(k) + " 1\n";
    EXPECT_THAT(
        read(many + "f 1 2 3\n").notes,
        ElementsAre("20 lines with unknown words were skipped: w0 (1), w1 (1), w2 "
                    "(1), w3 (1), w4 (1), w5 (1), w6 (1), w7 (1), others (12)"));
    EXPECT_TRUE(read(points + "f 1 2 3\n").notes.empty());
}

TEST(ParseObj, RefusesOtherContent)
{
    EXPECT_EQ(obj_complaint("cstype bezier\n" + points),
              "E_OBJ_SYNTAX f.obj:1: free-form statement \"cstype\"; "
              "expected a mesh of points (v) and faces (f)");
    EXPECT_EQ(obj_complaint(points + "f: 1 2 3\n"),
              "E_OBJ_SYNTAX f.obj:5: \"f:\"; expected an OBJ statement, such as v or f");
    EXPECT_EQ(obj_complaint("hello\nworld 1 2 3\n"),
              "E_OBJ_SYNTAX f.obj:1: no line begins with a word of OBJ; expected "
              "statements such as v and f");
    EXPECT_EQ(obj_complaint("v 0 0\n"),
              "E_OBJ_SYNTAX f.obj:1: end of line; expected a number");
    EXPECT_EQ(obj_complaint("v 0 0,5 1\n"),
              "E_OBJ_SYNTAX f.obj:1: \"0,5\"; expected a number, with \".\" as decimal "
              "sign");
    EXPECT_EQ(obj_complaint("v 0 0 0 white\n"),
              "E_OBJ_SYNTAX f.obj:1: \"white\"; expected a number");
    for (const std::string corner : {"x", "1/", "1//", "1/2/", "1/2/3/4", "/1", "1.0",
                                     "1/a", "1\\", "\\", "99999999999999999999"}) {
        std::string text = points;
        text += "f 1 2 ";
        text += corner;
        text += "\n";
        EXPECT_EQ(obj_complaint(text),
                  "E_OBJ_SYNTAX f.obj:5: \"" + corner +
                      "\"; expected a corner: v, v/vt, v//vn or v/vt/vn");
    }
}

TEST(ParseObj, RefusesIndicesOfNoPoint)
{
    const auto with = [](const std::string& index) {
        return obj_complaint(points + "f 1 2 " + index + "\nv 7 7 7\n");
    };
    const std::string expected = "; expected 1 to 4, or -1 to -4, for the points above";
    EXPECT_EQ(with("0"), "E_INDEX f.obj:5: index 0" + expected);
    EXPECT_EQ(with("5"), "E_INDEX f.obj:5: index 5" + expected);
    EXPECT_EQ(with("-5"), "E_INDEX f.obj:5: index -5" + expected);
    EXPECT_EQ(with("4294967297/1"), "E_INDEX f.obj:5: index 4294967297" + expected);
    EXPECT_EQ(obj_complaint("f 1 2 3\n" + points),
              "E_INDEX f.obj:1: index 1; expected points (v) above the faces");
}

TEST(ParseObj, RefusesInvalidFacesAndEndlessLines)
{
    EXPECT_EQ(obj_complaint(points + "f 1 2\n"),
              "E_DEGENERATE f.obj:5: a face of 2 corners; expected at least 3");
    EXPECT_EQ(obj_complaint(points + "f 1 1 2\n"),
              "E_DEGENERATE f.obj:5: a face names a point twice; "
              "expected different corners");
    EXPECT_THAT(obj_complaint(points + "f 1 3 2 4\n"),
                StartsWith("E_POLYGON f.obj:5: a face of 4 corners that is far from"));
    EXPECT_EQ(obj_complaint(points + "g " + std::string(1U << 20U, 'x') + "\n"),
              "E_LIMIT f.obj:5: line is longer than 1 MiB; "
              "expected lines of at most 1048576 bytes");
}

TEST(ParseObj, RefusesInvalidCoordinates)
{
    EXPECT_EQ(obj_complaint("v 0 0 0\nv 0 nan 0\n"),
              "E_NONFINITE f.obj:2: coordinate NaN; expected a finite number");
    EXPECT_EQ(obj_complaint("v 0 inf 0\n"),
              "E_NONFINITE f.obj:1: coordinate infinity; expected a finite number");
    EXPECT_EQ(obj_complaint("v 0 0 1e39\n"),
              "E_RANGE f.obj:1: coordinate 1e+39; expected at most 1e+06 mm "
              "(--max-extent)");
}

TEST(ParseObj, RefusesWhatNeedsMoreMemoryThanTheLimit)
{
    std::string text;
    for (int i = 0; i < 10000; ++i)
        text += "v 0 0 0\n";
    EXPECT_THROW(parse_obj({text, "f", {.max_memory_gib = 2e-4}}), LimitError);
    EXPECT_NO_THROW(parse_obj({text, "f", {.max_memory_gib = 4e-4}}));
}

TEST(ObjText, CountsFromOne)
{
    const TriangleMesh mesh{{{0, 0, 0}, {0.1, 0, -0.0}, {0, 1e-7, 0}}, {{0, 1, 2}}};
    EXPECT_EQ(obj_text(mesh),
              "# mesh in mm, written by endmill\n"
              "v 0 0 0\nv 0.1 0 0\nv 0 1e-07 0\nf 1 2 3\n");
}

}  // namespace
}  // namespace endmill
