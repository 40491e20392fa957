// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/detail/field_passes.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "endmill/machine/kinematics.h"
#include "endmill/orientation/detail/oriented_surface.h"

namespace endmill {
namespace {

// A dome z = -(x^2 + y^2) / 80 over [-15, 15] x [-10, 10].
Surface dome()
{
    std::vector<Vec3> net;
    for (const double j : {-1.0, 0.0, 1.0})
        for (const double i : {-1.0, 0.0, 1.0})
            net.emplace_back(15 * i, 10 * j,
                             -(225 * (i == 0 ? -1 : 1) + 100 * (j == 0 ? -1 : 1)) / 80.0);
    return Surface{{0, 1}, {0, 1}, {BezierPatch{2, 2, net}}};
}

// At all rows, and halfway between them, tool and axis keep the rules by tests of their own.
TEST(TurnByField, KeepsRangesGapAndStripAtAllRows)
{
    const std::vector<Surface> surfaces{dome()};
    const std::vector<double> sides{1};
    const ToolClearance clearance{surfaces, sides, 0.0025};
    const ToolClearance finer{surfaces, sides, 0.0005};
    OrientedOptions options;
    options.mode = AxisMode::Field;
    options.field.lead = {Angle::degrees(-5), Angle::degrees(20)};
    options.field.tilt = {Angle::degrees(-12), Angle::degrees(12)};
    for (const Cutter& cutter : {Cutter::ball(5), Cutter{5, 1}}) {
        const std::vector<OrientedSurface> oriented{
            {surfaces.front(), 1, 0, cutter, options}};
        std::vector<PassRows> passes;
        for (const PassLine& line : oriented.front().passes())
            passes.push_back({0, line, oriented.front().rows(line)});
        const std::vector<const OrientedPart*> parts{&oriented.front()};
        const double gap = turn_by_field({parts, clearance, cutter, options}, passes);
        const CuttingBody body{cutter};
        double least = 5;
        for (const PassRows& pass : passes)
            for (std::size_t k = 0; k < pass.rows.size(); ++k) {
                const PassPose& row = pass.rows[k];
                EXPECT_TRUE(is_within(options.field, row.inclination));
                EXPECT_GE(row.strip_mm,
                          oriented.front().ruled(row.place, pass.line).needed_strip_mm);
                const double here = finer.gap(body, frame_at(row.location), 5);
                least = std::min(least, here);
                EXPECT_GE(here, -0.0075 - 0.001);
                if (k == 0)
                    continue;
                const ToolMotion motion{pass.rows[k - 1].location, row.location};
                EXPECT_GE(finer.gap(body, motion.at(0.5), 5), -0.01 - 0.001);
            }
        EXPECT_NEAR(gap, least, 0.0025 + 0.0005 + 2e-4);
    }
}

}  // namespace
}  // namespace endmill
