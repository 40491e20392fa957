// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/io/part_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"
#include "endmill/io/mesh_text.h"
#include "endmill/io/surface_file.h"
#include "endmill/mesh/mesh_checks.h"
#include "temporary_folder.h"
#include "test_meshes.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

using testing::HasSubstr;

std::string plane_text()
{
    return surface_json({"plate", "by hand", {test::plane(20, 10)}, {}});
}

TEST(PartFile, IsASurfaceIfItsContentIsOne)
{
    const TemporaryFolder folder;
    for (const char* name : {"plate.json", "plate.txt", "plate"}) {
        const PartFile file = read_part(folder.put(name, plane_text()));
        EXPECT_EQ(file.name, "plate");
        EXPECT_EQ(file.source, "by hand");
        EXPECT_EQ(std::get<std::vector<Surface>>(file.part).size(), 1U);
    }
}

TEST(PartFile, IsElseAMesh)
{
    const TemporaryFolder folder;
    const TriangleMesh box = test::box_mesh({0, 0, 0}, {1, 2, 3});
    const PartFile file =
        read_part(folder.put("box.off", mesh_text(box, MeshFormat::Off)),
                  {.units = LengthUnit::Inch, .up = UpAxis::X});
    const auto& mesh = std::get<TriangleMesh>(file.part);
    EXPECT_EQ(mesh.triangles().size(), 12U);
    EXPECT_NEAR(mesh_report(mesh).volume.value(), 6 * 25.4 * 25.4 * 25.4, 1e-8);
}

TEST(PartFile, WhoseNameContradictsItsContentIsRefused)
{
    const TemporaryFolder folder;
    EXPECT_THAT(complaint_of([&] { read_part(folder.put("a.json", "v 0 0 0\n")); }),
                testing::AllOf(testing::StartsWith("E_FORMAT"),
                               HasSubstr("content looks like OBJ")));
    EXPECT_THAT(complaint_of([&] { read_part(folder.put("a.stl", "v 0 0 0\n")); }),
                HasSubstr("content looks like OBJ; expected that of a .stl file"));
    EXPECT_THAT(complaint_of([&] { read_part(folder.put("a.xyz", "hello")); }),
                HasSubstr("unknown extension"));
}

TEST(PartFile, SurfacesSpeakForTheirUnitThemselves)
{
    const TemporaryFolder folder;
    const auto path = folder.put("plate.json", plane_text());
    EXPECT_THROW(read_part(path, {.units = LengthUnit::Inch}), DomainError);
    EXPECT_THROW(read_part(path, {.up = UpAxis::Y}), DomainError);
}

TEST(PartFile, TurnsTrianglesThatFaceInwards)
{
    const TemporaryFolder folder;
    TriangleMesh box = test::box_mesh({0, 0, 0}, {1, 2, 3});
    std::vector<Triangle> triangles{box.triangles().begin(), box.triangles().end()};
    for (const std::size_t number : {1, 4, 5})
        std::swap(triangles[number][1], triangles[number][2]);
    const TriangleMesh mixed{{box.points().begin(), box.points().end()}, triangles};
    const PartFile file =
        read_part(folder.put("box.obj", mesh_text(mixed, MeshFormat::Obj)));
    EXPECT_NEAR(mesh_report(std::get<TriangleMesh>(file.part)).volume.value(), 6, 1e-12);
    EXPECT_THAT(file.notes, testing::ElementsAre(HasSubstr("3 triangles were turned")));
}

}  // namespace
}  // namespace endmill
