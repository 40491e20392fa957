// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/part_file.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"
#include "endmill/files/mesh_file.h"
#include "endmill/files/surface_file.h"
#include "endmill/mesh/mesh_checks.h"
#include "surface_json.h"
#include "temporary_folder.h"
#include "test_meshes.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string plane_text()
{
    return test::surface_json({"plate", "by hand", {test::plane(20, 10)}, {}});
}

TEST(PartFile, IsASurfaceIfItsContentIsOne)
{
    const TemporaryFolder folder;
    for (const char* name : {"plate.json", "plate.JSON", "plate.txt", "plate"}) {
        const PartFile file = read_part(folder.put(name, plane_text()));
        EXPECT_EQ(file.name, "plate");
        EXPECT_EQ(file.source, "by hand");
        EXPECT_EQ(std::get<std::vector<Surface>>(file.part).size(), 1U);
    }
}

TEST(PartFile, IsOtherwiseAMesh)
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
    for (const char* name : {"a.json", "a.JSON", "a.Json"})
        EXPECT_THAT(complaint_of([&] { read_part(folder.put(name, "hello")); }),
                    HasSubstr("content is not JSON"));
    EXPECT_THAT(complaint_of([&] { read_part(folder.put("a.stl", "v 0 0 0\n")); }),
                HasSubstr("content looks like OBJ; expected that of a .stl file"));
    EXPECT_THAT(complaint_of([&] { read_part(folder.put("a.xyz", "hello")); }),
                HasSubstr("unknown extension"));
}

TEST(PartFile, RefusesMeshOptionsForSurfaces)
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
    EXPECT_THAT(file.notes, ElementsAre("3 triangles were turned over, so that all face "
                                        "outwards"));
}

TriangleMesh inside_out(const TriangleMesh& mesh)
{
    return test::with_turned(mesh, [](std::size_t) { return true; });
}

PartFile read_off(const TriangleMesh& mesh)
{
    const TemporaryFolder folder;
    return read_part(folder.put("mesh.off", mesh_text(mesh, MeshFormat::Off)));
}

double volume(const PartFile& file)
{
    return mesh_report(std::get<TriangleMesh>(file.part)).volume.value();
}

TEST(PartFile, TurnsASmallBodyBesideALargeOneOutwards)
{
    const TriangleMesh large = test::box_mesh({0, 0, 0}, {10, 10, 10});
    const TriangleMesh small = test::box_mesh({20, 0, 0}, {21, 1, 1});
    const PartFile file = read_off(test::both(large, inside_out(small)));
    EXPECT_NEAR(volume(file), 1001, 1e-9);
    EXPECT_THAT(file.notes, ElementsAre("12 triangles were turned over, so that all face "
                                        "outwards"));
}

TEST(PartFile, TurnsASmallBodyThatTouchesALargeOneAlongAnEdgeOutwards)
{
    const TriangleMesh large = test::box_mesh({0, 0, 0}, {10, 10, 10});
    const TriangleMesh small = test::box_mesh({10, 10, 0}, {11, 11, 10});
    const PartFile file = read_off(test::both(large, inside_out(small)));
    EXPECT_NEAR(volume(file), 1010, 1e-9);
}

TEST(PartFile, LeavesACavityAndSoundBodiesAsTheyAreWithoutANote)
{
    const TriangleMesh body = test::box_mesh({0, 0, 0}, {10, 10, 10});
    const TriangleMesh cavity = inside_out(test::box_mesh({1, 1, 1}, {2, 3, 2}));
    const TriangleMesh other = test::box_mesh({20, 0, 0}, {21, 1, 1});
    const PartFile file = read_off(test::both(test::both(body, cavity), other));
    EXPECT_NEAR(volume(file), 1000 - 2 + 1, 1e-9);
    EXPECT_THAT(file.notes, ElementsAre());
}

TEST(PartFile, DoesNotReportAnOpenMeshAsOutwards)
{
    const TriangleMesh sheet =
        test::with_turned(test::flat_mesh(3, 3), [](std::size_t k) { return k == 4; });
    EXPECT_THAT(read_off(sheet).notes,
                ElementsAre("1 triangle was turned over, so that neighbours face the "
                            "same side and closed pieces outwards"));
}

TEST(PartFile, ReportsPiecesWithOneSideOnly)
{
    // A Moebius strip of five triangles: each point with the two points after it.
    std::vector<Vec3> points;
    std::vector<Triangle> strip;
    for (int k = 0; k < 5; ++k) {
        points.emplace_back(std::cos(k), std::sin(k), k % 2);
        strip.push_back({k, (k + 1) % 5, (k + 2) % 5});
    }
    const TriangleMesh moebius{points, strip};
    const std::string left = " left as read, of one side only, like a Moebius strip";
    const PartFile alone = read_off(moebius);
    EXPECT_THAT(alone.notes, ElementsAre("1 piece was" + left));
    EXPECT_EQ(test::triangles_of(std::get<TriangleMesh>(alone.part)), strip);
    const TriangleMesh box = inside_out(test::box_mesh({20, 0, 0}, {21, 1, 1}));
    EXPECT_THAT(
        read_off(test::both(moebius, box)).notes,
        ElementsAre(HasSubstr("12 triangles were turned over, so that neighbours"),
                    "1 piece was" + left));
}

}  // namespace
}  // namespace endmill
