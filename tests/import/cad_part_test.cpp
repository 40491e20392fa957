// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/import/cad_part.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cad_answers.h"
#include "endmill/core/error.h"
#include "endmill/import/cad_stream.h"
#include "test_meshes.h"

namespace endmill {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;

CadPart square()
{
    return parse_cad_stream(test::square_answer(), "square.step");
}

// The first face of the square alone.
CadPart sheet()
{
    CadPart part = square();
    part.faces.resize(1);
    part.triangle_faces.assign(2, 0);
    return part;
}

TEST(ToolSide, IsOutsideASolidAndAboveASheet)
{
    CadPart part = square();
    EXPECT_EQ(tool_side(part, part.faces[1]), ToolSide::Up);
    part.solids = 1;
    EXPECT_EQ(tool_side(part, part.faces[0]), ToolSide::DuCrossDv);
    EXPECT_EQ(tool_side(part, part.faces[1]), ToolSide::DvCrossDu);
}

TEST(RequireFaces, CountsFromOne)
{
    const auto complaint = [](int number) {
        try {
            require_faces(std::array{1, number}, 3, "part.step");
        } catch (const DomainError& error) {
            return std::string{error.what()};
        }
        return std::string{};
    };
    EXPECT_EQ(complaint(3), "");
    EXPECT_THAT(complaint(0),
                HasSubstr("--face 0: part.step has 3 faces; expected 1 to 3"));
    EXPECT_THAT(complaint(4), HasSubstr("--face 4"));
}

TEST(MeshOfFaces, NumbersFacesFromOne)
{
    const MeshFile mesh = mesh_of_faces(square(), {}, "square.step");
    EXPECT_EQ(mesh.name, "square");
    EXPECT_THAT(mesh.face_numbers, ElementsAre(1, 2));
}

TEST(MeshOfFaces, HasTheChosenFacesOnly)
{
    const MeshFile mesh = mesh_of_faces(square(), std::array{2}, "square.step");
    EXPECT_THAT(mesh.face_numbers, ElementsAre(2));
    EXPECT_EQ(mesh.mesh.points().size(), 3U);
    EXPECT_THAT(mesh.notes, ElementsAre());
    EXPECT_THROW(mesh_of_faces(square(), std::array{3}, "square.step"), DomainError);
}

TEST(CentreOfMass, IsThatOfABoxAndOfItsHalfOpenSheet)
{
    const TriangleMesh box{{{1, 1, 1},
                            {3, 1, 1},
                            {3, 5, 1},
                            {1, 5, 1},
                            {1, 1, 7},
                            {3, 1, 7},
                            {3, 5, 7},
                            {1, 5, 7}},
                           {{0, 2, 1},
                            {0, 3, 2},
                            {4, 5, 6},
                            {4, 6, 7},
                            {0, 1, 5},
                            {0, 5, 4},
                            {1, 2, 6},
                            {1, 6, 5},
                            {2, 3, 7},
                            {2, 7, 6},
                            {3, 0, 4},
                            {3, 4, 7}}};
    EXPECT_LT((centre_of_mass(box, true) - Vec3(2, 3, 4)).norm(), 1e-14);
    EXPECT_LT((centre_of_mass(box, false) - Vec3(2, 3, 4)).norm(), 1e-14);
    const TriangleMesh triangle{{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}}, {{0, 1, 2}}};
    EXPECT_LT((centre_of_mass(triangle, false) - Vec3(1, 1, 0)).norm(), 1e-14);
}

TEST(PartOfCad, IsAMeshWithFaceNumbers)
{
    const PartFile file = part_of_cad(square(), "square.step");
    EXPECT_EQ(std::get<TriangleMesh>(file.part).triangles().size(), 2U);
    EXPECT_THAT(file.face_numbers, ElementsAre(1, 2));
    EXPECT_TRUE(file.mesh_report);
}

TEST(PartOfCad, IsTheSurfaceOfASingleFaceThatIsASheet)
{
    const PartFile file = part_of_cad(sheet(), "square.step");
    EXPECT_EQ(file.name, "square");
    const auto& surfaces = std::get<std::vector<Surface>>(file.part);
    ASSERT_EQ(surfaces.size(), 1U);
    EXPECT_EQ(surfaces.front().tangents(1, 1).point, Vec3(2, 2, 0));
    CadPart closed = sheet();
    closed.solids = 1;
    EXPECT_TRUE(std::holds_alternative<TriangleMesh>(part_of_cad(closed, "a.step").part));
}

TEST(PartOfCad, TurnsTheUpwardAxisOfAMesh)
{
    const PartFile file = part_of_cad(sheet(), "square.step", {.up = UpAxis::X});
    const auto& mesh = std::get<TriangleMesh>(file.part);
    for (const Vec3& point : mesh.points())
        EXPECT_EQ(point.x(), 0);
}

TEST(PartOfCad, PassesOnTheNotes)
{
    CadPart part = square();
    part.notes.emplace_back("a note");
    EXPECT_EQ(part_of_cad(part, "square.step").notes.front(), "a note");
}

}  // namespace
}  // namespace endmill
