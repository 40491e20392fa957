// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/mesh_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"
#include "endmill/mesh/mesh_checks.h"
#include "temporary_folder.h"
#include "test_meshes.h"

namespace endmill {
namespace {

using testing::ElementsAre;

const std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 2\nf 1 2 3\nf 1 3 4\n";

std::string mesh_file_complaint(const std::string& content, const std::string& path)
{
    return complaint_of([&] { parse_mesh(content, path); });
}

TEST(ReadMesh, ReadsEveryFormatByItsExtension)
{
    const TemporaryFolder folder;
    const TriangleMesh box = test::box_mesh({0, 0, 0}, {1, 2, 3});
    for (const MeshFormat format : {MeshFormat::Stl, MeshFormat::StlAscii,
                                    MeshFormat::Obj, MeshFormat::Ply, MeshFormat::Off}) {
        const auto path = folder.put("a box" + std::string{mesh_extension(format)},
                                     mesh_text(box, format));
        const MeshFile file = read_mesh(path);
        EXPECT_EQ(file.name, "a box");
        EXPECT_EQ(test::soup_of(file.mesh), test::soup_of(box));
        EXPECT_EQ(file.mesh.points().size(), 8U);
        EXPECT_EQ(file.degenerate_triangles.size(), 0U);
    }
    EXPECT_EQ(read_mesh(folder.put("BOX.OBJ", obj)).mesh.triangles().size(), 2U);
}

TEST(ReadMesh, ReportsFilesThatCannotBeRead)
{
    const TemporaryFolder folder;
    EXPECT_THAT(complaint_of([&] { read_mesh(folder.path() / "none.stl"); }),
                testing::AllOf(testing::StartsWith("E_OPEN"),
                               testing::HasSubstr("No such file")));
    EXPECT_THAT(complaint_of([&] { read_mesh(folder.put("a.stl", " \n")); }),
                testing::StartsWith("E_EMPTY"));
}

TEST(ReadMesh, RefusesUnknownExtensions)
{
    EXPECT_EQ(
        mesh_file_complaint(obj, "part.objs"),
        "E_FORMAT part.objs: unknown extension \".objs\", content looks like OBJ; "
        "expected \".stl\", \".obj\", \".ply\" or \".off\"; did you mean \".obj\"?");
    EXPECT_EQ(mesh_file_complaint("hello", "dir.stl/part"),
              "E_FORMAT dir.stl/part: no extension; "
              "expected \".stl\", \".obj\", \".ply\" or \".off\"");
}

TEST(ReadMesh, RefusesContentThatContradictsTheExtension)
{
    EXPECT_EQ(mesh_file_complaint(obj, "part.stl"),
              "E_FORMAT part.stl: content looks like OBJ; expected that of a .stl file");
    const TriangleMesh box = test::box_mesh({0, 0, 0}, {1, 2, 3});
    EXPECT_EQ(mesh_file_complaint(mesh_text(box, MeshFormat::Stl), "a.ply"),
              "E_FORMAT a.ply: content looks like STL; expected that of a .ply file");
    EXPECT_EQ(mesh_file_complaint(mesh_text(box, MeshFormat::Ply), "a.OFF"),
              "E_FORMAT a.OFF: content looks like PLY; expected that of a .off file");
    EXPECT_EQ(mesh_file_complaint("{}", "a.obj"),
              "E_FORMAT a.obj: content looks like JSON; expected that of a .obj file");
    EXPECT_EQ(mesh_file_complaint("hello", "a.off"),
              "E_OFF_SYNTAX a.off:1: \"hello\"; expected \"OFF\"");
}

// Files without triangles, and files whose triangles are all degenerate.
TEST(ReadMesh, RefusesAMeshWithoutATriangle)
{
    EXPECT_EQ(mesh_file_complaint("v 0 0 0\nv 1 0 0\nv 3 0 0\nf 1 2 3\n", "a.obj"),
              "E_DEGENERATE a.obj: the only triangle has no area; "
              "expected triangles whose corners are not on one line");
    EXPECT_EQ(
        mesh_file_complaint("v 0 0 0\nv 1 0 0\nv 1 0 0\nf 1 2 3\nf 3 2 1\n", "a.obj"),
        "E_DEGENERATE a.obj: none of the 2 triangles has an area; "
        "expected triangles whose corners are not on one line");
    EXPECT_EQ(mesh_file_complaint("v 0 0 0\n", "a.obj"),
              "E_EMPTY a.obj: mesh has no triangles; expected at least one");
    EXPECT_EQ(mesh_file_complaint(std::string(84, '\0'), "a.stl"),
              "E_EMPTY a.stl: mesh has no triangles; expected at least one");
    EXPECT_EQ(mesh_file_complaint("solid\nendsolid\n", "a.stl"),
              "E_EMPTY a.stl: mesh has no triangles; expected at least one");
}

TEST(ReadMesh, WeldsAndLeavesOutWithNotes)
{
    EXPECT_THAT(parse_mesh(obj, "a.obj").notes, ElementsAre());
    const MeshFile file =
        parse_mesh("v 9 9 9\n" + replaced(obj, "f 1 2 3\nf 1 3 4\n",
                                          "v 1 1 0\nv 0 2 4\nf 2 3 4\nf 6 5 2\nf 2 3 6\n"
                                          "f 2 5 7\nf 3 4 6\n"),
                   "a.obj");
    EXPECT_THAT(file.notes,
                ElementsAre("1 point at the place of another was welded to it",
                            "2 triangles without an area were left out",
                            "2 points that no triangle uses were left out"));
    EXPECT_EQ(file.welded_points, 1U);
    EXPECT_EQ(file.degenerate_triangles.size(), 2U);
    EXPECT_THAT(file.mesh.points(),
                ElementsAre(Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 2}));
    EXPECT_THAT(file.mesh.triangles(),
                ElementsAre(Triangle{0, 1, 2}, Triangle{2, 3, 0}, Triangle{0, 1, 2}));

    const TriangleMesh box = test::box_mesh({0, 0, 0}, {1, 2, 3});
    EXPECT_THAT(parse_mesh(mesh_text(box, MeshFormat::Stl), "a.stl").notes,
                ElementsAre());
    EXPECT_THAT(
        parse_mesh("OFF 4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n", "a.off").notes,
        ElementsAre("1 face of more than 3 corners was split into triangles, "
                    "corners 0 mm out of plane at most"));
}

// A triangle is left out only if its corners are exactly collinear. Corners at 0.1 and at
// the next double are not.
TEST(ReadMesh, DropsNoTriangleThatHasTheLeastArea)
{
    const auto degenerate = [](const std::string& y) {
        return parse_mesh(
                   "v 0 0 0\nv 0.1 0.1 0\nv 0.3 " + y + " 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\n",
                   "a.obj")
            .degenerate_triangles.size();
    };
    EXPECT_EQ(degenerate("0.3"), 1U);
    EXPECT_EQ(degenerate("0.30000000000000004"), 0U);
}

TEST(ReadMesh, ConvertsInchesAndAddsANote)
{
    const MeshFile file = parse_mesh(obj, "a.obj", {.units = LengthUnit::Inch});
    EXPECT_EQ(file.mesh.points()[3], Vec3(0, 25.4, 50.8));
    EXPECT_THAT(file.notes, ElementsAre("lengths were converted from inch to mm"));
    EXPECT_THAT(
        complaint_of([] {
            parse_mesh(replaced(obj, "v 0 0 0", "v 0 0 50000"), "a.obj",
                       {.units = LengthUnit::Inch});
        }),
        "E_RANGE a.obj:1: coordinate 50000 (1270000 mm); expected at most 1e+06 mm "
        "(--max-extent)");
}

// A rotation keeps the sign of the volume; a reflection would change it.
TEST(ReadMesh, TurnsTheNamedAxisUprightWithoutMirroring)
{
    const TriangleMesh box = test::box_mesh({0, 0, 0}, {1, 2, 3});
    const std::string text = mesh_text(box, MeshFormat::Obj);
    const std::array<Vec3, 6> axes{Vec3{1, 0, 0},  Vec3{0, 1, 0},  Vec3{0, 0, 1},
                                   Vec3{-1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, -1}};
    for (int i = 0; i < 6; ++i) {
        const MeshFile file = parse_mesh(text, "a.obj", {.up = static_cast<UpAxis>(i)});
        EXPECT_EQ(mesh_report(file.mesh).volume, 6);
        for (std::size_t k = 0; k < 8; ++k) {
            const Vec3& before = box.points()[k];
            const Vec3& after = file.mesh.points()[k];
            EXPECT_EQ(after.z(), before.dot(axes[i]));
            EXPECT_EQ(after.squaredNorm(), before.squaredNorm());
        }
        const std::string name{up_axis_names[i]};
        if (name == "z")
            EXPECT_THAT(file.notes, ElementsAre());
        else
            EXPECT_THAT(file.notes, ElementsAre("the axis " + name +
                                                " of the file was turned to +z"));
    }
}

TEST(ReadMesh, RefusesWhatNeedsMoreMemoryThanTheLimit)
{
    const TriangleMesh torus = test::torus_mesh(40, 30);
    for (const MeshFormat format : {MeshFormat::Stl, MeshFormat::StlAscii,
                                    MeshFormat::Obj, MeshFormat::Ply, MeshFormat::Off}) {
        const std::string text = mesh_text(torus, format);
        const std::string path = "f" + std::string{mesh_extension(format)};
        const auto read_within = [&](double gib) {
            parse_mesh(text, path, {.limits = {.max_memory_gib = gib}});
        };
        EXPECT_NO_THROW(read_within(2e-3));
        EXPECT_THROW(read_within(1e-4), LimitError);
    }
}

TEST(ReadMesh, ShowsNoControlCharactersOfAName)
{
    EXPECT_EQ(parse_mesh(obj, "a\x1b[1mb.obj").name, "a[1mb");
}

}  // namespace
}  // namespace endmill
