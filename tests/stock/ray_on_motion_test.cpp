// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/ray_on_motion.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

Vec3 random_place(test::Random& random, double size)
{
    return {random.uniform(-size, size), random.uniform(-size, size),
            random.uniform(-size, size)};
}

struct RandomCase {
    explicit RandomCase(test::Random& random)
    {
        const CutterLocation from{random_place(random, 2),
                                  (Vec3{0, 0, 2} + random_place(random, 1)).normalized()};
        motion = ToolMotion{from,
                            {from.tip + random_place(random, 1),
                             (from.axis + random_place(random, 0.2)).normalized()}};
        start = random_place(random, 8);
        direction = random_place(random, 1).normalized();
    }

    // The least signed distance over many poses.
    double sampled(double s, const CuttingBody& body) const
    {
        double least = 1e9;
        for (int k = 0; k <= 64; ++k)
            least = std::min(
                least, body.distance(motion.seen(start + s * direction, k / 64.0)).value);
        return least;
    }

    ToolMotion motion{{{0, 0, 0}, {0, 0, 1}}, {{0, 0, 0}, {0, 0, 1}}};
    Vec3 start;
    Vec3 direction;
};

const CuttingBody bodies[] = {CuttingBody{Cutter::ball(3)}, CuttingBody{Cutter::flat(3)},
                              CuttingBody{Cutter{3, 1}, 6}};

TEST(RayOnMotion, DistanceIsWithinItsError)
{
    test::Random random{1};
    for (const CuttingBody& body : bodies)
        for (int i = 0; i < 500; ++i) {
            const RandomCase one{random};
            const RayOnMotion on{one.start, one.direction, one.motion, body};
            const double s = random.uniform(-5, 5);
            const RayOnMotion::Distance found = on.distance(s);
            EXPECT_LE(found.gap(), one.sampled(s, body));
            // Samples of the poses exceed the least distance by little.
            EXPECT_GE(found.least.value + found.error, one.sampled(s, body) - 0.01);
        }
}

TEST(RayOnMotion, NothingIsRemovedBeforeTheFirstEntry)
{
    test::Random random{2};
    int found_entries = 0;
    for (const CuttingBody& body : bodies)
        for (int i = 0; i < 1000; ++i) {
            const RandomCase one{random};
            const RayOnMotion on{one.start, one.direction, one.motion, body};
            const auto entry = on.first_entry(0, 20);
            if (entry && entry->s == 0) {
                // The line begins in the cutter, or F is at most the error e there; the
                // true distance is then at most 2 e. Samples exceed it by little.
                EXPECT_LE(one.sampled(0, body), 2 * on.distance(0).error + 0.01);
                continue;
            }
            EXPECT_GT(one.sampled(0, body), -1e-9);
            const double end = entry ? entry->s : 20;
            for (int k = 0; k < 50; ++k)
                EXPECT_GT(one.sampled(end * k / 50.0, body), -1e-9);
            if (!entry)
                continue;
            ++found_entries;
            if (const auto sure = on.sure_entry(*entry, 20)) {
                EXPECT_LE(one.sampled(sure->s, body), 0.01);
                EXPECT_GE(sure->s, entry->s);
            }
        }
    EXPECT_GT(found_entries, 200);
}

TEST(RayOnMotion, NothingIsRemovedOutsideTheNearStretch)
{
    test::Random random{4};
    int found = 0;
    for (const CuttingBody& body : bodies)
        for (int i = 0; i < 1000; ++i) {
            const RandomCase one{random};
            const RayOnMotion on{one.start, one.direction, one.motion, body};
            const auto near = on.near_stretch(-6, 14);
            found += near ? 1 : 0;
            for (int k = 0; k <= 40; ++k) {
                const double s = -6 + 0.5 * k;
                if (!near || s < near->from || s > near->to) {
                    EXPECT_GT(one.sampled(s, body), 0);
                }
                EXPECT_LE(on.error(s), std::max(on.error(-6), on.error(14)));
            }
        }
    EXPECT_GT(found, 500);
}

TEST(RayOnMotion, ReversedLineHasTheSameDistances)
{
    test::Random random{3};
    for (int i = 0; i < 100; ++i) {
        const RandomCase one{random};
        const RayOnMotion on{one.start, one.direction, one.motion, bodies[1]};
        const double s = random.uniform(-5, 5);
        EXPECT_NEAR(on.distance(s).least.value, on.reversed().distance(-s).least.value,
                    1e-7);
    }
}

}  // namespace
}  // namespace endmill
