// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/off.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"

namespace endmill {
namespace {

using testing::ElementsAre;

const std::string sample =
    "OFF\n"
    "4 2 5\n"
    "0 0 0\n"
    "1 0 0\n"
    "1 1 0\n"
    "0 1 0.5\n"
    "3 0 1 2\n"
    "3 0 2 3\n";

RawMesh read(const std::string& text)
{
    return parse_off({text, "f.off"});
}

std::vector<Triangle> triangles_of(const std::string& text)
{
    const RawMesh raw = read(text);
    return {raw.mesh.triangles().begin(), raw.mesh.triangles().end()};
}

std::string off_complaint(const std::string& text)
{
    return complaint_of([&] { read(text); });
}

std::string complaint_with(const std::string& from, const std::string& to)
{
    return off_complaint(replaced(sample, from, to));
}

TEST(ParseOff, ReadsPointsAndFaces)
{
    const RawMesh raw = read(sample);
    EXPECT_THAT(raw.mesh.points(), ElementsAre(Vec3{0, 0, 0}, Vec3{1, 0, 0},
                                               Vec3{1, 1, 0}, Vec3{0, 1, 0.5}));
    EXPECT_THAT(raw.mesh.triangles(), ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
    const RawMesh square =
        read(replaced(replaced(replaced(sample, "3 0 1 2\n", ""), "4 2 5", "4 1 4"),
                      "3 0 2 3", "4 0 1 2 3"));
    EXPECT_EQ(square.split_faces, 1U);
    EXPECT_EQ(square.mesh.triangles().size(), 2U);
}

TEST(ParseOff, TakesCommentsBlankLinesAndColours)
{
    const std::vector<Triangle> plain = triangles_of(sample);
    EXPECT_EQ(
        triangles_of("\n# made by hand\n" + replaced(sample, "OFF\n", "OFF # x\n\n")),
        plain);
    EXPECT_EQ(triangles_of(replaced(sample, "OFF\n4 2 5", "OFF 4 2 0 # x")), plain);
    EXPECT_EQ(triangles_of(replaced(sample, "0 1 2\n", "0 1 2 255 0.5 0 1\r\n\t\n")),
              plain);
    EXPECT_EQ(triangles_of(sample.substr(0, sample.size() - 1)), plain);
}

TEST(ParseOff, IgnoresWhatThePrefixesAddToPoints)
{
    for (const std::string keyword : {"COFF", "NOFF", "CNOFF", "STOFF", "STCNOFF"})
        EXPECT_EQ(triangles_of(replaced(replaced(sample, "OFF", keyword), "1 1 0\n",
                                        "1 1 0 0.5 0.5 0.5 1\n")),
                  triangles_of(sample));
    EXPECT_EQ(complaint_with("1 1 0\n", "1 1 0 0.5\n"),
              "E_OFF_SYNTAX f.off:5: \"0.5\"; expected the end of the line");
}

TEST(ParseOff, RefusesOtherKindsOfOff)
{
    EXPECT_EQ(complaint_with("OFF", "4OFF"),
              "E_OFF_SYNTAX f.off:1: \"4OFF\"; expected OFF, with points of three "
              "coordinates");
    EXPECT_EQ(complaint_with("OFF", "CnOFF"),
              "E_OFF_SYNTAX f.off:1: \"CnOFF\"; expected OFF, with points of three "
              "coordinates");
    EXPECT_EQ(complaint_with("OFF", "OFF BINARY"),
              "E_OFF_SYNTAX f.off:1: binary OFF; expected OFF in ASCII");
    EXPECT_EQ(complaint_with("OFF\n", ""),
              "E_OFF_SYNTAX f.off:1: \"4\"; expected \"OFF\"");
    EXPECT_EQ(off_complaint("OFF\n"),
              "E_OFF_SYNTAX f.off:1: end of file; expected the numbers of points, faces "
              "and edges");
    EXPECT_EQ(complaint_with("4 2 5", "4 2"),
              "E_OFF_SYNTAX f.off:2: end of line; expected a whole number");
    EXPECT_EQ(complaint_with("4 2 5", "4.0 2 5"),
              "E_OFF_SYNTAX f.off:2: \"4.0\"; expected a whole number");
}

TEST(ParseOff, RefusesCountsThatTheFileCannotHold)
{
    EXPECT_EQ(complaint_with("4 2 5", "4000000000 2 5"),
              "E_COUNT f.off:2: header claims 4000000000 points, file of 61 bytes can "
              "hold at most 7");
    EXPECT_EQ(
        complaint_with("4 2 5", "4 9223372036854775807 5"),
        "E_COUNT f.off:2: header claims 9223372036854775807 faces, file of 70 bytes "
        "can hold at most 2");
    EXPECT_EQ(complaint_with("4 2 5", "-4 2 5"),
              "E_COUNT f.off:2: header claims -4 points; expected 0 or more");
    EXPECT_EQ(complaint_with("4 2 5", "4 -2 5"),
              "E_COUNT f.off:2: header claims -2 faces; expected 0 or more");
    EXPECT_EQ(complaint_with("4 2 5", "4 2 -5"),
              "E_COUNT f.off:2: header claims -5 edges; expected 0 or more");
    EXPECT_EQ(complaint_with("4 2 5", "4 1 5"),
              "E_COUNT f.off:8: header claims 1 faces, file goes on after them");
    EXPECT_EQ(complaint_with("3 0 2 3\n", "         # cut\n"),
              "E_COUNT f.off:8: header claims 2 faces, file ends after 1");
    EXPECT_EQ(complaint_with("5\n0 0 0\n1 0 0\n1 1 0\n0 1 0.5\n3 0 1 2\n3 0 2 3\n",
                             "5\n1 0 0\n" + std::string(40, '\n')),
              "E_COUNT f.off:43: header claims 4 points, file ends after 1");
}

TEST(ParseOff, RefusesIndicesOfNoPoint)
{
    EXPECT_EQ(complaint_with("3 0 2 3", "3 0 2 4"),
              "E_INDEX f.off:8: index 4; expected 0 to 3");
    EXPECT_EQ(complaint_with("3 0 2 3", "3 0 2 -1"),
              "E_INDEX f.off:8: index -1; expected 0 to 3");
}

TEST(ParseOff, RefusesInvalidFaces)
{
    EXPECT_EQ(complaint_with("3 0 2 3", "2 0 2"),
              "E_DEGENERATE f.off:8: a face of 2 corners; expected at least 3");
    EXPECT_EQ(complaint_with("3 0 2 3", "3 0 2 2"),
              "E_DEGENERATE f.off:8: a face names a point twice; "
              "expected different corners");
    EXPECT_EQ(complaint_with("3 0 2 3", "-3 0 2 3"),
              "E_COUNT f.off:8: a face of -3 corners; expected at least 3");
    EXPECT_EQ(complaint_with("3 0 2 3", "4 0 2 3"),
              "E_OFF_SYNTAX f.off:8: end of line; expected a whole number");
    EXPECT_EQ(complaint_with("3 0 2 3", "4000000000 0 2 3"),
              "E_OFF_SYNTAX f.off:8: end of line; expected a whole number");
    EXPECT_EQ(complaint_with("3 0 2 3", "3 0 2 3 1 2 3 4 5"),
              "E_OFF_SYNTAX f.off:8: \"5\"; expected the end of the line");
}

TEST(ParseOff, RefusesInvalidCoordinates)
{
    EXPECT_EQ(complaint_with("0.5", "NaN"),
              "E_NONFINITE f.off:6: coordinate NaN; expected a finite number");
    EXPECT_EQ(complaint_with("0.5", "-inf"),
              "E_NONFINITE f.off:6: coordinate -infinity; expected a finite number");
    EXPECT_EQ(complaint_with("0.5", "1e39"),
              "E_RANGE f.off:6: coordinate 1e+39; expected at most 1e+06 mm "
              "(--max-extent)");
}

TEST(OffText, HasTheCountsWithoutEdges)
{
    const TriangleMesh mesh{{{0, 0, 0}, {0.1, 0, 0}, {0, 1e-7, 0}}, {{0, 1, 2}}};
    EXPECT_EQ(off_text(mesh),
              "OFF\n# mesh in mm, written by endmill\n"
              "3 1 0\n0 0 0\n0.1 0 0\n0 1e-07 0\n3 0 1 2\n");
}

}  // namespace
}  // namespace endmill
