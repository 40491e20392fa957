// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/surface_kinds.h"

#include <cmath>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/files/surface_file.h"

namespace endmill {
namespace {

using testing::HasSubstr;

const std::string start = R"({"format": "endmill-surface/1", "type": )";

// A quarter of a cylinder of radius 10 about the x axis, from x = 0 to 20.
const std::string quarter = start + R"("nurbs",
 "degree_u": 1, "degree_v": 2, "knots_u": [0, 0, 5, 5], "knots_v": [0, 0, 0, 1, 1, 1],
 "control_points": [[[0, 10, 0], [20, 10, 0]], [[0, 10, 10], [20, 10, 10]],
                    [[0, 0, 10], [20, 0, 10]]],
 "weights": [[1, 1], [0.70710678118654757, 0.70710678118654757], [1, 1]]})";

const std::string two_patches = start + R"("bezier-patches", "patches": [
 [[[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 2]]],
 [[[1, 0, 0], [2, 0, 1], [3, 0, 0]], [[1, 1, 2], [2, 1, 0], [3, 1, 0]]]]})";

const std::string grid = start + R"("height-grid", "units": "inch",
 "x": [0, 1, 2], "y": [0, 2], "z": [[0, 1, 4], [2, 3, 6]]})";

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

std::string surface_kinds_complaint(const std::string& text)
{
    try {
        parse_surface(text, "f.json");
    } catch (const FormatError& error) {
        return error.code() + " " + error.what();
    }
    return "accepted";
}

TEST(SurfaceKinds, NurbsIsTheCylinderOverItsKnotRange)
{
    const SurfaceFile file = parse_surface(quarter, "f");
    ASSERT_EQ(file.surfaces.size(), 1U);
    const Surface& surface = file.surfaces.front();
    EXPECT_EQ(surface.range(Parameter::U).high, 5);
    EXPECT_TRUE(file.notes.empty());
    for (double v = 0; v <= 1; v += 0.125) {
        const Vec3 point = surface.tangents(2.5, v).point;
        EXPECT_NEAR(point.x(), 10, 1e-14);
        EXPECT_NEAR(std::hypot(point.y(), point.z()), 10, 1e-14);
    }
}

TEST(SurfaceKinds, BezierPatchesAreSurfacesOfTheirOwnDegrees)
{
    const SurfaceFile file = parse_surface(two_patches, "f");
    ASSERT_EQ(file.surfaces.size(), 2U);
    EXPECT_EQ(file.surfaces[1].patch(0, 0).degree(Parameter::U), 2);
    EXPECT_EQ(file.surfaces[1].patch(0, 0).degree(Parameter::V), 1);
    EXPECT_EQ(file.surfaces[0].tangents(0.5, 0.5).point, Vec3(0.5, 0.5, 0.5));
}

TEST(SurfaceKinds, HeightGridTakesItsHeightsInMm)
{
    const SurfaceFile file = parse_surface(grid, "f");
    const Surface& surface = file.surfaces.front();
    EXPECT_THAT(file.notes, testing::ElementsAre(HasSubstr("from inch to mm")));
    for (const double x : {0.0, 1.0, 2.0, 1.5})
        for (const double y : {0.0, 2.0}) {
            const Vec3 point = surface.tangents(25.4 * x, 25.4 * y).point;
            EXPECT_NEAR(point.x(), 25.4 * x, 1e-12);
            EXPECT_NEAR(point.z(), 25.4 * (x * x + y), 1e-12);
        }
}

TEST(SurfaceKinds, RefuseUnsoundKnotsDegreesAndWeights)
{
    const auto with = [](const std::string& from, const std::string& to) {
        return surface_kinds_complaint(replaced(quarter, from, to));
    };
    EXPECT_EQ(with("\"degree_u\": 1", "\"degree_u\": 0"),
              "E_SURFACE f.json:/degree_u: degree 0; expected 1 to 25");
    EXPECT_EQ(with("\"degree_u\": 1", "\"degree_u\": 26"),
              "E_SURFACE f.json:/degree_u: degree 26; expected 1 to 25");
    EXPECT_EQ(with("[0, 0, 5, 5]", "[0, 0, 5, 4]"),
              "E_SURFACE f.json:/knots_u/3: 4 after 5; expected knots that do not fall");
    EXPECT_EQ(with("[0, 0, 0, 1, 1, 1]", "[0, 0, 0, 0, 1, 1]"),
              "E_SURFACE f.json:/knots_v: a knot is repeated more than degree + 1 times; "
              "expected a knot vector of degree 2");
    EXPECT_EQ(with("[0, 0, 5, 5]", "[0, 0, 5]"),
              "E_SURFACE f.json:/knots_u: there are fewer than degree + 1 control "
              "points; expected a knot vector of degree 1");
    EXPECT_EQ(with("[0, 0, 5, 5]", "[0, 0, 2, 5, 5]"),
              "E_SURFACE f.json:/control_points/0: row has 2 points; expected 3 (knots_u "
              "- degree_u - 1)");
    EXPECT_EQ(with("[0, 0, 0, 1, 1, 1]", "[0, 0, 0, 0.5, 1, 1, 1]"),
              "E_SURFACE f.json:/control_points: net has 3 rows; expected 4 (knots_v - "
              "degree_v - 1)");
    EXPECT_EQ(with("[[1, 1], [", "[[1, 0], ["),
              "E_SURFACE f.json:/weights/0/1: weight 0; expected a number above zero");
    EXPECT_EQ(with("[[1, 1], [", "[[1, -2.5], ["),
              "E_SURFACE f.json:/weights/0/1: weight -2.5; expected a number above zero");
    EXPECT_EQ(with("[[1, 1], [", "[[1, 1e5], ["),
              "E_SURFACE f.json:/weights: weights from 0.7071067811865476 to 1e+05; "
              "expected weights that differ by a factor of at most 10000");
    EXPECT_EQ(with("[[1, 1], [", "[[1], ["),
              "E_SURFACE f.json:/weights/0: row has 1 number; expected 2 (knots_u - "
              "degree_u - 1)");
    EXPECT_THAT(with("\"degree_u\": 1, ", ""), HasSubstr("\"degree_u\" is missing"));
    EXPECT_THAT(with("\"weights\"", "\"wieghts\""), HasSubstr("mean \"weights\"?"));
}

TEST(SurfaceKinds, RefuseInvalidNets)
{
    const auto with = [](const std::string& from, const std::string& to) {
        return surface_kinds_complaint(replaced(two_patches, from, to));
    };
    EXPECT_EQ(with("[[0, 1, 0], [1, 1, 2]]", "[[0, 1, 0]]"),
              "E_SURFACE f.json:/patches/0/1: row has 1 point; expected 2 (as in row 0)");
    EXPECT_EQ(with(", [[0, 1, 0], [1, 1, 2]]", ""),
              "E_SURFACE f.json:/patches/0: net has 1 row, degree 0; expected degree 1 "
              "to 25");
    EXPECT_EQ(surface_kinds_complaint(start + R"("bezier-patches", "patches": []})"),
              "E_SURFACE f.json:/patches: no patches; expected at least one");
    std::string row = "[0, 0, 0]";
    for (int k = 1; k <= 26; ++k)
        row += ", [" + std::to_string(k) + ", 0, 0]";
    EXPECT_EQ(with("[[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 2]]",
                   "[" + row + "], [" + row + "]"),
              "E_SURFACE f.json:/patches/0: net has 27 columns, degree 26; expected "
              "degree 1 to 25");
    EXPECT_EQ(with("[[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 2]]",
                   "[[0, 0, 0], [0, 0, 0]], [[0, 0, 0], [0, 0, 0]]"),
              "E_SURFACE f.json:/patches/0: all control points are equal; expected a "
              "surface");
}

TEST(SurfaceKinds, RefuseInvalidGrids)
{
    const auto with = [](const std::string& from, const std::string& to) {
        return surface_kinds_complaint(replaced(grid, from, to));
    };
    EXPECT_EQ(with("[0, 1, 2]", "[0, 2, 2]"),
              "E_SURFACE f.json:/x/2: 2 after 2; expected grid lines that rise, each by "
              "more than 1e-9 of the range");
    EXPECT_EQ(with("\"y\": [0, 2]", "\"y\": [0]"),
              "E_SURFACE f.json:/y: 1 grid line; expected at least 2");
    EXPECT_EQ(with("[0, 1, 4]", "[0, 1]"),
              "E_SURFACE f.json:/z/0: row has 2 numbers; expected 3 (length of x)");
    EXPECT_EQ(with(", [2, 3, 6]", ""),
              "E_SURFACE f.json:/z: array has 1 row; expected 2 (length of y)");
    EXPECT_THAT(with("[2, 3, 6]", "[2, 3, 1e9]"),
                testing::StartsWith("E_RANGE f.json:/z/1/2: coordinate 1000000000"));
}

TEST(SurfaceKinds, PatchOfAPoleIsNamed)
{
    EXPECT_THAT(parse_surface(replaced(two_patches, "[[0, 1, 0], [1, 1, 2]]",
                                       "[[0, 1, 0], [0, 1, 0]]"),
                              "f")
                    .notes,
                testing::ElementsAre("pole: the border v = 1 of patch 0 is a single "
                                     "point, without a normal"));
}

TEST(SurfaceKinds, CornerWithoutANormalIsNamed)
{
    // at the corner (1, 0) both partials go along x
    EXPECT_THAT(parse_surface(start + R"("bezier-patches", "patches": [
 [[[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [2, 0, 0]]]]})",
                              "f")
                    .notes,
                testing::ElementsAre("pole: the corner u = 1, v = 0 has no normal"));
}

TEST(SurfaceKinds, MemoryOfTheirPatchesIsCountedBeforeItIsTaken)
{
    std::string knots = "0";
    for (int k = 1; k <= 25; ++k)
        knots += ", 0";
    for (int k = 1; k <= 300; ++k)
        knots += ", " + std::to_string(k);
    std::string row = "[";
    for (int k = 0; k < 300; ++k)
        row += std::string{k == 0 ? "" : ", "} + "[" + std::to_string(k) + ", 0, 0]";
    row += "]";
    std::string net = "[" + row;
    for (int k = 1; k < 300; ++k)
        net += ", " + row;
    EXPECT_THROW(
        parse_surface(start + R"("nurbs", "degree_u": 25, "degree_v": 25, "knots_u": [)" +
                          knots + R"(], "knots_v": [)" + knots +
                          R"(], "control_points": )" + net + "]}",
                      "f", {.max_memory_gib = 1}),
        LimitError);
}

TEST(SurfaceKinds, ReadOrRefuseEveryMutatedFile)
{
    std::mt19937 random{20};
    const std::string bytes = "{}[]\",:0123456789eE.-+ \\u\n\xff\x80tfn";
    for (const std::string& sound : {quarter, two_patches, grid})
        for (int trial = 0; trial < 1000; ++trial) {
            std::string text = sound;
            for (int edits = 1 + static_cast<int>(random() % 3); edits > 0; --edits)
                text[random() % text.size()] = bytes[random() % bytes.size()];
            if (trial % 10 == 0)
                text.resize(random() % text.size());
            try {
                for (const Surface& surface : parse_surface(text, "f").surfaces)
                    EXPECT_TRUE(std::isfinite(surface.diagonal()));
            } catch (const FormatError& error) {
                EXPECT_FALSE(error.code().empty());
            }
        }
}

}  // namespace
}  // namespace endmill
