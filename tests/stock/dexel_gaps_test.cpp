// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/dexel_gaps.h"

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

constexpr std::int32_t units = 1000;

// Chords about a place that wanders along the rays, as those of neighbouring moves. Some are
// empty, some are in doubt as a whole, some are far away.
EightWholeChords random_chords(test::Random& random, double place)
{
    EightWholeChords chords{};
    for (std::size_t i = 0; i < 8; ++i) {
        const double kind = random.uniform(0, 1);
        const double middle = kind < 0.05 ? random.uniform(0, units) : place;
        const double half = kind > 0.95 ? 0 : random.uniform(1, 60);
        const auto limited = [](double end) {
            return std::clamp(static_cast<std::int32_t>(end), 0, units);
        };
        chords.may.from[i] = limited(middle - half);
        chords.may.to[i] = limited(middle + half);
        chords.sure.from[i] = limited(middle - half + random.uniform(0, 4));
        chords.sure.to[i] = limited(middle + half - random.uniform(0, 4));
        if (kind > 0.9)
            chords.sure.to[i] = chords.sure.from[i];
    }
    return chords;
}

struct Rays {
    std::size_t columns;
    std::size_t rows;

    std::vector<Dexel> full() const
    {
        return {columns * rows, Dexel{{{0, units}}, {{0, units}}}};
    }
};

// Cuts the same chords through the sets alone.
DexelCut cut_sets(std::vector<Dexel>& dexels, const Rays& rays,
                  std::span<const EightWholeChords> chords)
{
    DexelCut done;
    for (std::size_t ray = 0; ray < dexels.size(); ++ray) {
        const EightWholeChords& of = chords[chords.size() > 1 ? ray / rays.columns : 0];
        const std::size_t i = ray % rays.columns;
        if (of.may.from[i] < of.may.to[i])
            done.add(cut_dexel(dexels[ray], {{of.may.from[i], of.may.to[i]},
                                             {of.sure.from[i], of.sure.to[i]}}));
    }
    return done;
}

class DexelGapsOfTiles : public testing::TestWithParam<Rays> {};

TEST_P(DexelGapsOfTiles, CutAsTheSetsDo)
{
    const Rays rays = GetParam();
    test::Random random{7};
    for (int number = 0; number < 40; ++number) {
        std::vector<Dexel> by_gaps = rays.full();
        std::vector<Dexel> by_sets = rays.full();
        DexelGaps gaps{rays.columns, rays.rows, units};
        double place = random.uniform(0, units);
        for (int k = 0; k < 60; ++k) {
            place += random.uniform(-20, 30);
            std::vector<EightWholeChords> chords;
            for (std::size_t row = 0; row < (k % 3 == 0 ? 1 : rays.rows); ++row)
                chords.push_back(random_chords(random, place));
            const DexelCut cut = gaps.cut(by_gaps, chords);
            const DexelCut expected = cut_sets(by_sets, rays, chords);
            ASSERT_EQ(cut.removed, expected.removed);
            ASSERT_EQ(cut.deepest, expected.deepest);
            ASSERT_EQ(cut.most_deep, expected.most_deep);
            if (k % 17 != 16)
                continue;
            gaps.store(by_gaps);
            for (std::size_t ray = 0; ray < by_gaps.size(); ++ray) {
                ASSERT_EQ(by_gaps[ray].upper, by_sets[ray].upper);
                ASSERT_EQ(by_gaps[ray].lower, by_sets[ray].lower);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(WholeAndAtTheBorder, DexelGapsOfTiles,
                         testing::Values(Rays{8, 8}, Rays{3, 8}, Rays{8, 2}, Rays{1, 1}));

TEST(DexelGaps, ContainOnlyWhatIsFreeOnAllRays)
{
    const Rays rays{8, 2};
    std::vector<Dexel> dexels = rays.full();
    DexelGaps gaps{rays.columns, rays.rows, units};
    EXPECT_FALSE(gaps.contains({400, 500}));
    EXPECT_TRUE(gaps.contains({400, 400}));
    EightWholeChords chords{};
    for (std::size_t i = 0; i < 8; ++i) {
        const auto shift = static_cast<std::int32_t>(i);
        for (EightIntervals* of : {&chords.may, &chords.sure}) {
            of->from[i] = 300 + shift;
            of->to[i] = 600 + shift;
        }
    }
    // The first chords go through the sets, the same ones again through the gaps.
    gaps.cut(dexels, {&chords, 1});
    EXPECT_EQ(gaps.cut(dexels, {&chords, 1}).removed, 0);
    EXPECT_TRUE(gaps.contains({307, 600}));
    EXPECT_FALSE(gaps.contains({306, 600}));
    EXPECT_FALSE(gaps.contains({307, 601}));
}

}  // namespace
}  // namespace endmill
