// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/detail/contact_strip.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/parallel.h"
#include "endmill/cutter/cutter.h"
#include "random.h"

namespace endmill {
namespace {

Vec3 random_upward(test::Random& random)
{
    return Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.2, 1)}
        .normalized();
}

TEST(NormalArc, RunsFromNormalToNormalAtEvenAngles)
{
    test::Random random{1};
    for (int k = 0; k < 20; ++k) {
        const Vec3 start = random_upward(random);
        const Vec3 end = random_upward(random);
        const NormalArc arc = arc_between(start, end);
        EXPECT_LE((arc.at(0) - start).norm(), 1e-15);
        EXPECT_LE((arc.at(1) - end).norm(), 1e-14);
        EXPECT_NEAR(arc.at(0.25).dot(start), std::cos(arc.angle / 4), 1e-14);
        EXPECT_NEAR(arc.at(0.25).dot(end), std::cos(3 * arc.angle / 4), 1e-14);
        EXPECT_NEAR(arc.at(0.7).norm(), 1, 1e-14);
    }
    EXPECT_EQ(arc_between(Vec3::UnitZ(), Vec3::UnitZ()).at(0.5), Vec3(0, 0, 1));
}

// The normal turns about the edge, to its right, until it is level.
TEST(NormalArc, OverABorderTurnsOutwardsUntilLevel)
{
    test::Random random{2};
    for (int k = 0; k < 20; ++k) {
        const Vec3 normal = random_upward(random);
        const Vec3 along = normal.cross(random_upward(random)).eval();
        const NormalArc arc = arc_over_border(normal, 3 * along);
        EXPECT_NEAR(arc.at(1).z(), 0, 1e-15);
        EXPECT_GT(arc.at(0.99).z(), 0);
        EXPECT_NEAR(arc.at(0.4).dot(along), 0, 1e-14);
        EXPECT_GT(normal.cross(arc.at(0.1)).dot(along), 0);
        EXPECT_LT(arc.angle, std::numbers::pi);
    }
    // The part's plane z = 0 lies north of an edge that runs east.
    EXPECT_LE(
        (arc_over_border(Vec3::UnitZ(), Vec3::UnitX()).at(1) + Vec3::UnitY()).norm(),
        1e-15);
}

// Between neighbouring shares every point of the reference point's curve is near its
// chord. Some arcs pass the axis on either side, near it and far from it.
TEST(ArcShares, KeepTheChordError)
{
    constexpr double tolerance = 1e-3;
    for (const Cutter& cutter : {Cutter::ball(10), Cutter{10, 3}, Cutter::flat(10)})
        for (const double aside : {0.3, 0.02, -0.1}) {
            const NormalArc arc = arc_between(Vec3{-0.5, aside, 0.8}.normalized(),
                                              Vec3{0.9, aside, 0.3}.normalized());
            const auto shares = arc_shares(arc, cutter, tolerance);
            EXPECT_EQ(shares.front(), 0);
            EXPECT_EQ(shares.back(), 1);
            for (std::size_t k = 1; k < shares.size(); ++k) {
                EXPECT_LT(shares[k - 1], shares[k]);
                const auto at = [&](double share) {
                    return control_offset(
                        cutter, arc.at(std::lerp(shares[k - 1], shares[k], share)));
                };
                const Vec3 from = at(0);
                const Vec3 along = (at(1) - from).normalized();
                for (const double share : {0.2, 0.35, 0.5, 0.8}) {
                    const Vec3 off = at(share) - from;
                    EXPECT_LE((off - off.dot(along) * along).norm(), tolerance * 1.01);
                }
            }
        }
}

TEST(ArcShares, AreAsFewAsAnArcOfTheRadiusNeeds)
{
    const NormalArc arc = arc_between(Vec3::UnitZ(), Vec3::UnitX());
    // The steps are 2 acos(1 - 1e-4) = 0.02828 rad.
    EXPECT_EQ(arc_shares(arc, Cutter::ball(10), 1e-3).size(), 57U);
    EXPECT_EQ(arc_shares(arc, Cutter::ball(10), 100).size(), 2U);
}

// The arc passes through the axis: a chord crosses the disc at once, and the division
// ends.
TEST(ArcShares, EndWhereTheArcPassesTheAxis)
{
    const NormalArc arc = arc_between(Vec3{-0.6, 0, 0.8}, Vec3{0.6, 0, 0.8});
    const auto shares = arc_shares(arc, Cutter::flat(10), 1e-3);
    EXPECT_LT(shares.size(), 100U);
    const NormalArc past = arc_between(Vec3{-0.6, 0, 0.8}, Vec3{0.28, 0, 0.96});
    EXPECT_LT(arc_shares(past, Cutter{10, 3}, 1e-3).size(), 200U);
}

// Equal steps for a ball; smaller ones for a bull-nose cutter where chains pass the axis.
TEST(CornerShares, AreDenserBesideTheAxis)
{
    const Vec3 normal = Vec3{-0.6, 0, 0.8};
    const NormalArc level = arc_between(Vec3{0.28, 0.96, 0}, Vec3{0.96, -0.28, 0});
    const auto ball = corner_shares(level, normal, {Cutter::ball(10), 1e-3}, 1);
    EXPECT_EQ(ball.size(), std::ceil(level.angle / (2 * std::acos(1 - 1e-4))) + 1);
    EXPECT_EQ(corner_shares(level, normal, {Cutter::flat(10), 1e-3}, 1), ball);
    EXPECT_EQ(corner_shares(level, Vec3::UnitZ(), {Cutter{10, 3}, 1e-3}, 1), ball);
    EXPECT_EQ(corner_shares(level, normal, {Cutter::ball(10), 1e-3}, 90).size(), 91U);
    const auto bull = corner_shares(level, normal, {Cutter{10, 3}, 1e-3}, 1);
    EXPECT_GT(bull.size(), ball.size());
    const auto passing = std::ranges::min_element(bull, {}, [&](double share) {
        return std::abs(normal.cross(level.at(share)).z());
    });
    EXPECT_LT(passing[1] - passing[0], ball[1] / 4);
}

OffsetDraft draft_with(const Vec3& point, const std::vector<Vec3>& normals)
{
    OffsetDraft draft{Cutter::ball(2), 1e-2, 1000};
    for (const Vec3& normal : normals)
        draft.add(point, {{0, 0}, normal, 0, ContactKind::Face});
    return draft;
}

TEST(OffsetDraft, ChainsKeepTheirContactPoint)
{
    const Vec3 point{1, 2, 3};
    OffsetDraft draft = draft_with(point, {Vec3::UnitZ(), Vec3::UnitX()});
    const NormalArc arc = arc_between(Vec3::UnitZ(), Vec3::UnitX());
    const ContactChain closed = draft.add_chain(0, arc, ContactKind::ConvexCrease, 1);
    EXPECT_EQ(closed.vertices.back(), 1);
    const ContactChain open = draft.add_chain(0, arc, ContactKind::Border);
    EXPECT_EQ(draft.contacts[open.vertices.back()].normal, Vec3::UnitX());
    EXPECT_EQ(open.vertices.size(), closed.vertices.size());
    for (std::size_t k = 0; k < draft.points.size(); ++k) {
        const auto vertex = static_cast<std::int32_t>(k);
        EXPECT_LE((draft.contact_point(vertex) - point).norm(), 1e-14);
        EXPECT_NEAR((draft.points[k] - point).norm(), 2, 1e-14);
    }
}

// Strips between chains of any lengths, on a sphere: the triangles face outwards and
// cover the region between the chains once.
TEST(OffsetDraft, StripsCoverTheGap)
{
    OffsetDraft draft = draft_with(Vec3::Zero(), {Vec3::UnitZ()});
    const Vec3 west = -Vec3::UnitX();
    const Vec3 south_west = Vec3{-1, -1, 0}.normalized();
    const ContactChain right =
        draft.add_chain(0, arc_between(Vec3::UnitZ(), west), ContactKind::Border);
    draft.arc_tolerance = 1e-3;
    const ContactChain left =
        draft.add_chain(0, arc_between(Vec3::UnitZ(), south_west), ContactKind::Border);
    draft.add_strip(right, left);
    EXPECT_EQ(draft.triangles.size(), right.vertices.size() + left.vertices.size() - 3);
    double solid = 0;  // six times the volume up to the middle
    for (const auto& [a, b, c] : draft.triangles)
        solid += draft.points[a].cross(draft.points[b]).dot(draft.points[c]);
    EXPECT_GT(solid, 0);
    const std::size_t count = draft.triangles.size();
    draft.add_strip(ContactChain::of(0), ContactChain::of(0));
    EXPECT_EQ(draft.triangles.size(), count);
}

// Chains and strips that are made together, on any number of threads, equal those made
// one by one.
TEST(OffsetDraft, ManyStripsAtOnceEqualOneByOne)
{
    test::Random random{8};
    std::vector<Vec3> normals;
    for (int k = 0; k < 40; ++k)
        normals.push_back(random_upward(random));
    std::vector<ChainPlan> chain_plans;
    std::vector<StripPlan> strip_plans;
    for (std::int32_t k = 0; k < 40; ++k) {
        const Vec3 level = Vec3{normals[k].y(), -normals[k].x(), 0}.normalized();
        chain_plans.push_back({k, arc_over_border(normals[k], level)});
        strip_plans.push_back({static_cast<std::size_t>(k), (k + 7UL) % 40});
    }
    OffsetDraft one_by_one = draft_with({1, 2, 3}, normals);
    std::vector<ContactChain> chains;
    for (const auto& [from, arc] : chain_plans)
        chains.push_back(one_by_one.add_chain(from, arc, ContactKind::Border));
    for (const auto& [right, left] : strip_plans)
        one_by_one.add_strip(chains[right], chains[left]);
    for (const int threads : {1, 4}) {
        set_thread_count(threads);
        OffsetDraft at_once = draft_with({1, 2, 3}, normals);
        const auto found = at_once.add_chains(chain_plans, ContactKind::Border);
        at_once.add_strips(found, strip_plans);
        EXPECT_EQ(at_once.points, one_by_one.points);
        EXPECT_EQ(at_once.triangles, one_by_one.triangles);
        ASSERT_EQ(found.size(), chains.size());
        for (std::size_t k = 0; k < found.size(); ++k) {
            EXPECT_EQ(found[k].vertices, chains[k].vertices);
            EXPECT_EQ(found[k].shares, chains[k].shares);
        }
        for (std::size_t k = 0; k < at_once.contacts.size(); ++k) {
            EXPECT_EQ(at_once.contacts[k].normal, one_by_one.contacts[k].normal);
            EXPECT_EQ(at_once.contacts[k].kind, one_by_one.contacts[k].kind);
        }
    }
}

}  // namespace
}  // namespace endmill
