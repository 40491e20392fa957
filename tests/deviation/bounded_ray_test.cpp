// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/bounded_ray.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

constexpr double before = 8;  // mm, thickness before the motion

Vec3 random_place(test::Random& random, double size)
{
    return {random.uniform(-size, size), random.uniform(-size, size),
            random.uniform(-size, size)};
}

ToolPiece random_piece(test::Random& random, const CuttingBody& body)
{
    const CutterLocation from{random_place(random, 2),
                              (Vec3{0, 0, 2} + random_place(random, 1)).normalized()};
    const Vec3 axis = (from.axis + random_place(random, 0.2)).normalized();
    return {{from, {from.tip + random_place(random, 1), axis}}, body, 3, 3};
}

PartRay random_ray(test::Random& random)
{
    PartRay ray;
    ray.point = random_place(random, 6);
    ray.normal = (Vec3{0, 0, 1} + random_place(random, 1.5)).normalized();
    return ray;
}

// The thickness by many poses, each by bisection on the ray. Poses whose line inside the
// cutter ends below the ray's point do not count.
double sampled_thickness(const ToolPiece& piece, const PartRay& ray)
{
    double least = before;
    for (int k = 0; k <= 64; ++k) {
        const ToolFrame frame = piece.motion.at(k / 64.0);
        const auto distance = [&](double s) {
            return piece.body.distance(frame.seen(ray.point + s * ray.normal)).value;
        };
        // The least distance on the ray from its point up to `least`; it is convex.
        double low = 0;
        double high = std::max(least, 0.0);
        for (int i = 0; i < 45; ++i) {
            const double a = low + (high - low) * 0.4;
            const double b = low + (high - low) * 0.6;
            (distance(a) < distance(b) ? high : low) = distance(a) < distance(b) ? b : a;
        }
        double inside = distance(0) <= 0 ? 0 : (low + high) / 2;
        if (distance(inside) > 0)
            continue;
        double outside = inside > 0 ? 0 : -100;
        for (int i = 0; i < 45; ++i) {
            const double middle = (inside + outside) / 2;
            (distance(middle) <= 0 ? inside : outside) = middle;
        }
        least = std::min(least, inside);
    }
    return least;
}

std::vector<CuttingBody> bodies()
{
    return {CuttingBody{Cutter::ball(3)}, CuttingBody{Cutter::flat(3)},
            CuttingBody{Cutter{3, 1}}, CuttingBody{Cutter{3, 1}, 5}};
}

TEST(BoundedRay, BoundsContainTheThicknessOfManyPoses)
{
    test::Random random{1};
    int cut_rays = 0;
    for (const CuttingBody& body : bodies())
        for (int i = 0; i < 500; ++i) {
            const ToolPiece piece = random_piece(random, body);
            const PartRay ray = random_ray(random);
            const double sampled = sampled_thickness(piece, ray);
            if (sampled < -50)
                continue;  // along an endless cutter
            BoundedRay bounded{before, before};
            cut(bounded, ray, piece, 0.001);
            EXPECT_LE(bounded.low, sampled + 1e-7);
            EXPECT_LE(bounded.low, bounded.high);
            // The poses are samples: between them the cutter may reach a little lower.
            EXPECT_GE(sampled, bounded.low - 1e-7);
            if (sampled < before && bounded.high < before) {
                ++cut_rays;
                EXPECT_LE(sampled, bounded.high + 0.02);
            }
        }
    EXPECT_GT(cut_rays, 200);
}

TEST(BoundedRay, BoundsAreAsSharpAsAskedForWhereTheRayDoesNotGraze)
{
    test::Random random{2};
    int wide = 0;
    int all = 0;
    for (const CuttingBody& body : bodies())
        for (int i = 0; i < 1000; ++i) {
            const ToolPiece piece = random_piece(random, body);
            const PartRay ray = random_ray(random);
            BoundedRay bounded{before, before};
            cut(bounded, ray, piece, 1e-4);
            if (bounded.low < before) {
                ++all;
                wide += bounded.high - bounded.low > 1e-4 ? 1 : 0;
            }
        }
    EXPECT_LT(wide, all / 20);
}

// What one piece leaves, without being halved, is within the bounds or above them.
TEST(BoundedRay, ThicknessByAPieceIsAnUpperBound)
{
    test::Random random{3};
    for (const CuttingBody& body : bodies())
        for (int i = 0; i < 500; ++i) {
            const ToolPiece piece = random_piece(random, body);
            const PartRay ray = random_ray(random);
            BoundedRay bounded{before, before};
            cut(bounded, ray, piece, 1e-4);
            if (!bounded.piece || bounded.high <= 0)
                continue;
            EXPECT_EQ(bounded.piece, &piece);
            EXPECT_GE(thickness_by(piece, ray, 0, before).value_or(before),
                      bounded.low - 1e-6);
        }
}

// Between the ends of several rays everything is removed.
TEST(BoundedRay, PlacesBetweenRaysAreRemoved)
{
    test::Random random{6};
    int tried = 0;
    for (const CuttingBody& body : bodies())
        for (int i = 0; i < 1000; ++i) {
            const ToolPiece piece = random_piece(random, body);
            PartRay one = random_ray(random);
            PartRay other = one;
            other.point += random_place(random, 0.3);
            const auto a = thickness_by(piece, one, 3, 2);
            const auto b = thickness_by(piece, other, 3, 2);
            if (!a || !b)
                continue;
            ++tried;
            const Vec3 from = one.point + *a * one.normal;
            const Vec3 to = other.point + *b * other.normal;
            const Vec3 place = from + random.uniform(0, 1) * (to - from);
            double least = 1e9;
            for (int k = 0; k <= 400; ++k)
                least = std::min(
                    least, body.distance(piece.motion.seen(place, k / 400.0)).value);
            EXPECT_LE(least, 1e-3);
        }
    EXPECT_GT(tried, 300);
}

TEST(BoundedRay, WithoutATurnIsExact)
{
    // A ball of radius 3 passes level, its centre 1 beside the ray and 4 above.
    const ToolPiece piece{{{{-5, 1, 1}, {0, 0, 1}}, {{5, 1, 1}, {0, 0, 1}}},
                          CuttingBody{Cutter::ball(3)},
                          0,
                          0};
    PartRay ray;
    ray.normal = Vec3::UnitZ();
    BoundedRay bounded{before, before};
    cut(bounded, ray, piece, 1e-6);
    const double exact = 4 - std::sqrt(8);
    EXPECT_LE(bounded.low, exact);
    EXPECT_GE(bounded.high, exact);
    EXPECT_LT(bounded.high - bounded.low, 1e-6);
}

TEST(BoundedRay, VolumeBelowThePointIsOnAnotherSideOfThePart)
{
    // The tool stands upside down below a wall of 1 mm.
    const ToolPiece piece{{{{0, 0, -1}, {0, 0, -1}}, {{0.5, 0, -1}, {0, 0, -1}}},
                          CuttingBody{Cutter::flat(3)},
                          0,
                          0};
    PartRay ray;
    ray.normal = Vec3::UnitZ();
    BoundedRay bounded{before, before};
    cut(bounded, ray, piece, 1e-6);
    EXPECT_EQ(bounded.low, before);
    EXPECT_EQ(bounded.high, before);
}

TEST(BoundedRay, HalfSpaceContainsWhatThePieceSweeps)
{
    test::Random random{4};
    for (const CuttingBody& body : bodies())
        for (int i = 0; i < 300; ++i) {
            const ToolPiece piece = random_piece(random, body);
            const HalfSpace half = half_space_of(
                piece, (Vec3{0, 0, 1} + random_place(random, 2)).normalized());
            if (!std::isfinite(half.least))
                continue;
            for (int k = 0; k < 50; ++k) {
                const Vec3 place = random_place(random, 12);
                const double u = random.uniform(0, 1);
                EXPECT_TRUE(body.distance(piece.motion.seen(place, u)).value > 0 ||
                            half.normal.dot(place) >= half.least);
            }
        }
}

TEST(BoundedRay, DistanceFromAPieceIsALowerBound)
{
    test::Random random{5};
    for (const CuttingBody& body : bodies())
        for (int i = 0; i < 300; ++i) {
            const ToolPiece piece = random_piece(random, body);
            const Vec3 place = random_place(random, 10);
            const PieceDistance found = distance_from(piece, place, 1e9);
            for (int k = 0; k <= 16; ++k)
                EXPECT_LE(found.lower,
                          body.distance(piece.motion.seen(place, k / 16.0)).value);
        }
}

}  // namespace
}  // namespace endmill
