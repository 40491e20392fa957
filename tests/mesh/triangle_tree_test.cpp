// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "test_meshes.h"

namespace endmill {
namespace {

using LongVec3 = Eigen::Matrix<long double, 3, 1>;
using test::Corners;

// The second route, in long double: the nearest of the foot on the plane, if its
// barycentric coordinates are inside, and the feet on the sides.
long double distance_to(const Corners& corners, const Vec3& place)
{
    std::array<LongVec3, 3> p;
    for (int k = 0; k < 3; ++k)
        p[k] = (corners[k].cast<long double>() - place.cast<long double>());
    long double least = p[0].norm();
    for (int k = 0; k < 3; ++k) {
        const LongVec3 side = p[(k + 1) % 3] - p[k];
        const long double share = -side.dot(p[k]) / side.squaredNorm();
        if (share >= 0)
            least = std::min(least, (p[k] + std::min(share, 1.0L) * side).norm());
        least = std::min(least, p[k].norm());
    }
    const LongVec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
    const LongVec3 foot = p[0].dot(normal) / normal.squaredNorm() * normal;
    bool inside = true;
    for (int k = 0; k < 3; ++k)
        inside &= (p[(k + 1) % 3] - p[k]).cross(foot - p[k]).dot(normal) >= 0;
    return inside ? std::min(least, foot.norm()) : least;
}

long double distance_to(const TriangleMesh& mesh, const Vec3& place)
{
    long double least = std::numeric_limits<long double>::infinity();
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k)
        least = std::min(least, distance_to(mesh.corners(k), place));
    return least;
}

double largest_coordinate(const TriangleMesh& mesh, const Vec3& place)
{
    double largest = place.lpNorm<Eigen::Infinity>();
    for (const Vec3& point : mesh.points())
        largest = std::max(largest, point.lpNorm<Eigen::Infinity>());
    return largest;
}

TriangleMesh random_triangles(test::Random& random, int count, double size)
{
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    for (int k = 0; k < count; ++k) {
        const Vec3 centre = test::random_point(random, 1);
        for (int corner = 0; corner < 3; ++corner)
            points.emplace_back(centre + test::random_point(random, size));
        triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
    }
    return {std::move(points), std::move(triangles)};
}

void expect_nearest(const TriangleMesh& mesh, const Vec3& place)
{
    const TriangleTree tree{mesh};
    const NearestPoint found = tree.nearest(place).value();
    EXPECT_FALSE(tree.nearest(place, {}, 0.999 * found.distance));
    EXPECT_EQ(tree.nearest(place, {}, found.distance * 1.01 + 1e-300)->point,
              found.point);
    const double accuracy = 1e-14 * largest_coordinate(mesh, place);
    EXPECT_NEAR(found.distance, double(distance_to(mesh, place)), accuracy);
    EXPECT_NEAR((found.point - place).norm(), found.distance, accuracy);
    EXPECT_NEAR(double(distance_to(mesh.corners(found.triangle), found.point)), 0,
                accuracy);
}

// Expects that the nearest point of a mesh to some places is found, bit by bit, on the
// triangle that a test of every triangle finds. \param away of the places, in mm, from
// points of the mesh.
void expect_as_of_every_triangle(const TriangleMesh& mesh, test::Random& random,
                                 double away)
{
    const TriangleTree tree{mesh};
    for (int k = 0; k < 40; ++k) {
        const Vec3 place =
            mesh.points()[static_cast<std::size_t>(random.uniform(0, 999))] +
            test::random_point(random, away);
        double least = std::numeric_limits<double>::infinity();
        std::size_t triangle = 0;
        for (std::size_t t = 0; t < mesh.triangles().size(); ++t) {
            const double square =
                (nearest_on_triangle(place, mesh.corners(t)) - place).squaredNorm();
            if (square < least) {
                least = square;
                triangle = t;
            }
        }
        const auto found = tree.nearest(place);
        EXPECT_EQ(found->distance, std::sqrt(least));
        EXPECT_EQ(found->triangle, triangle);
    }
}

TEST(Nearest, EqualsTheResultOfTestingEveryTriangle)
{
    test::Random random{1};
    for (const int count : {1, 2, 4, 5, 15, 16, 17, 64, 65, 300})
        for (const double size : {0.01, 0.2, 3.0}) {
            const TriangleMesh mesh = random_triangles(random, count, size);
            for (int k = 0; k < 30; ++k)
                expect_nearest(mesh, test::random_point(random, k % 2 ? 1.5 : 10));
        }
}

// Seen from afar, slabs exclude the smooth parts. Every triangle is tested by the function
// that the tree uses, so the results must be equal bit by bit.
TEST(Nearest, OfASmoothMeshEqualsTheResultOfTestingEveryTriangle)
{
    test::Random random{11};
    const TriangleMesh sheet = test::grid_mesh(40, 30, [](int i, int j) {
        return Vec3{0.1 * i, 0.1 * j, std::sin(i / 6.0) * std::cos(j / 9.0)};
    });
    for (const TriangleMesh& mesh : {sheet, test::torus_mesh(40, 25)})
        for (const double away : {0.01, 0.1, 1.0, 10.0, 1e3, 1e6})
            expect_as_of_every_triangle(mesh, random, away);
}

// Boxes are stored in floats, which have few digits far from the origin.
TEST(Nearest, OfASmoothMeshOfAnySizeAndPlaceEqualsTheResultOfTestingEveryTriangle)
{
    test::Random random{12};
    const TriangleMesh torus = test::torus_mesh(40, 25);
    for (const Vec3& offset : {Vec3{0, 0, 0}, Vec3{1e2, -30, 7}, Vec3{1e5, 2e6, -3e4}})
        for (const double scale : {1e-25, 1e-20, 1e-12, 1e-3, 1e6, 1e14, 1e19, 1e22}) {
            std::vector<Vec3> points;
            for (const Vec3& point : torus.points())
                points.push_back(scale * (point + offset));
            const TriangleMesh mesh{points, test::triangles_of(torus)};
            for (const double away : {1e-3, 0.3, 20.0})
                expect_as_of_every_triangle(mesh, random, scale * away);
        }
}

TEST(Nearest, HoldsItsAccuracyFarAwayAndFarFromTheOrigin)
{
    test::Random random{2};
    const TriangleMesh mesh = random_triangles(random, 40, 0.3);
    std::vector<Vec3> moved = test::points_of(mesh);
    for (Vec3& point : moved)
        point += Vec3{1e6, -3e5, 2e4};
    const TriangleMesh far{moved, test::triangles_of(mesh)};
    for (int k = 0; k < 100; ++k) {
        expect_nearest(mesh, test::random_point(random, 1e6));
        expect_nearest(far, moved.front() + test::random_point(random, 2));
    }
}

// In the triangle's own frame the nearest point is known. Rotating the frame moves the
// corners by no more than rounding.
TEST(Nearest, HoldsItsAccuracyOnThinTriangles)
{
    test::Random random{3};
    for (const double height : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15})
        for (int trial = 0; trial < 200; ++trial) {
            const Eigen::AngleAxisd turn{random.uniform(0, 6),
                                         test::random_point(random, 1).normalized()};
            const double apex = random.uniform(0.1, 0.9);
            const double above = random.uniform(0, 1);
            const double along = apex * above + random.uniform(0, 1) * (1 - above);
            const double lift = random.uniform(-1, 1);
            const TriangleMesh mesh{{turn * Vec3{0, 0, 0}, turn * Vec3{1, 0, 0},
                                     turn * Vec3{apex, height, 0}},
                                    {{0, 1, 2}}};
            const TriangleTree tree{mesh};
            const auto distance = [&](const Vec3& place) {
                return tree.nearest(turn * place)->distance;
            };
            EXPECT_NEAR(distance({along, above * height, lift}), std::abs(lift), 1e-14);
            EXPECT_NEAR(distance({along, above * height, 0}), 0, 1e-14);
            EXPECT_NEAR(distance({along, -0.5, lift}), std::hypot(0.5, lift), 1e-14);
            EXPECT_NEAR(distance({-0.3, -0.4, 0}), 0.5, 1e-14);
            EXPECT_NEAR(distance({1.3, 0, 0.4}), 0.5, 1e-14);
        }
}

TEST(Nearest, DoesNotDependOnTheHint)
{
    test::Random random{4};
    const TriangleMesh torus = test::torus_mesh(24, 12);
    const TriangleTree tree{torus};
    for (int k = 0; k < 200; ++k) {
        const Vec3 place =
            k % 2 ? test::random_point(random, 5) : torus.points()[std::size_t(k)];
        const NearestPoint alone = tree.nearest(place).value();
        for (std::size_t hint = k % 7; hint < torus.triangles().size(); hint += 7) {
            const NearestPoint hinted = tree.nearest(place, hint).value();
            EXPECT_EQ(hinted.distance, alone.distance);
            EXPECT_EQ(hinted.point, alone.point);
            EXPECT_EQ(hinted.triangle, alone.triangle);
        }
    }
}

TEST(Nearest, IsTheLowestTriangleOfThoseThatShareAnEdgeOrPoint)
{
    // Above an edge of the box and beyond its corners, where the twelve triangles are
    // known.
    const TriangleMesh box = test::box_mesh({0, 0, 0}, {0.1, 0.3, 0.7});
    const TriangleTree tree{box};
    const auto lowest_with = [&](std::initializer_list<std::int32_t> corners) {
        for (std::size_t k = 0;; ++k)
            if (std::ranges::all_of(corners, [&](std::int32_t corner) {
                    return std::ranges::count(box.triangles()[k], corner) > 0;
                }))
                return k;
    };
    for (std::int32_t corner = 0; corner < 8; ++corner) {
        const Vec3 middle{0.05, 0.15, 0.35};
        const Vec3 beyond = middle + 1.7 * (box.points()[corner] - middle);
        EXPECT_EQ(tree.nearest(beyond)->triangle, lowest_with({corner}));
        EXPECT_EQ(tree.nearest(beyond)->point, box.points()[corner]);
    }
    EXPECT_EQ(tree.nearest({0.3, 0.61, 0.31})->triangle, lowest_with({3, 7}));
    EXPECT_EQ(tree.nearest({-0.3, 0.11, 0.97})->triangle, lowest_with({4, 6}));
    EXPECT_EQ(tree.nearest({0.07, -0.3, -0.2})->triangle, lowest_with({0, 1}));
}

TEST(Nearest, HasTheSameDistanceForEveryOrderOfTriangles)
{
    test::Random random{5};
    const TriangleMesh torus = test::torus_mesh(40, 30);
    std::vector<Triangle> triangles = test::triangles_of(torus);
    std::ranges::shuffle(triangles, random.engine());
    const TriangleMesh shuffled{test::points_of(torus), triangles};
    const TriangleTree a{torus};
    const TriangleTree b{shuffled};
    for (int k = 0; k < 300; ++k) {
        const Vec3 place = test::random_point(random, 4);
        EXPECT_EQ(a.nearest(place)->distance, b.nearest(place)->distance);
    }
}

TEST(Nearest, IsFoundOnTrianglesWithoutArea)
{
    const std::vector<Vec3> points{{1, 1, 1}, {3, 1, 1}, {2, 1, 1}, {1, 1, 1}};
    for (const Triangle& triangle :
         {Triangle{0, 1, 2}, {2, 0, 1}, {1, 2, 0}, {1, 3, 0}, {0, 0, 1}, {1, 0, 1}}) {
        const TriangleMesh mesh{points, {triangle}};
        EXPECT_NEAR(TriangleTree{mesh}.nearest({2.5, 4, 5})->distance, 5, 1e-14);
        EXPECT_NEAR(TriangleTree{mesh}.nearest({4, 1, 1})->distance, 1, 1e-14);
    }
    const TriangleMesh all_equal{points, std::vector<Triangle>(50, Triangle{0, 3, 0})};
    EXPECT_EQ(TriangleTree{all_equal}.nearest({1, 4, 5})->distance, 5);
    EXPECT_EQ(TriangleTree{all_equal}.nearest({1, 4, 5})->triangle, 0U);
}

// By the volumes of the tetrahedra between the ray and the sides.
std::optional<long double> t_of_hit(const Corners& corners, const Ray& ray)
{
    const LongVec3 along = ray.direction.cast<long double>();
    std::array<LongVec3, 3> p;
    for (int k = 0; k < 3; ++k)
        p[k] = (corners[k] - ray.origin).cast<long double>();
    const long double u = along.dot(p[1].cross(p[2]));
    const long double v = along.dot(p[2].cross(p[0]));
    const long double w = along.dot(p[0].cross(p[1]));
    if (std::min({u, v, w}) < 0 && std::max({u, v, w}) > 0)
        return std::nullopt;
    const long double t = p[0].dot(p[1].cross(p[2])) / (u + v + w);
    return t >= 0 ? std::optional{t} : std::nullopt;
}

std::optional<long double> t_of_first_hit(const TriangleMesh& mesh, const Ray& ray)
{
    std::optional<long double> first;
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k) {
        const auto t = t_of_hit(mesh.corners(k), ray);
        if (t && (!first || *t < *first))
            first = t;
    }
    return first;
}

void expect_first_hit(const TriangleMesh& mesh, const TriangleTree& tree, const Ray& ray)
{
    const auto expected = t_of_first_hit(mesh, ray);
    const auto found = tree.first_hit(ray);
    ASSERT_EQ(found.has_value(), expected.has_value());
    EXPECT_EQ(tree.any_hit(ray), found.has_value());
    if (!found)
        return;
    const double length = ray.direction.norm();
    EXPECT_NEAR(found->t * length, double(*expected) * length, 1e-12);
    EXPECT_NEAR(double(distance_to(mesh.corners(found->triangle), found->point)), 0,
                1e-14 * largest_coordinate(mesh, ray.origin));
    EXPECT_TRUE(tree.any_hit(ray, found->t));
    EXPECT_FALSE(tree.any_hit(ray, found->t * (1 - 1e-9) - 1e-9));
}

TEST(FirstHit, EqualsTheResultOfTestingEveryTriangle)
{
    test::Random random{6};
    for (const int count : {1, 4, 17, 65, 400}) {
        const TriangleMesh mesh = random_triangles(random, count, 0.3);
        const TriangleTree tree{mesh};
        for (int k = 0; k < 300; ++k) {
            const Vec3 origin = test::random_point(random, k % 3 ? 2 : 0.5);
            const double length = random.log_uniform(1e-3, 1e3);
            expect_first_hit(mesh, tree,
                             {origin, length * test::random_point(random, 1)});
        }
    }
}

TEST(FirstHit, OfARayAlongAnAxisIsAsAccurate)
{
    const TriangleMesh bumps = test::grid_mesh(20, 20, [](int i, int j) {
        return Vec3{i * 1.0, j * 1.0, std::sin(i * 0.7) * std::cos(j * 0.9)};
    });
    const TriangleTree tree{bumps};
    test::Random random{7};
    for (int k = 0; k < 200; ++k) {
        const Vec3 origin{random.uniform(-1, 21), random.uniform(-1, 21), 3};
        expect_first_hit(bumps, tree, {origin, {0, 0, -1}});
        expect_first_hit(bumps, tree, {origin, {-0.0, 0, -2}});
        expect_first_hit(bumps, tree, {origin, {0, 0, 1}});
        const Vec3 beside{-3, random.uniform(0, 20), random.uniform(-1, 1)};
        expect_first_hit(bumps, tree, {beside, {1, 0, 0}});
        expect_first_hit(bumps, tree, {beside, {-1, 0, 1e-200}});
    }
}

TEST(FirstHit, OfARayFromAClosedMeshIsNeverMissed)
{
    // Rays through points, through places of edges, and past them by the last bit.
    const TriangleMesh torus = test::torus_mesh(31, 17);
    const TriangleTree tree{torus};
    test::Random random{8};
    for (int trial = 0; trial < 20000; ++trial) {
        const double angle = random.uniform(0, 6.28);
        const Vec3 origin = Vec3{3 * std::cos(angle), 3 * std::sin(angle), 0} +
                            test::random_point(random, 0.3);
        const auto& [a, b, c] =
            torus.triangles()[std::size_t(random.uniform(0, 2 * 31 * 17))];
        const double share = trial % 3 == 0 ? 0 : random.uniform(0, 1);
        const Vec3 on_edge =
            torus.points()[a] + share * (torus.points()[b] - torus.points()[a]);
        ASSERT_TRUE(tree.any_hit({origin, on_edge - origin}));
        ASSERT_TRUE(tree.first_hit({origin, origin - on_edge}));
    }
}

TEST(FirstHit, ThroughAPointOfAGridIsNeverMissed)
{
    const TriangleMesh grid = test::flat_mesh(16, 16);
    const TriangleTree tree{grid};
    for (int i = 1; i < 16; ++i)
        for (int j = 1; j < 16; ++j)
            for (const Vec3& towards :
                 {Vec3{0, 0, -1}, {0.3, 0.7, -1}, {1, -0.1, -0.1}}) {
                const Vec3 target{double(i), double(j), 0};
                const auto hit = tree.first_hit({target - 4 * towards, towards});
                ASSERT_TRUE(hit);
                EXPECT_NEAR(hit->t, 4, 1e-13);
            }
}

TEST(FirstHit, CountsAnOriginOnTheMeshAndNoneBehindIt)
{
    const TriangleMesh flat = test::flat_mesh(4, 4);
    const TriangleTree tree{flat};
    EXPECT_EQ(tree.first_hit({{1.3, 2.1, 0}, {0, 0, 1}})->t, 0);
    EXPECT_EQ(tree.first_hit({{1.3, 2.1, 2}, {0, 0, -0.5}})->t, 4);
    EXPECT_FALSE(tree.first_hit({{1.3, 2.1, 1}, {0, 0, 1}}));
    EXPECT_FALSE(tree.any_hit({{1.3, 2.1, 1}, {0, 0, -1}}, 0.999));
    EXPECT_TRUE(tree.any_hit({{1.3, 2.1, 1}, {0, 0, -1}}, 1));
}

TEST(FirstHit, IsTheLowestOfEqualTriangles)
{
    const TriangleMesh twice{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                             std::vector<Triangle>(40, Triangle{0, 1, 2})};
    const TriangleTree tree{twice};
    EXPECT_EQ(tree.first_hit({{0.2, 0.3, 1}, {0, 0, -1}})->triangle, 0U);
    EXPECT_EQ(tree.nearest({0.2, 0.3, 1})->triangle, 0U);
}

TEST(TriangleTree, OfNoTrianglesFindsNothing)
{
    const TriangleMesh empty;
    const TriangleTree tree{empty};
    EXPECT_FALSE(tree.nearest({0, 0, 0}));
    EXPECT_FALSE(tree.first_hit({{0, 0, 0}, {0, 0, 1}}));
    EXPECT_FALSE(tree.any_hit({{0, 0, 0}, {0, 0, 1}}));
}

TEST(TriangleTree, RefusesArgumentsOutOfItsDomain)
{
    const TriangleMesh flat = test::flat_mesh(1, 1);
    const TriangleTree tree{flat};
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(tree.nearest({0, nan, 0}), DomainError);
    EXPECT_THROW(tree.nearest({0, 1e31, 0}), DomainError);
    EXPECT_THROW(tree.nearest({0, 0, 0}, 2), DomainError);
    EXPECT_THROW(tree.first_hit({{0, 0, 0}, {0, 0, 0}}), DomainError);
    EXPECT_THROW(tree.first_hit({{0, 0, 0}, {0, nan, 1}}), DomainError);
    EXPECT_THROW(tree.first_hit({{0, 0, nan}, {0, 0, 1}}), DomainError);
    const TriangleMesh huge{{{1e31, 0, 0}}, {}};
    EXPECT_THROW(TriangleTree{huge}, DomainError);
}

TEST(TriangleTree, FindsTrianglesOfEverySize)
{
    for (const double scale : {1e-25, 1e-6, 1e8, 1e28}) {
        const TriangleMesh box =
            test::box_mesh(Vec3::Constant(-scale), Vec3::Constant(scale));
        const TriangleTree tree{box};
        EXPECT_NEAR(tree.nearest({0, 0, 3 * scale})->distance, 2 * scale, 1e-14 * scale);
        EXPECT_NEAR(tree.first_hit({{0.1 * scale, 0, 3 * scale}, {0, 0, -1}})->t,
                    2 * scale, 1e-14 * scale);
    }
}

}  // namespace
}  // namespace endmill
