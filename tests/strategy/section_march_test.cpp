// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/section_march.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "test_surfaces.h"

namespace endmill {
namespace {

std::vector<LaidPass> passes_of(Coverage& coverage, Angle direction)
{
    return SectionMarch{coverage, direction, 1e-6, SectionContacts::OnSurface}.passes();
}

bool is_covered(const Coverage& coverage)
{
    return std::ranges::all_of(coverage.gaps(), [](double gap) { return gap <= 1e-6; });
}

// A ball of 5 mm covers 3 mm on each side at a height of 1 mm: h (2R - h) = 9. The first
// pass lies 3 mm from the border and the next 6 mm further, by Pythagoras.
TEST(SectionMarch, LaysPassesAStripApartOnAPlane)
{
    const std::vector<Surface> surfaces{test::plane(20, 40)};
    const std::vector<double> sides{1};
    const PartSamples samples{surfaces, sides, 0.75, 100'000};
    Coverage coverage{samples, BallCutter{5}, 1};
    const std::vector<LaidPass> passes = passes_of(coverage, Angle::degrees(0));
    ASSERT_EQ(passes.size(), 7u);
    for (std::size_t k = 0; k + 1 < passes.size(); ++k)
        for (const PassContact& contact : passes[k].contacts) {
            EXPECT_NEAR(contact.at.contact.point.y(), 3 + 6 * static_cast<double>(k),
                        0.02 * double(k + 1));
            EXPECT_LE(contact.at.contact.point.y(), 3 + 6 * double(k) + 1e-4);
        }
    EXPECT_TRUE(is_covered(coverage));
}

// Along x, the section of y^2 = z would be wider apart than on a plane where it is convex.
TEST(SectionMarch, KeepsContactsInThePlanesOfTheDirection)
{
    const std::vector<Surface> surfaces{test::saddle(60, 25)};
    const std::vector<double> sides{1};
    const PartSamples samples{surfaces, sides, 0.5, 100'000};
    Coverage coverage{samples, BallCutter{4}, 0.3};
    const double angle = 0.6;
    const std::vector<LaidPass> passes = passes_of(coverage, Angle::radians(angle));
    double before = -1e9;
    for (const LaidPass& pass : passes) {
        const auto offset = [&](const PassContact& contact) {
            const Vec3& point = contact.at.contact.point;
            return point.y() * std::cos(angle) - point.x() * std::sin(angle);
        };
        const double own = offset(pass.contacts.front());
        for (const PassContact& contact : pass.contacts)
            EXPECT_NEAR(offset(contact), own, 1e-4);
        EXPECT_GE(own, before - 1e-4);
        before = own;
    }
    const auto covered =
        std::ranges::count_if(coverage.gaps(), [](double gap) { return gap <= 0.003; });
    EXPECT_EQ(covered, static_cast<std::ptrdiff_t>(samples.size()));
}

// Two parts that do not begin at the same offset.
TEST(SectionMarch, CoversPartsThatBeginLater)
{
    const std::vector<Surface> surfaces{
        test::plane(20, 10), test::graph(test::monomial(0, 0, 0), {{30, 50}, {7, 33}})};
    const std::vector<double> sides{1, 1};
    const PartSamples samples{surfaces, sides, 0.75, 100'000};
    Coverage coverage{samples, BallCutter{5}, 1};
    passes_of(coverage, Angle::degrees(0));
    EXPECT_TRUE(is_covered(coverage));
}

TEST(PassLengths, AreThoseOfContactsAndTips)
{
    const std::vector<Surface> surfaces{test::plane(20, 10)};
    const std::vector<double> sides{1};
    const PartSamples samples{surfaces, sides, 20, 100};
    LaidPass pass;
    pass.contacts = {samples.contact({0, 0, 0}), samples.contact({0, 0, 0})};
    pass.contacts[0].at.contact = {{0, 0, 0}, {0, 0, 1}};
    pass.contacts[1].at.contact = {{3, 4, 0}, {1, 0, 0}};
    const PassLengths lengths = pass_lengths(std::vector{pass}, 2);
    EXPECT_DOUBLE_EQ(lengths.contact_mm, 5);
    EXPECT_DOUBLE_EQ(lengths.tip_mm, std::sqrt(25 + 16 + 4.0));
}

}  // namespace
}  // namespace endmill
