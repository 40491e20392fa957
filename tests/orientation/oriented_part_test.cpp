// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/detail/oriented_part.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/cutter/cutting_body.h"

namespace endmill {
namespace {

// One pass along the parabola z = -x^2 / 80 over [-10, 10], on a cylinder along y.
class OnePass : public OrientedPart {
public:
    OnePass(const Cutter& cutter, const OrientedOptions& options)
        : OrientedPart{cutter, options, 100}
    {
    }

    std::vector<PassLine> passes() const override { return {{0}}; }
    PassPlace place(double along, const PassLine&) const override
    {
        const Vec3 feed = Vec3{1, 0, -along / 40}.normalized();
        PassPlace place{
            {along,
             0,
             {{along, 0, -along * along / 80}, Vec3{along / 40, 0, 1}.normalized()}}};
        place.feed = feed;
        place.curvature.along = 1 / (40 * std::pow(1 + along * along / 1600, 1.5));
        place.across = 1;
        place.along = along;
        return place;
    }
    std::string name_of(const PassPlace&) const override { return "a place"; }

private:
    std::vector<double> fixed_rows(const PassLine&) const override { return {-10, 10}; }
    double needed_strip(const PassPlace&, const PassLine&) const override { return 2; }
};

// Between neighbouring rows the cutter is near the contacts between them, tested densely.
TEST(OrientedPart, HasRowsUntilTheMotionKeepsItsTolerances)
{
    OrientedOptions options;
    options.inner_tolerance = 0.004;
    options.scallop_height = 0.05;
    for (const Cutter& cutter : {Cutter::ball(3), Cutter{3, 1}}) {
        const OnePass part{cutter, options};
        const auto rows = part.rows({0});
        EXPECT_EQ(rows.front().place.along, -10);
        EXPECT_EQ(rows.back().place.along, 10);
        const CuttingBody body{cutter};
        for (std::size_t k = 1; k < rows.size(); ++k) {
            EXPECT_LE(contact_way(rows[k - 1], rows[k]), 3);
            const ToolMotion motion{rows[k - 1].location, rows[k].location};
            for (int j = 1; j < 20; ++j) {
                const double along =
                    std::lerp(rows[k - 1].place.along, rows[k].place.along, j / 20.0);
                double least = 1;
                for (int i = 0; i <= 40; ++i)
                    least = std::min(
                        least,
                        body.distance(motion.seen(part.place(along, {0}).at.contact.point,
                                                  i / 40.0))
                            .value);
                EXPECT_GT(least, -0.0025);
                EXPECT_LT(least, 0.0035);
            }
        }
    }
}

TEST(OrientedPart, AsksForTheStripThatThePassNeedsUnlessNoneIsSoWide)
{
    OrientedOptions options;
    options.inclination.lead = Angle::degrees(10);
    const Cutter bull{3, 1};
    const OnePass part{bull, options};
    const PassPlace place = part.place(2, {0});
    const RuledContact ruled = part.ruled(place, {0});
    EXPECT_NEAR(ruled.needed_strip_mm, 2, 1e-6);
    // the heel on the bowl of radius 100: asin(2 / 99), and one degree more
    EXPECT_NEAR(part.rear_lead().degrees(), std::asin(2.0 / 99) * 180 / std::acos(-1.0),
                1e-9);
    const auto fitting = part.fitting_inclination(place);
    ASSERT_TRUE(fitting);
    EXPECT_NEAR(fitting->lead.degrees(), 10, 1e-12);
}

}  // namespace
}  // namespace endmill
