// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/import/cad_stream.h"

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cad_answers.h"
#include "endmill/core/error.h"

namespace endmill {
namespace {

using test::cad_answer;
using test::square_answer;
using test::square_head;
using test::SquareArrays;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

CadPart read(const std::string& bytes, const ReadLimits& limits = {})
{
    return parse_cad_stream(bytes, "part.step", limits);
}

// Code and message of the error that an answer causes; empty without one.
std::string complaint(const std::string& bytes, const ReadLimits& limits = {})
{
    try {
        read(bytes, limits);
    } catch (const Error& error) {
        return error.code() + ' ' + error.what();
    }
    return {};
}

// The square with a text of its head replaced.
std::string with_head(const std::string& text, const std::string& other)
{
    std::string head = square_head;
    head.replace(head.find(text), text.size(), other);
    return cad_answer(head, SquareArrays{}.bytes());
}

// The square with other numbers.
std::string with_arrays(const std::function<void(SquareArrays&)>& change)
{
    SquareArrays arrays;
    change(arrays);
    return cad_answer(square_head, arrays.bytes());
}

TEST(CadStream, HasMeshFacesAndSurfaces)
{
    const CadPart part = read(square_answer());
    EXPECT_EQ(part.unit, "INCH");
    EXPECT_EQ(part.shells, 1U);
    ASSERT_TRUE(part.measures);
    EXPECT_EQ(part.measures->volume_mm3, std::nullopt);
    EXPECT_EQ(part.measures->centre_mm, Vec3(1, 1, 0));
    EXPECT_THAT(part.measures->face_areas_mm2, ElementsAre(2, 2));
    EXPECT_FALSE(part.measures->trimmed_balls[0]);
    ASSERT_TRUE(part.measures->trimmed_balls[1]);
    EXPECT_EQ(part.measures->trimmed_balls[1]->outside, std::nullopt);
    EXPECT_EQ(part.measures->trimmed_balls[1]->inside, 7.5);
    EXPECT_EQ(part.mesh.points()[2], Vec3(2, 2, 0));
    EXPECT_EQ(part.mesh.triangles()[1], (Triangle{0, 2, 3}));
    EXPECT_THAT(part.triangle_faces, ElementsAre(0, 1));
    ASSERT_EQ(part.faces.size(), 2U);
    EXPECT_EQ(part.faces[0].name, "floor");
    EXPECT_EQ(part.faces[0].colour, "#ff8000");
    EXPECT_TRUE(part.faces[1].is_trimmed);
    EXPECT_FALSE(part.faces[1].surface);
    ASSERT_TRUE(part.faces[0].surface);
    EXPECT_EQ(nurbs_surface(*part.faces[0].surface).tangents(0.25, 0.5).point,
              Vec3(0.5, 1, 0));
    EXPECT_THAT(part.notes, IsEmpty());
}

TEST(CadStream, NotesThatTheFileNamesNoUnit)
{
    EXPECT_THAT(read(with_head("INCH", "")).notes,
                ElementsAre(HasSubstr("names no unit of length")));
}

TEST(CadStream, NotesFacesThatAreMissing)
{
    EXPECT_THAT(read(with_head("\"lost_faces\": 0", "\"lost_faces\": 2")).notes,
                ElementsAre("2 faces of the file cannot be read and are missing"));
}

TEST(CadStream, NotesFacesWithoutTriangles)
{
    EXPECT_THAT(read(with_head("\"unmeshed\": []", "\"unmeshed\": [1]")).notes,
                ElementsAre("1 face could not be meshed, the first is face 2"));
}

TEST(CadStream, RefusesEveryTruncation)
{
    const std::string whole = square_answer();
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_THAT(complaint(whole.substr(0, size)), StartsWith("E_CAD part.step: "))
            << size;
    EXPECT_THAT(complaint(whole + ' '), HasSubstr("goes on after its end"));
}

TEST(CadStream, RefusesCountsThatTheAnswerCannotHold)
{
    for (const char* count : {"5", "2147483647", "-1", "4.5", "99999999999999999999"})
        EXPECT_THAT(
            complaint(with_head("\"points\": 4", "\"points\": " + std::string{count})),
            StartsWith("E_CAD part.step: endmill-cad gave a damaged answer"))
            << count;
    EXPECT_THAT(complaint(with_head("\"points_u\": 2", "\"points_u\": 2147483647")),
                HasSubstr("ends early"));
}

TEST(CadStream, RefusesIndicesOutOfRange)
{
    EXPECT_THAT(complaint(with_arrays([](auto& arrays) { arrays.corners[4] = 4; })),
                HasSubstr("there is no point 4"));
    EXPECT_THAT(complaint(with_arrays([](auto& arrays) { arrays.corners[0] = -1; })),
                HasSubstr("there is no point -1"));
    EXPECT_THAT(complaint(with_arrays([](auto& arrays) { arrays.faces[1] = 2; })),
                HasSubstr("there is no face 2"));
    EXPECT_THAT(complaint(with_head("\"unmeshed\": []", "\"unmeshed\": [2]")),
                StartsWith("E_CAD"));
}

TEST(CadStream, RefusesCoordinatesThatAreNotFiniteOrTooLarge)
{
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        EXPECT_THAT(complaint(with_arrays([&](auto& arrays) { arrays.points[7] = bad; })),
                    HasSubstr("not finite"));
        EXPECT_THAT(
            complaint(with_arrays([&](auto& arrays) { arrays.control_points[7] = bad; })),
            HasSubstr("not finite"));
    }
    const std::string large = with_arrays([](auto& arrays) { arrays.points[0] = 2e6; });
    EXPECT_THAT(complaint(large), StartsWith("E_RANGE part.step: "));
    EXPECT_EQ(complaint(large, {.max_extent_mm = 1e7}), "");
}

TEST(CadStream, LeavesOutASurfaceThatIsNone)
{
    const auto notes_of = [](const std::function<void(SquareArrays&)>& change) {
        const CadPart part = read(with_arrays(change));
        EXPECT_FALSE(part.faces[0].surface);
        return part.notes;
    };
    constexpr const char* begin = "the surface of face 1 is left out: ";
    EXPECT_THAT(notes_of([](auto& arrays) { arrays.knots[1] = 2; }),
                ElementsAre(StartsWith(begin)));
    EXPECT_THAT(notes_of([](auto& arrays) { arrays.knots[3] = std::nan(""); }),
                ElementsAre(StartsWith(begin)));
    EXPECT_THAT(notes_of([](auto& arrays) { arrays.weights[3] = 0; }),
                ElementsAre(HasSubstr("weight")));
    EXPECT_THAT(notes_of([](auto& arrays) { arrays.control_points.assign(12, 1.0); }),
                ElementsAre(HasSubstr("equal")));
}

TEST(CadStream, RefusesOtherHeads)
{
    for (const auto& [text, other] : std::vector<std::pair<std::string, std::string>>{
             {"\"unit\": \"INCH\"", "\"unit\": 1"},
             {"\"sewn\": false", "\"sewn\": false, \"more\": 1"},
             {"\"area_mm2\": 4", "\"area_mm2\": 1e999"},
             {"[1, 1, 0]", "[1, 1]"},
             {"[2, 2]", "[2]"},
             {"\"nurbs\"", "\"nurb\""},
             {"#ff8000", "orange"},
             {"#ff8000", "#ff800g"},
             {"\"degree_u\": 1", "\"degree_u\": 0"},
             {"\"sewn\": false, ", ""}})
        EXPECT_THAT(complaint(with_head(text, other)), StartsWith("E_CAD part.step: "))
            << other;
    EXPECT_THAT(complaint("endmill-cad/2\n" + square_answer().substr(14)),
                HasSubstr("does not begin"));
    EXPECT_THAT(complaint(cad_answer("[]", "")), StartsWith("E_CAD"));
    EXPECT_THAT(complaint(cad_answer(std::string(100, '['), "")), StartsWith("E_CAD"));
}

TEST(CadStream, MakesLabelsPrintable)
{
    const CadPart part =
        read(with_head("floor", "a\\u001b[31m\\n" + std::string(500, 'b')));
    EXPECT_THAT(part.faces[0].name, StartsWith("a[31mb"));
    EXPECT_LT(part.faces[0].name.size(), 210U);
}

TEST(CadStream, KeepsToTheMemoryLimit)
{
    EXPECT_THAT(complaint(square_answer(), {.max_memory_gib = 1e-9}),
                StartsWith("E_LIMIT"));
}

TEST(CadStream, SurvivesChangedBytes)
{
    std::mt19937 random{7};  // NOLINT(cert-msc51-cpp): the same changes every time
    const std::string whole = square_answer();
    const auto below = [&](std::size_t end) { return random() % end; };
    int refused = 0;
    for (int round = 0; round < 3000; ++round) {
        std::string changed = whole;
        for (std::size_t k = 0; k <= below(4); ++k)
            changed[below(changed.size())] = static_cast<char>(below(256));
        refused += complaint(changed).empty() ? 0 : 1;
    }
    EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace endmill
