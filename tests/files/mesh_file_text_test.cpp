// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/mesh_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "random.h"
#include "test_meshes.h"

namespace endmill {
namespace {

using test::points_of;
using test::soup_of;
using test::triangles_of;

TriangleMesh read_back(const TriangleMesh& mesh, MeshFormat format)
{
    return parse_mesh(mesh_text(mesh, format), "f" + std::string{mesh_extension(format)},
                      {.limits = {.max_extent_mm = 1e300}})
        .mesh;
}

// Coordinates of all magnitudes with all digits of a double.
TriangleMesh uneven_mesh()
{
    test::Random random{11};
    return test::grid_mesh(20, 15, [&](int i, int j) {
        return Vec3{i + random.uniform(-0.3, 0.3), j + random.uniform(-0.3, 0.3),
                    random.uniform(-1, 1) * random.log_uniform(1e-12, 1e5)};
    });
}

TriangleMesh rounded_to_float(const TriangleMesh& mesh)
{
    std::vector<Vec3> points;
    for (const Vec3& point : mesh.points())
        points.push_back(point.cast<float>().cast<double>());
    return {std::move(points), triangles_of(mesh)};
}

TEST(MeshText, KeepsNumbersWherePointsAreNumbered)
{
    for (const TriangleMesh& mesh :
         {uneven_mesh(), test::torus_mesh(12, 7), test::box_mesh({0, 0, 0}, {1, 2, 3})})
        for (const MeshFormat format :
             {MeshFormat::Obj, MeshFormat::Ply, MeshFormat::Off}) {
            const TriangleMesh back = read_back(mesh, format);
            EXPECT_EQ(points_of(back), points_of(mesh));
            EXPECT_EQ(triangles_of(back), triangles_of(mesh));
        }
}

TEST(MeshText, KeepsTrianglesWithoutPointNumbers)
{
    const TriangleMesh mesh = uneven_mesh();
    const TriangleMesh ascii = read_back(mesh, MeshFormat::StlAscii);
    EXPECT_EQ(soup_of(ascii), soup_of(mesh));
    EXPECT_EQ(ascii.points().size(), mesh.points().size());
    const TriangleMesh binary = read_back(mesh, MeshFormat::Stl);
    EXPECT_EQ(soup_of(binary), soup_of(rounded_to_float(mesh)));
    for (std::size_t i = 0; i < mesh.triangles().size(); ++i)
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3 exact = mesh.corners(i)[corner];
            const Vec3 error = binary.corners(i)[corner] - exact;
            for (int c = 0; c < 3; ++c)
                EXPECT_LE(std::abs(error[c]), std::ldexp(std::abs(exact[c]), -24));
        }
}

// A mesh that was read from STL is written and read without a change in every format.
TEST(MeshText, KeepsAMeshThatWasReadFromStl)
{
    const TriangleMesh mesh = read_back(uneven_mesh(), MeshFormat::Stl);
    for (const MeshFormat format : {MeshFormat::Stl, MeshFormat::StlAscii,
                                    MeshFormat::Obj, MeshFormat::Ply, MeshFormat::Off}) {
        const TriangleMesh back = read_back(mesh, format);
        EXPECT_EQ(points_of(back), points_of(mesh));
        EXPECT_EQ(triangles_of(back), triangles_of(mesh));
    }
}

TEST(MeshText, HoldsTheSmallestAndLargestDoubles)
{
    const TriangleMesh mesh{{{0, 0, 0}, {5e-324, 1, 0}, {0, 1e-5, 1e300}}, {{0, 1, 2}}};
    for (const MeshFormat format :
         {MeshFormat::StlAscii, MeshFormat::Obj, MeshFormat::Ply, MeshFormat::Off})
        EXPECT_EQ(points_of(read_back(mesh, format)), points_of(mesh));
}

// The header of PLY declares normals; the other formats are the same with and without.
TEST(MeshText, StoresNormalsInPlyOnly)
{
    const TriangleMesh mesh = test::box_mesh({0, 0, 0}, {1, 2, 3});
    const std::vector<Vec3> normals(mesh.points().size(), Vec3::UnitZ());
    for (const MeshFormat format :
         {MeshFormat::Stl, MeshFormat::StlAscii, MeshFormat::Obj, MeshFormat::Off})
        EXPECT_EQ(mesh_text(mesh, format, normals), mesh_text(mesh, format));
    const std::string ply = mesh_text(mesh, MeshFormat::Ply, normals);
    EXPECT_NE(ply.find("property double nz"), std::string::npos);
    EXPECT_EQ(points_of(parse_mesh(ply, "f.ply").mesh), points_of(mesh));
}

TEST(MeshFormat, HasAnExtensionThatBeginsItsName)
{
    const std::array<std::string_view, 5> extensions{".stl", ".stl", ".obj", ".ply",
                                                     ".off"};
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(mesh_extension(static_cast<MeshFormat>(i)), extensions[i]);
        EXPECT_EQ('.' + std::string{mesh_format_names[i].substr(0, 3)}, extensions[i]);
    }
}

}  // namespace
}  // namespace endmill
