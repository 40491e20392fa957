// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/drop_entries.h"

#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "random.h"
#include "test_meshes.h"

namespace endmill {
namespace {

double area_of(const DropEntries::Corners& corners)
{
    return (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm() / 2;
}

TEST(DropEntries, AreAllTrianglesOnceNeighboursTogether)
{
    const TriangleMesh mesh = test::flat_mesh(64, 64);
    const Vec3 origin{32, 32, 0};
    const DropEntries entries{mesh, origin, 1};
    std::set<std::size_t> seen;
    double travel = 0;
    for (std::size_t k = 0; k < entries.count(); ++k) {
        seen.insert(entries.triangle(k));
        EXPECT_EQ(entries.corners(k)[0] + origin, mesh.corners(entries.triangle(k))[0]);
        if (k > 0)
            travel += (entries.corners(k)[0] - entries.corners(k - 1)[0]).norm();
    }
    EXPECT_EQ(seen.size(), mesh.triangles().size());
    EXPECT_EQ(entries.count(), mesh.triangles().size());
    EXPECT_LT(travel / double(entries.count()), 1.5);
}

// The pieces of a long thin triangle cover it and have much smaller boxes.
TEST(DropEntries, CutLongThinTriangles)
{
    const TriangleMesh mesh{{{0, 0, 0}, {100, 100, 5}, {99, 100, 7}}, {{0, 1, 2}}};
    const Vec3 origin{50, 50, 3};
    const DropEntries entries{mesh, origin, 2};
    EXPECT_GT(entries.count(), 10U);
    double area = 0;
    double boxes = 0;
    for (std::size_t k = 0; k < entries.count(); ++k) {
        EXPECT_EQ(entries.triangle(k), 0U);
        area += area_of(entries.corners(k));
        boxes += entries.whole(k, k + 1, 0).box.volume();
    }
    EXPECT_NEAR(area, area_of(mesh.corners(0)), 1e-9);
    EXPECT_LT(boxes, 0.4 * 100 * 100);
    DropEntries spent = entries;
    EXPECT_EQ(std::move(spent).into_triangles(),
              std::vector<std::uint32_t>(entries.count(), 0));
}

TEST(DropEntries, LieInTheirBoxBelowTheirPlane)
{
    test::Random random{1};
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    for (int k = 0; k < 200; ++k) {
        for (int corner = 0; corner < 3; ++corner)
            points.push_back(test::random_point(random, 9));
        if (k % 4 == 0)
            points.back() = points[points.size() - 2] + Vec3{0, 0, 1};
        if (k % 4 == 1)
            points.back() = points[points.size() - 2];
        triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
    }
    const TriangleMesh mesh{points, triangles};
    const Vec3 origin{0.5, 0.25, 0.125};
    const DropEntries entries{mesh, origin, 2};
    for (const std::size_t span : {1, 4, 64, 1000})
        for (std::size_t first = 0; first < entries.count(); first += span) {
            const std::size_t last = std::min(first + span, entries.count());
            const DropEntry whole = entries.whole(first, last, 1e-12);
            EXPECT_LE(whole.slope.norm(), 16 + 1e-12);
            for (std::size_t k = first; k < last; ++k)
                for (const Vec3& p : entries.corners(k)) {
                    EXPECT_TRUE(whole.box.contains(p.head<2>()));
                    EXPECT_LE(p.z(), whole.top);
                    EXPECT_LE(p.z(), whole.height + whole.slope.dot(p.head<2>()) + 1e-12);
                }
        }
}

TEST(DropEntries, FitThePlaneOfAPlane)
{
    const TriangleMesh mesh = test::grid_mesh(9, 9, [](double i, double j) {
        return Vec3{i, j, 0.5 * i - 2 * j + 1};
    });
    const Vec3 origin = Vec3::Zero();
    const DropEntries entries{mesh, origin, 2};
    for (const std::size_t last : {std::size_t{1}, std::size_t{16}, entries.count()}) {
        const DropEntry whole = entries.whole(0, last, 0);
        EXPECT_NEAR((whole.slope - Eigen::Vector2d{0.5, -2}).norm(), 0, 1e-9);
        EXPECT_NEAR(whole.height, 1, 1e-9);
    }
}

}  // namespace
}  // namespace endmill
