// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/machine/configuration.h"

#include <algorithm>
#include <array>
#include <set>

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "endmill/core/error.h"
#include "endmill/core/vec.h"

namespace endmill {
namespace {

Vec3 direction(const MachineConfiguration& machine, double first, double second)
{
    const auto turn = [&](std::size_t k, double angle) {
        return Eigen::AngleAxisd{angle, Vec3::Unit(machine.rotary[k].letter - 'a')};
    };
    return turn(0, first) * (turn(1, second) * Vec3::UnitZ());
}

// The rank of the derivative of the direction by both turns, at generic turns.
int rank_of(const MachineConfiguration& machine)
{
    constexpr double first = 0.4;
    constexpr double second = 0.7;
    constexpr double step = 1e-6;
    Eigen::Matrix<double, 3, 2> derivative;
    derivative.col(0) = direction(machine, first + step, second) -
                        direction(machine, first - step, second);
    derivative.col(1) = direction(machine, first, second + step) -
                        direction(machine, first, second - step);
    const Eigen::Vector2d values =
        Eigen::JacobiSVD<Eigen::MatrixXd>{derivative / (2 * step)}.singularValues();
    return static_cast<int>((values.array() > 1e-3).count());
}

TEST(RotaryWords, AreEighteenOfTheRankThatTheirDerivativeHas)
{
    const auto words = rotary_words();
    EXPECT_EQ(std::set<std::string>(words.begin(), words.end()).size(), 18U);
    int valid = 0;
    for (const std::string& word : words) {
        const MachineConfiguration machine = configuration_from_word(whole_word(word));
        EXPECT_EQ(machine.rank, rank_of(machine)) << word;
        EXPECT_EQ(machine.is_valid(), machine.family.has_value()) << word;
        valid += machine.is_valid() ? 1 : 0;
    }
    EXPECT_EQ(valid, 12);
    EXPECT_EQ(words.front(), "abB");
    EXPECT_EQ(words.back(), "Bbc");
    EXPECT_EQ(whole_word("caB"), "W/caBxyz/T");
    EXPECT_THROW(whole_word("cca"), DomainError);
}

// The printed counts: 162 kinds, 18 words, 12 with two degrees of freedom, 2 shapes.
// Source: [KangSuh, section 3].
TEST(RotaryWords, AreCountedAsThePaperDoes)
{
    const WordCounts counts = count_words();
    EXPECT_EQ(counts.words, 2160U);  // 3 pairs, 6! orders
    EXPECT_EQ(counts.relative_motions, 162U);
    EXPECT_EQ(counts.rotary_words, 18U);
    EXPECT_EQ(counts.valid, 12U);
    EXPECT_EQ(counts.families, 2U);
}

// 162 without enumeration: an ordered pair of rotary axes, and each of x, y, z before,
// between or after them.
TEST(RotaryWords, RelativeMotionsAreAPairAndThreePlaces)
{
    constexpr std::size_t ordered_pairs = 3 * 2;
    constexpr std::size_t places = 3;
    EXPECT_EQ(count_words().relative_motions, ordered_pairs * places * places * places);
}

}  // namespace
}  // namespace endmill
