// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/sampled_patch.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/mesh/triangle_tree.h"
#include "random.h"

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// The points of a steep wave.
std::vector<Vec3> wave(int columns, int rows)
{
    std::vector<Vec3> points;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i)
            points.emplace_back(i, j, 3 * i + 2 * std::sin(0.4 * i) * std::cos(0.3 * j));
    return points;
}

// The same triangles as a mesh.
TriangleMesh mesh_of(const std::vector<Vec3>& points, int columns, int rows)
{
    std::vector<Triangle> triangles;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const int own = j * (columns + 1) + i;
            triangles.push_back({own, own + 1, own + columns + 2});
            triangles.push_back({own, own + columns + 2, own + columns + 1});
        }
    return TriangleMesh{points, std::move(triangles)};
}

TEST(SampledPatch, AgreesWithATreeOfBoxes)
{
    for (const auto& [columns, rows] : {std::pair{16, 8}, {1, 1}, {1, 4}, {8, 1}}) {
        const std::vector<Vec3> points = wave(columns, rows);
        const TriangleMesh mesh = mesh_of(points, columns, rows);
        const TriangleTree tree{mesh};
        const SampledPatch patch{points, columns, rows};
        test::Random random{1};
        for (int i = 0; i < 300; ++i) {
            const Vec3 place{random.uniform(-5, 20), random.uniform(-5, 15),
                             random.uniform(-10, 60)};
            NearestSearch search{place, infinite};
            patch.look(search, 7);
            const NearestPoint expected = *tree.nearest(place);
            ASSERT_TRUE(search.point);
            EXPECT_NEAR(std::sqrt(search.least_square), expected.distance, 1e-12);
            EXPECT_NEAR((*search.point - place).norm(), expected.distance, 1e-12);
            EXPECT_EQ(search.number, 7U);
        }
    }
}

TEST(SampledPatch, KeepsTheNearerPlace)
{
    const SampledPatch patch{wave(4, 4), 4, 4};
    const Vec3 place{2, 2, 30};
    NearestSearch all{place, infinite};
    patch.look(all, 0);
    NearestSearch nearer{place, all.least_square};
    patch.look(nearer, 0);
    EXPECT_FALSE(nearer.point);
    NearestSearch further{place, all.least_square * 1.001};
    patch.look(further, 0);
    EXPECT_EQ(further.point, all.point);
}

TEST(NearestSearch, OfEqualPlacesTakesThatOfTheFirstPatch)
{
    NearestSearch search{Vec3::Zero(), infinite};
    search.take({1, 0, 0}, 5, 0);
    search.take({0, 1, 0}, 3, 9);
    search.take({0, 0, 1}, 4, 0);
    EXPECT_EQ(search.number, 3U);
    EXPECT_EQ(search.point, (Vec3{0, 1, 0}));
    search.take({-1, 0, 0}, 3, 2);
    EXPECT_EQ(search.point, (Vec3{-1, 0, 0}));
}

TEST(SampledPatch, RefusesOtherNumbersOfPoints)
{
    EXPECT_THROW((SampledPatch{wave(4, 4), 4, 2}), DomainError);
    EXPECT_THROW((SampledPatch{wave(3, 4), 3, 4}), DomainError);
    EXPECT_THROW((SampledPatch{{}, 0, 0}), DomainError);
}

}  // namespace
}  // namespace endmill
