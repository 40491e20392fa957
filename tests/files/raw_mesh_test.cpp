// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/raw_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"

namespace endmill {
namespace {

using testing::ElementsAre;
using Corners = std::vector<std::int32_t>;

const MeshSource source{"", "f"};
const FilePlace place = FilePlace::line(5);

RawMeshBuilder builder_with_square()
{
    RawMeshBuilder builder{source, 4, 1};
    for (const Vec3& point :
         {Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{2, 2, 0.5}, Vec3{0, 2, 0}})
        builder.add_point(point);
    return builder;
}

std::string complaint_about_face(const Corners& corners)
{
    RawMeshBuilder builder = builder_with_square();
    return complaint_of([&] { builder.add_face(corners, place); });
}

TEST(RawMeshBuilder, SplitsFacesInOrder)
{
    RawMeshBuilder builder = builder_with_square();
    builder.add_face(Corners{2, 1, 0}, place);
    builder.add_face(Corners{0, 1, 2, 3}, place);
    builder.add_face(Corners{3, 2, 0}, place);
    const RawMesh raw = builder.take();
    EXPECT_EQ(raw.mesh.points().size(), 4U);
    EXPECT_THAT(raw.mesh.triangles(), ElementsAre(Triangle{2, 1, 0}, Triangle{0, 1, 2},
                                                  Triangle{0, 2, 3}, Triangle{3, 2, 0}));
    EXPECT_EQ(raw.split_faces, 1U);
    EXPECT_NEAR(raw.out_of_plane_mm, 0.125, 0.005);
}

TEST(RawMeshBuilder, RefusesInvalidFaces)
{
    EXPECT_EQ(complaint_about_face({}),
              "E_DEGENERATE f:5: a face of 0 corners; expected at least 3");
    EXPECT_EQ(complaint_about_face({1}),
              "E_DEGENERATE f:5: a face of 1 corner; expected at least 3");
    EXPECT_EQ(complaint_about_face({0, 1}),
              "E_DEGENERATE f:5: a face of 2 corners; expected at least 3");
    for (const Corners& corners : {Corners{0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {0, 1, 2, 0}})
        EXPECT_EQ(complaint_about_face(corners),
                  "E_DEGENERATE f:5: a face names a point twice; "
                  "expected different corners");
    EXPECT_EQ(complaint_about_face({0, 2, 1, 3}),
              "E_POLYGON f:5: a face of 4 corners that is far from convex or crosses "
              "itself; expected triangles or convex faces");
}

TEST(RawMeshBuilder, NeedsNoMoreMemoryThanTheLimit)
{
    const MeshSource tight{"", "f", {.max_memory_gib = 1e-3}};
    EXPECT_THROW(RawMeshBuilder(tight, 50000, 0), LimitError);
    EXPECT_THROW(RawMeshBuilder(tight, 0, 100000), LimitError);
    EXPECT_THROW(RawMeshBuilder(source, 0x80000000U, 0), LimitError);
    RawMeshBuilder builder{tight, 3, 0};
    for (int i = 0; i < 3; ++i)
        builder.add_point({double(i), double(i % 2), 0});
    const auto add_many = [&] {
        for (int i = 0; i < 100000; ++i)
            builder.add_face(Corners{0, 1, 2}, place);
    };
    EXPECT_THAT(complaint_of(add_many),
                testing::StartsWith("E_LIMIT f: reading it needs about "));
}

}  // namespace
}  // namespace endmill
