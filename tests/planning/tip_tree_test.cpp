// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/tip_tree.h"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

// The squared distances to the nearest groups, by trying all tips.
std::vector<double> by_trying_all(const std::vector<Vec3>& places,
                                  const std::vector<unsigned>& groups,
                                  const std::vector<bool>& removed, const Vec3& place,
                                  std::size_t count)
{
    std::map<unsigned, double> of_group;
    for (std::size_t tip = 0; tip < places.size(); ++tip) {
        if (removed[tip])
            continue;
        const double distance = (places[tip] - place).squaredNorm();
        const auto known = of_group.emplace(groups[tip], distance).first;
        known->second = std::min(known->second, distance);
    }
    std::vector<double> distances;
    distances.reserve(of_group.size());
    for (const auto& [group, distance] : of_group)
        distances.push_back(distance);
    std::ranges::sort(distances);
    distances.resize(std::min(count, distances.size()));
    return distances;
}

TEST(TipTree, FindsTheNearestGroupsAlsoAfterRemovals)
{
    test::Random random{1};
    for (int round = 0; round < 20; ++round) {
        const std::size_t count = 1 + 17 * std::size_t(round);
        std::vector<Vec3> places;
        std::vector<unsigned> groups;
        for (std::size_t k = 0; k < count; ++k) {
            // Coarse coordinates give equal tips.
            places.push_back({std::floor(random.uniform(0, 12)), random.uniform(0, 10),
                              std::floor(random.uniform(0, 3))});
            groups.push_back(unsigned(random.uniform(0, double(count) / 2)));
        }
        const TipTree complete{places, groups};
        TipTree tree = complete;
        std::vector<bool> removed(count);
        for (int step = 0; step < 60; ++step) {
            const Vec3 place{random.uniform(-3, 15), random.uniform(-3, 13), 1};
            const std::size_t wanted = 1 + std::size_t(step) % 12;
            std::vector<double> distances;
            for (const TipTree::Neighbour& found : tree.nearest(place, wanted)) {
                EXPECT_FALSE(removed[found.tip]);
                EXPECT_EQ(found.distance_squared,
                          (places[found.tip] - place).squaredNorm());
                distances.push_back(found.distance_squared);
            }
            EXPECT_EQ(distances, by_trying_all(places, groups, removed, place, wanted));
            const auto tip = unsigned(random.uniform(0, double(count)));
            tree.remove(tip);
            removed[tip] = true;
            if (step == 40) {
                tree = complete;
                removed.assign(count, false);
            }
        }
    }
}

TEST(TipTree, OfNoTipsFindsNone)
{
    EXPECT_TRUE(TipTree({}, {}).nearest(Vec3::Zero(), 3).empty());
    const std::vector<Vec3> places(1, Vec3::Zero());
    const std::vector<unsigned> groups(1);
    TipTree tree{places, groups};
    EXPECT_TRUE(tree.nearest(Vec3::Zero(), 0).empty());
    EXPECT_EQ(tree.nearest(Vec3::Zero(), 3).size(), 1U);
    tree.remove(0);
    EXPECT_TRUE(tree.nearest(Vec3::Zero(), 3).empty());
}

}  // namespace
}  // namespace endmill
