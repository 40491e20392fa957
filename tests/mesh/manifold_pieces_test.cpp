// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/detail/manifold_pieces.h"

#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "test_meshes.h"

namespace endmill {
namespace {

// By checking all sides: no directed side is used twice, and the triangles at each point
// are connected across sides at this point.
void expect_manifold(const std::vector<Triangle>& triangles)
{
    std::map<std::array<std::int32_t, 2>, std::size_t> sides;
    std::map<std::int32_t, std::set<std::size_t>> at_point;
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            EXPECT_TRUE(
                sides.insert({{triangles[t][k], triangles[t][(k + 1) % 3]}, t}).second);
            at_point[triangles[t][k]].insert(t);
        }
    for (const auto& [point, around] : at_point) {
        std::set<std::size_t> reached{*around.begin()};
        std::vector<std::size_t> open{*around.begin()};
        while (!open.empty()) {
            const Triangle& here = triangles[open.back()];
            open.pop_back();
            for (int k = 0; k < 3; ++k) {
                const std::array side{here[(k + 1) % 3], here[k]};
                const auto beyond = sides.find(side);
                if ((side[0] == point || side[1] == point) && beyond != sides.end() &&
                    reached.insert(beyond->second).second)
                    open.push_back(beyond->second);
            }
        }
        EXPECT_EQ(reached, around) << point;
    }
}

TEST(ManifoldPieces, OfAManifoldMeshHaveItsPoints)
{
    const TriangleMesh mesh = test::both(test::torus_mesh(9, 5), test::flat_mesh(4, 6));
    const ManifoldPieces pieces = manifold_pieces(mesh);
    EXPECT_EQ(pieces.points.size(), mesh.points().size());
    EXPECT_EQ(std::set<std::int32_t>(pieces.points.begin(), pieces.points.end()).size(),
              mesh.points().size());
    expect_manifold(pieces.triangles);
}

// Random triangles over few points are non-manifold nearly everywhere.
TEST(ManifoldPieces, AreManifoldForEveryMesh)
{
    test::Random random{7};
    for (int trial = 0; trial < 300; ++trial) {
        const int count = 4 + trial % 9;
        const auto number = [&] {
            return static_cast<std::int32_t>(random.uniform(0, count));
        };
        std::vector<Triangle> triangles;
        for (int k = 0; k < 5 + trial; ++k)
            triangles.push_back({number(), number(), number()});
        const TriangleMesh mesh{std::vector<Vec3>(count, Vec3::Zero()), triangles};
        const ManifoldPieces pieces = manifold_pieces(mesh);
        expect_manifold(pieces.triangles);
        std::size_t sound = 0;
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            const auto& [a, b, c] = triangles[t];
            if (a == b || b == c || c == a)
                continue;
            ASSERT_LT(sound, pieces.triangles.size());
            EXPECT_EQ(pieces.source_triangles[sound], static_cast<std::int32_t>(t));
            for (int k = 0; k < 3; ++k)
                EXPECT_EQ(pieces.points[pieces.triangles[sound][k]], triangles[t][k]);
            ++sound;
        }
        EXPECT_EQ(sound, pieces.triangles.size());
    }
}

}  // namespace
}  // namespace endmill
