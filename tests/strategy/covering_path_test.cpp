// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/covering_path.h"

#include <gtest/gtest.h>

#include "endmill/planning/planner_options.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

// A plane of 60 mm by 40 mm, and a ball whose strips of 1 mm height are 6 mm wide.
class CoveringPathOnAPlane : public testing::Test {
protected:
    CoveringPathOnAPlane()
    {
        options_.scallop_height = 1;
        options_.link.safe_height = 5;
    }

    // Straight passes along x, evenly spaced.
    LaidPasses passes(int count) const
    {
        PartSamples samples = covered_.samples(0.75, 1'000'000);
        std::vector<LaidPass> laid;
        for (int pass = 0; pass < count; ++pass) {
            const double y = 40 * (pass + 0.5) / count;
            LaidPass one;
            for (std::size_t i = 0; i < samples.size(); ++i)
                if (std::abs(samples.point(i).y() - y) < 0.4 && one.contacts.empty())
                    for (int step = 0; step <= 80; ++step)
                        one.contacts.push_back(
                            samples.contact(SurfacePoint{step / 80.0, y / 40},
                                            static_cast<std::int32_t>(i)));
            laid.push_back(std::move(one));
        }
        return {std::move(samples), std::move(laid)};
    }

    BallCutter ball_{5};
    Part part_ = std::vector<Surface>{test::plane(60, 40)};
    CoveredPart covered_{part_, ball_, {0.01, 1}};
    StrategyOptions options_;
};

TEST_F(CoveringPathOnAPlane, MakesOneMoveOfAStraightPass)
{
    const CoveringPath path = covering_path(passes(8), covered_, ball_, options_);
    EXPECT_TRUE(path.uncovered.empty());
    EXPECT_EQ(path.pieces, 8u);
    EXPECT_EQ(path.lifted_links, 0u);
    EXPECT_NEAR(path_economy(path.path).cut.contact_mm, 8 * 60, 1e-9);
}

// The ends of neighbouring passes are 5 mm apart, those of others more.
TEST_F(CoveringPathOnAPlane, LinksNeighbours)
{
    const CoveringPath path = covering_path(passes(8), covered_, ball_, options_);
    EXPECT_NEAR(path_economy(path.path).link.tip_mm, 7 * 5, 1e-9);
}

}  // namespace
}  // namespace endmill
