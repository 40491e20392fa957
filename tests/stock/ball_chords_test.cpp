// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/ball_chords.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "endmill/stock/detail/ray_on_motion.h"
#include "random.h"

namespace endmill {
namespace {

Vec3 random_place(test::Random& random, double size)
{
    return {random.uniform(-size, size), random.uniform(-size, size),
            random.uniform(-size, size)};
}

constexpr double radius = 3;
constexpr double accuracy = 1e-7;

// Eight parallel rays and a motion of a ball. Every third motion does not turn; every fourth
// one is upright at its start, with rays along the axis; every eighth one is along the axis.
struct RandomRays {
    RandomRays(test::Random& random, int number)
    {
        const bool is_upright = number % 4 == 0;
        const bool is_plunge = number % 8 == 0;
        const Vec3 way =
            is_plunge ? Vec3{0, 0, random.uniform(-1, 1)} : random_place(random, 1);
        const Vec3 lean = is_upright ? Vec3{Vec3::Zero()} : random_place(random, 1);
        const CutterLocation from{random_place(random, 2),
                                  (Vec3{0, 0, 2} + lean).normalized()};
        const Vec3 turn =
            number % 3 == 0 || is_plunge ? Vec3{Vec3::Zero()} : random_place(random, 0.2);
        motion = ToolMotion{from, {from.tip + way, (from.axis + turn).normalized()}};
        start = random_place(random, 4);
        direction =
            is_upright ? Vec3{Vec3::UnitZ()} : random_place(random, 1).normalized();
        const Vec3 along = direction.unitOrthogonal();
        for (std::size_t i = 0; i < 8; ++i) {
            const Vec3 movement = random.uniform(-3, 3) * along +
                                  random.uniform(-3, 3) * direction.cross(along);
            for (std::size_t c = 0; c < 3; ++c)
                movements[c][i] = movement[static_cast<Eigen::Index>(c)];
        }
    }

    Vec3 start_of(std::size_t i) const
    {
        return start + Vec3{movements[0][i], movements[1][i], movements[2][i]};
    }

    RayOnMotion one(std::size_t i, const CuttingBody& body) const
    {
        return {start_of(i), direction, motion, body};
    }

    // The least signed distance over many poses.
    double sampled(std::size_t i, double s, const CuttingBody& body) const
    {
        double least = 1e9;
        for (int k = 0; k <= 64; ++k)
            least = std::min(
                least,
                body.distance(motion.seen(start_of(i) + s * direction, k / 64.0)).value);
        return least;
    }

    ToolMotion motion{{{0, 0, 0}, {0, 0, 1}}, {{0, 0, 0}, {0, 0, 1}}};
    Vec3 start;
    Vec3 direction;
    EightPlaces movements{};
};

class BallChords : public testing::Test {
protected:
    // Calls `check(rays, ball, seen)` for random rays.
    template <typename Check>
    static void for_random_rays(const Check& check)
    {
        test::Random random{11};
        for (int number = 0; number < 400; ++number) {
            const RandomRays rays{random, number};
            const BallOnRays ball{rays.start, rays.direction, rays.motion, radius};
            check(rays, ball, moved_rays(ball, rays.movements));
        }
    }

    // The error on the places from -9 to 9 mm of all rays.
    double largest_error(const RandomRays& rays) const
    {
        double error = 0;
        for (std::size_t i = 0; i < 8; ++i)
            error = std::max(
                {error, rays.one(i, body_).error(-9), rays.one(i, body_).error(9)});
        return error;
    }

    static EightChords chords_between(double from, double to, const BallOnRays& ball,
                                      const EightRays& rays, double error)
    {
        EightStretches search;
        search.from.fill(from);
        search.to.fill(to);
        return ball_chords(ball, rays, search, error, accuracy);
    }

    const CuttingBody body_{Cutter::ball(radius)};
};

TEST_F(BallChords, RaysAreSeenFromBothEnds)
{
    for_random_rays([](const RandomRays& rays, const BallOnRays&, const EightRays& seen) {
        for (std::size_t i = 0; i < 8; ++i)
            for (std::size_t c = 0; c < 3; ++c) {
                const auto axis = static_cast<Eigen::Index>(c);
                EXPECT_NEAR(seen.from[c][i],
                            rays.motion.from().seen(rays.start_of(i))[axis], 1e-12);
                EXPECT_NEAR(seen.to[c][i], rays.motion.to().seen(rays.start_of(i))[axis],
                            1e-12);
            }
    });
}

TEST_F(BallChords, NearStretchesAreThoseOfTheBody)
{
    int found = 0;
    for_random_rays(
        [&](const RandomRays& rays, const BallOnRays& ball, const EightRays& seen) {
            const EightStretches near = near_stretches(ball, seen, 0.3);
            for (std::size_t i = 0; i < 8; ++i) {
                const RayOnMotion one = rays.one(i, body_);
                const auto expected =
                    body_.near_stretch(one.middle_start(), one.middle_direction(), 0.3);
                ASSERT_EQ(near.from[i] <= near.to[i], expected.has_value());
                if (!expected)
                    continue;
                ++found;
                const auto expect_same = [](double number, double wanted) {
                    if (std::isinf(wanted))
                        EXPECT_EQ(number, wanted);
                    else
                        EXPECT_NEAR(number, wanted, 1e-9 * (1 + std::abs(wanted)));
                };
                expect_same(near.from[i], expected->from);
                expect_same(near.to[i], expected->to);
            }
        });
    EXPECT_GT(found, 1000);
}

// The expected ends come from the search on one ray, which has branches, and the bounds from
// poses.
TEST_F(BallChords, ChordsAreThoseOfSingleRays)
{
    int chords_seen = 0;
    int whole = 0;
    for_random_rays([&](const RandomRays& rays, const BallOnRays& ball,
                        const EightRays& seen) {
        const double error = largest_error(rays);
        const EightChords chords = chords_between(-9, 9, ball, seen, error);
        for (std::size_t i = 0; i < 8; ++i) {
            RayOnMotion one = rays.one(i, body_);
            one.set_error(error, accuracy);
            const auto last = one.reversed().first_entry(-9, 9);
            const auto first = last ? one.first_entry(-9, -last->s) : std::nullopt;
            ASSERT_EQ(chords.may.from[i] <= chords.may.to[i], first.has_value());
            if (!first)
                continue;
            ++chords_seen;
            EXPECT_NEAR(chords.may.from[i], first->s, 1e-9);
            EXPECT_NEAR(chords.may.to[i], -last->s, 1e-9);
            const auto sure = one.sure_entry(*first, -last->s);
            const auto back =
                sure ? one.reversed().sure_entry(*last, -sure->s) : std::nullopt;
            ASSERT_EQ(chords.sure.from[i] <= chords.sure.to[i], back.has_value());
            if (!back)
                continue;
            EXPECT_NEAR(chords.sure.from[i], sure->s, 1e-9);
            EXPECT_NEAR(chords.sure.to[i], -back->s, 1e-9);
            if (chords.is_whole[i] == 0)
                continue;
            ++whole;
            for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
                EXPECT_LE(rays.sampled(
                              i, std::lerp(chords.sure.from[i], chords.sure.to[i], share),
                              body_),
                          0.01);
        }
    });
    EXPECT_GT(chords_seen, 1000);
    EXPECT_GT(whole, 500);
}

// The ball of radius 3 goes down by 2 mm; rays along the axis meet the half ball at its lowest
// pose.
TEST_F(BallChords, PlungeTakesTheColumnsAboveTheBall)
{
    const ToolMotion motion{{{0, 0, 2}, Vec3::UnitZ()}, {{0, 0, 0}, Vec3::UnitZ()}};
    const BallOnRays ball{{0, 0, -5}, Vec3::UnitZ(), motion, radius};
    EightPlaces movements{};
    for (std::size_t i = 0; i < 8; ++i)
        movements[0][i] = 0.45 * static_cast<double>(i);
    const EightChords chords =
        chords_between(0, 20, ball, moved_rays(ball, movements), 0);
    for (std::size_t i = 0; i < 8; ++i) {
        const double x = movements[0][i];
        if (x >= radius) {
            EXPECT_GT(chords.may.from[i], chords.may.to[i]);
            continue;
        }
        const double lowest = 5 + radius - std::sqrt(radius * radius - x * x);
        EXPECT_NEAR(chords.may.from[i], lowest, 1e-5);
        EXPECT_EQ(chords.may.to[i], 20);
        EXPECT_NEAR(chords.sure.from[i], lowest, 1e-5);
        EXPECT_EQ(chords.sure.to[i], 20);
    }
}

TEST_F(BallChords, NothingIsRemovedOutside)
{
    for_random_rays(
        [&](const RandomRays& rays, const BallOnRays& ball, const EightRays& seen) {
            const double error = largest_error(rays);
            const EightChords chords = chords_between(-9, 9, ball, seen, error);
            for (std::size_t i = 0; i < 8; i += 3)
                for (int k = 0; k <= 36; ++k) {
                    const double s = -9 + 0.5 * k;
                    if (s < chords.may.from[i] || s > chords.may.to[i]) {
                        EXPECT_GT(rays.sampled(i, s, body_), 0);
                    }
                }
        });
}

}  // namespace
}  // namespace endmill
