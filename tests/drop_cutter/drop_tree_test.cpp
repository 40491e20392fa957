// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/drop_tree.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "random.h"
#include "test_meshes.h"

namespace endmill {
namespace {

const std::array cutters{Cutter::ball(2), Cutter::flat(2), Cutter{2, 0.5}};

TriangleMesh hills(int cells)
{
    return test::grid_mesh(cells, cells, [&](double i, double j) {
        const double x = 20 * i / cells;
        const double y = 20 * j / cells;
        return Vec3{x, y, 3 * std::sin(x / 2) * std::cos(y / 3) + std::floor(x / 7)};
    });
}

// Visits all triangles whose bound is not below `level`, and records the bounds.
struct Everything {
    const DropTree& tree;
    float x;
    float y;
    float level;
    std::set<std::size_t> seen;

    float limit() const { return level; }
    FloatLanes bounds(const DropTree::Nodes& nodes, const FloatLanes& tops) const
    {
        return tree.tip_bounds(nodes, tops, x, y);
    }
    void look_at(std::size_t triangle) { seen.insert(triangle); }
};

// A point q of the mesh lifts the tip to q_z - h(rho). A search with a limit that is not
// higher must visit its triangle.
TEST(DropTree, NeverBoundsATriangleBelowWhatItsPointsReach)
{
    const TriangleMesh mesh = hills(24);
    test::Random random{1};
    for (const Cutter& cutter : cutters) {
        const DropTree tree{mesh, cutter};
        for (int k = 0; k < 2000; ++k) {
            const auto triangle = static_cast<std::size_t>(
                random.uniform(0, double(mesh.triangles().size())));
            const auto [a, b, c] = mesh.corners(triangle);
            const double u = random.uniform(0, 1);
            const Vec3 q = a + u * (b - a) + random.uniform(0, 1 - u) * (c - a);
            const double away = random.uniform(0, 2);
            const double angle = random.uniform(0, 7);
            const Vec3 place =
                q + away * Vec3{std::cos(angle), std::sin(angle), 0} - tree.origin();
            const double tip = place.z() - cutter.profile(std::min(away, 2.0));
            Everything query{
                tree, float(place.x()), float(place.y()), float(tip - 1e-6), {}};
            tree.search(query);
            EXPECT_EQ(query.seen.count(triangle), 1U);
        }
    }
}

// With tight bounds a search visits few of many triangles.
TEST(DropTree, SkipsNearlyAllTriangles)
{
    const TriangleMesh mesh = hills(100);
    const DropTree tree{mesh, Cutter::ball(2)};
    double highest = -100;  // from the corners, slightly too low
    for (const Vec3& point : mesh.points()) {
        const double away = (point - tree.origin()).head<2>().norm();
        if (away < 2)
            highest = std::max(highest, point.z() - (2 - std::sqrt(4 - away * away)));
    }
    Everything query{tree, 0, 0, float(highest - tree.origin().z()), {}};
    tree.search(query);
    EXPECT_GE(query.seen.size(), 1U);
    EXPECT_LE(query.seen.size(), 40U);
}

// The bounds of a plane, computed from its values, cover the corners of all triangles
// below it.
TEST(DropTree, KeepsPlanesAboveItsTriangles)
{
    struct Planes {
        const DropTree& tree;
        std::vector<DropTree::Plane> met{};
        std::vector<std::size_t> order{};
        float limit() const { return 0; }
        FloatLanes bounds(const DropTree::Nodes& nodes, const FloatLanes&)
        {
            for (Eigen::Index k = 0; k < float_lanes; ++k)
                if (const auto plane = tree.plane(nodes, k); !plane.is_empty)
                    met.push_back(plane);
            return FloatLanes::Ones();
        }
        void look_at(std::size_t triangle) { order.push_back(triangle); }
    };
    const TriangleMesh mesh = test::grid_mesh(1, 4, [](double i, double j) {
        return Vec3{9 * i, 5 * j, i * j - 2 * i};
    });
    for (const Cutter& cutter : cutters) {
        const DropTree tree{mesh, cutter};
        Planes planes{tree};
        tree.search(planes);
        ASSERT_EQ(planes.met.size(), 8U);
        ASSERT_EQ(planes.order.size(), 8U);
        std::size_t above = 0;  // triangles below planes; at least those of its own node
        for (const auto& plane : planes.met) {
            for (const std::size_t triangle : planes.order) {
                bool is_above = true;
                for (const Vec3& corner : mesh.corners(triangle)) {
                    const Vec3 p = corner - tree.origin() - plane.middle;
                    is_above &=
                        p.z() <= plane.slope.dot(p.head<2>()) + 1e-4 &&
                        (p.head<2>().cwiseAbs() - plane.half_size).maxCoeff() < 1e-4;
                }
                above += is_above;
            }
        }
        EXPECT_GE(above, 8U);
    }
}

}  // namespace
}  // namespace endmill
